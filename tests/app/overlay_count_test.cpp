// The metrics of runs that are laid over the open one.

#include "app/examples.h"
#include "app/overlay_count.h"
#include "app/resources.h"
#include "engine/recording/session_store.h"
#include "tests/support/wait_for.h"
#include "widgets/review/replay_view.h"

#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

class OverlayCountTest : public testing::Test {
protected:
    OverlayCountTest() {
        initResources();
        view.setRun(run("open.bask"));
    }
    /// A short run that stays at its targets.
    std::shared_ptr<RecordedSession> run(const char* name, int samples = 20) {
        const std::string path = folder.filePath(QString::fromLatin1(name)).toStdString();
        const Experiment experiment = readExample(QStringLiteral("two-circles")).value();
        auto writer = SessionWriter::create(path, experiment, true, 1e6, SessionWriter::Earlier::Replaced);
        for (int k = 0; k < samples; ++k) {
            TraceSample sample;
            sample.time_s = k;
            sample.coordinates = experiment.start;
            for (const ObjectSpec& object : experiment.objects) {
                ObjectSample row;
                row.measured_K = row.estimated_K = row.true_K = row.target_K = object.target_K;
                sample.objects.push_back(row);
            }
            EXPECT_TRUE((*writer)->add(sample));
        }
        EXPECT_TRUE((*writer)->finish("settled"));
        writer->reset();
        return RecordedSession::open(path).value();
    }
    QString path(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
    /// The last row of the table: of a run that was counted no dash.
    QString last(int column) const {
        const auto* table = view.findChild<QTableWidget*>("comparisonTable");
        return table->item(table->rowCount() - 1, column)->text();
    }

    QTemporaryDir folder;
    ReplayView view;
    OverlayCount count{view};
};

} // namespace

// Catches: an overlay that is never counted, or only the one that was added last.
TEST_F(OverlayCountTest, EachOverlayIsCounted) {
    ASSERT_TRUE(view.addOverlay(run("b.bask")));
    ASSERT_TRUE(view.addOverlay(run("c.bask", 30)));
    ASSERT_TRUE(waitFor([&] { return view.uncounted() == nullptr; }));
    const auto* table = view.findChild<QTableWidget*>("comparisonTable");
    const int duration = table->rowCount() - 5;
    EXPECT_EQ(table->item(duration, 1)->text(), "19.0 s");
    EXPECT_EQ(table->item(duration, 3)->text(), "29.0 s");
    EXPECT_EQ(table->item(duration, 0)->text(), QString(QChar(0x2014))) << "another counts the open one";
}

// Catches: a damaged overlay that stops the others, or that nobody is told of.
TEST_F(OverlayCountTest, ADamagedOneIsToldAndTheNextIsCounted) {
    QSignalSpy failed(&count, &OverlayCount::failed);
    const auto damaged = run("damaged.bask", 2000);
    {
        const auto store = SessionStore::create(damaged->facts().path);
        ASSERT_TRUE((*store)->execute("DELETE FROM step WHERE number = 1500"));
    }
    ASSERT_TRUE(view.addOverlay(damaged));
    ASSERT_TRUE(view.addOverlay(run("good.bask")));
    ASSERT_TRUE(waitFor([&] { return view.uncounted() == nullptr; }));
    EXPECT_EQ(failed.count(), 1);
    EXPECT_EQ(last(1), QString(QChar(0x2014)));
    EXPECT_NE(last(3), QString(QChar(0x2014)));
}

// Catches: a file that is held while it is about to be changed, and one that is forgotten afterwards.
TEST_F(OverlayCountTest, AReleasedFileIsCountedLater) {
    count.release(path("b.bask"));
    ASSERT_TRUE(view.addOverlay(run("b.bask")));
    ASSERT_TRUE(view.addOverlay(run("c.bask")));
    ASSERT_TRUE(waitFor([&] { return view.uncounted(path("b.bask")) == nullptr; }));
    ASSERT_NE(view.uncounted(), nullptr) << "it is released";
    EXPECT_EQ(view.uncounted()->facts().path, path("b.bask").toStdString());
    count.resume();
    EXPECT_TRUE(waitFor([&] { return view.uncounted() == nullptr; }));
}

// Catches: an overlay that is taken away while it is counted, and an end that waits for it.
TEST_F(OverlayCountTest, WhatIsTakenAwayIsForgotten) {
    ASSERT_TRUE(view.addOverlay(run("long.bask", 20'000)));
    view.removeOverlay(path("long.bask"));
    ASSERT_TRUE(view.addOverlay(run("b.bask")));
    ASSERT_TRUE(waitFor([&] { return view.uncounted() == nullptr; }));
    EXPECT_NE(last(1), QString(QChar(0x2014)));
    view.setRun(run("other.bask"));
    EXPECT_EQ(view.uncounted(), nullptr);
}

} // namespace bask::test
