#include "app/document.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/runtime/simulated_run.h"
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

// Catches: a verdict of old targets shown as if it belonged to the new ones.
TEST(Document, VerdictsFollowTheTargets) {
    Document document;
    document.open(Document::blank(), {});
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(200.0)}).ok());
    EXPECT_TRUE(document.verdictStale());
    EXPECT_TRUE(document.modified());
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    ASSERT_TRUE(document.verdict());
    EXPECT_FALSE(document.verdict()->feasible);
    EXPECT_NEAR(document.verdict()->conditions1.at(0).target_K, kelvinFromCelsius(200.0), 1e-9);
    EXPECT_LT(document.verdict()->nearest_K.at(0), kelvinFromCelsius(200.0));
    ASSERT_TRUE(document.setTargets(document.verdict()->nearest_K).ok());
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    EXPECT_TRUE(document.verdict()->feasible);
}

// Catches targets that are taken over while they are only dragged about, and a prediction for them.
TEST(Document, TriedTargetsAreJudgedAndNoMore) {
    Document document;
    document.open(Document::blank(), {});
    const double before_K = document.experiment().objects[0].target_K;
    document.tryTargets({kelvinFromCelsius(41.0)});
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    EXPECT_NEAR(document.verdict()->conditions1.at(0).target_K, kelvinFromCelsius(41.0), 1e-9);
    EXPECT_EQ(document.experiment().objects[0].target_K, before_K);
    EXPECT_FALSE(document.modified());
    int changes = 0;
    QObject::connect(&document, &Document::predictionChanged, [&] { ++changes; });
    document.predict();
    EXPECT_FALSE(waitFor([&] { return changes > 0; }, 300));
}

// Catches a predicted time that is not what a run takes, or one that outlives an edit of target or
// controller.
TEST(Document, PredictsHowLongARunTakes) {
    Document document;
    document.open(Document::blank(), {});
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(45.0)}).ok());
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    ASSERT_FALSE(document.predicted());
    document.predict();
    ASSERT_TRUE(waitFor([&] { return document.predicted(); }));
    const auto run = runSimulated(document.experiment(), {});
    ASSERT_TRUE(run);
    ASSERT_TRUE(run->objects[0].settlingTime_s);
    EXPECT_EQ(document.predictedSettling_s(), run->objects[0].settlingTime_s);
    ASSERT_TRUE(document.setController(document.experiment().controller).ok());
    EXPECT_FALSE(document.predicted());
    document.predict();
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(46.0)}).ok());
    EXPECT_FALSE(document.predicted());
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    EXPECT_FALSE(document.predicted());
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
