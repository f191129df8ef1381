#include "app/document.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "tests/support/wait_for.h"

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

// Catches: verdicts of old targets shown as if they belonged to the new ones.
TEST(Document, VerdictsFollowTheTargets) {
    Document document;
    document.open(Document::blank(), {});
    ASSERT_TRUE(waitFor([&] { return !document.verdictsStale(); }));
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(200.0)}).ok());
    EXPECT_TRUE(document.verdictsStale());
    EXPECT_TRUE(document.modified());
    ASSERT_TRUE(waitFor([&] { return !document.verdictsStale(); }));
    ASSERT_EQ(document.verdicts().size(), 1U);
    EXPECT_EQ(document.verdicts()[0].verdict, FeasibilityVerdict::TooHot);
    EXPECT_NEAR(document.verdicts()[0].target_K, kelvinFromCelsius(200.0), 1e-9);
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
