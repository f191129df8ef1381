#include "app/document.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <QSignalSpy>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

/// What was told of the document since.
struct Told {
    explicit Told(Document& document)
        : opened(&document, &Document::opened), edited(&document, &Document::edited),
          targets(&document, &Document::targetsChanged), controller(&document, &Document::controllerChanged),
          vision(&document, &Document::visionChanged), changed(&document, &Document::changed) {}
    /// opened, edited, targets, controller, vision, changed
    std::vector<qsizetype> counts() const {
        return {opened.count(),     edited.count(), targets.count(),
                controller.count(), vision.count(), changed.count()};
    }
    QSignalSpy opened, edited, targets, controller, vision, changed;
};

// Catches: a blank experiment that the engine would refuse.
TEST(Document, TheBlankExperimentIsValid) {
    EXPECT_TRUE(validate(Document::blank()).ok());
}

// Catches: a refused edit that leaves its traces.
TEST(Document, RefusedEditsChangeNothing) {
    Document document;
    document.open(Document::blank(), QStringLiteral("/tmp/a.json"));
    Experiment doubled = document.experiment();
    doubled.objects.push_back(doubled.objects[0]);
    const auto edited = document.edit(doubled);
    ASSERT_FALSE(edited.ok());
    EXPECT_EQ(edited.error().code(), MessageCode::DuplicateName);
    EXPECT_EQ(document.experiment(), Document::blank());
    EXPECT_FALSE(document.modified());
    EXPECT_FALSE(document.setTargets({300.0, 300.0}).ok());
    EXPECT_EQ(document.toUndo(), nullptr);
}

// Catches an undo that brings back something else, or that the engine and the pages do not hear of, or hear
// of as more than it is: a run must not be loaded anew for a target.
TEST(Document, EveryEditIsUndoneAndToldAsWhatItIs) {
    const auto edits = [](Document& document) {
        Experiment longer = document.experiment();
        longer.start[kZ] += 0.01;
        EXPECT_TRUE(document.edit(longer).ok());
        EXPECT_TRUE(document.setTargets({320.0}).ok());
        ControllerSettings gains = document.experiment().controller;
        gains.levelServo.timeConstant_s *= 2.0;
        EXPECT_TRUE(document.setController(gains).ok());
        VisionSpec vision = document.experiment().vision;
        vision.cameraPose = Vector6d::Ones();
        EXPECT_TRUE(document.setVision(vision).ok());
    };
    using Counts = std::vector<qsizetype>;
    Document document;
    document.open(Document::blank(), {});
    Told told(document);
    edits(document);
    EXPECT_EQ(told.counts(), (Counts{0, 1, 1, 1, 1, 4}));
    const Experiment after = document.experiment();
    ASSERT_NE(document.toUndo(), nullptr);
    EXPECT_EQ(document.toUndo()->edit.page, Page::Calibrate);
    document.undo();
    EXPECT_EQ(told.counts(), (Counts{0, 1, 1, 1, 2, 5}));
    EXPECT_FALSE(document.experiment().vision.cameraPose);
    document.undo();
    document.undo();
    EXPECT_EQ(told.counts(), (Counts{0, 1, 2, 2, 2, 7}));
    document.undo();
    EXPECT_EQ(document.experiment(), Document::blank());
    EXPECT_FALSE(document.modified());
    document.undo(); // nothing is left
    EXPECT_EQ(told.counts(), (Counts{0, 2, 2, 2, 2, 8}));
    for (int i = 0; i < 5; ++i)
        document.redo();
    EXPECT_EQ(document.experiment(), after);
    EXPECT_TRUE(document.modified());
    EXPECT_EQ(told.counts(), (Counts{0, 3, 3, 3, 3, 12}));
}

// Catches an edit of nothing that can be undone, or that marks the file as changed.
TEST(Document, AnEditOfNothingIsNone) {
    Document document;
    document.open(Document::blank(), QStringLiteral("/tmp/a.json"));
    const Told told(document);
    EXPECT_TRUE(document.edit(document.experiment()).ok());
    EXPECT_FALSE(document.modified());
    EXPECT_EQ(document.toUndo(), nullptr);
    EXPECT_EQ(told.changed.count(), 0);
}

// Catches edits of the experiment before that are undone into the next one.
TEST(Document, AnotherExperimentHasNoHistory) {
    Document document;
    document.open(Document::blank(), {});
    ASSERT_TRUE(document.setTargets({320.0}).ok());
    document.open(Document::blank(), {});
    EXPECT_EQ(document.toUndo(), nullptr);
    EXPECT_FALSE(document.modified());
    document.openUnsaved(Document::blank(), QStringLiteral("/tmp/a.json"));
    EXPECT_TRUE(document.modified());
    EXPECT_EQ(document.displayName(), QStringLiteral("a.json"));
    document.markSaved(QStringLiteral("/tmp/a.json"));
    EXPECT_FALSE(document.modified());
}

TEST(Document, IsNamedAfterFileOrTitle) {
    Document document;
    Experiment experiment = Document::blank();
    document.open(experiment, {});
    EXPECT_EQ(document.displayName(), QStringLiteral("Untitled"));
    experiment.title = "Two circles";
    document.open(experiment, {});
    EXPECT_EQ(document.displayName(), QStringLiteral("Two circles"));
    document.markSaved(QStringLiteral("/somewhere/mine.json"));
    EXPECT_EQ(document.displayName(), QStringLiteral("mine.json"));
}

} // namespace
} // namespace bask::test
