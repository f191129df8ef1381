#include "app/document.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>

namespace bask::test {
namespace {

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
