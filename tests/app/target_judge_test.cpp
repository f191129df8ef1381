// What the Targets page is told of an experiment's targets, with the jobs that work it out.

#include "app/document.h"
#include "app/target_judge.h"
#include "engine/base/units.h"
#include "engine/experiment/experiment_file.h"
#include "engine/runtime/simulated_run.h"
#include "tests/support/wait_for.h"

#include <QThreadPool>
#include <QTimer>

#include <gtest/gtest.h>

#include <cmath>

namespace bask::test {
namespace {

struct TargetJudgeTest : testing::Test {
    using Change = TargetJudge::Change;
    TargetJudge judge;
    Experiment experiment;

    static Experiment blank() { return Document::blank(); }
    void set(const Experiment& other) {
        experiment = other;
        judge.setExperiment(experiment, Change::All);
    }
    void setTargets(const std::vector<double>& targets_K) {
        ASSERT_TRUE(bask::setTargets(experiment, targets_K));
        judge.setExperiment(experiment, Change::Targets);
    }
};

// Catches: a verdict of old targets shown as if it belonged to the new ones.
TEST_F(TargetJudgeTest, VerdictsFollowTheTargets) {
    set(blank());
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    setTargets({kelvinFromCelsius(200.0)});
    EXPECT_TRUE(judge.isStale());
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    ASSERT_TRUE(judge.verdict());
    EXPECT_FALSE(judge.verdict()->feasible);
    EXPECT_NEAR(judge.verdict()->conditions1.at(0).target_K, kelvinFromCelsius(200.0), 1e-9);
    EXPECT_LT(judge.verdict()->nearest_K.at(0), kelvinFromCelsius(200.0));
    setTargets(judge.verdict()->nearest_K);
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    EXPECT_TRUE(judge.verdict()->feasible);
}

// Catches a verdict that counts as one on other targets for ever once a camera was calibrated.
TEST_F(TargetJudgeTest, AVerdictStaysCurrentWhatElseIsEdited) {
    set(blank());
    EXPECT_FALSE(judge.isCurrent());
    ASSERT_TRUE(waitFor([&] { return judge.isCurrent(); }));
    experiment.vision.cameraDate = "2026-11-30"; // the judge is not told
    experiment.controller.kind = ControllerKind::ModelBased;
    judge.setExperiment(experiment, Change::Controller);
    EXPECT_TRUE(judge.isCurrent());
    judge.tryTargets({kelvinFromCelsius(41.0)});
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    EXPECT_FALSE(judge.isCurrent()) << "it is on tried ones";
}

// Catches targets that are taken over while they are only dragged about, and a prediction for them.
TEST_F(TargetJudgeTest, TriedTargetsAreJudgedAndNoMore) {
    set(blank());
    const double before_K = experiment.objects[0].target_K;
    judge.tryTargets({kelvinFromCelsius(41.0)});
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    EXPECT_NEAR(judge.verdict()->conditions1.at(0).target_K, kelvinFromCelsius(41.0), 1e-9);
    EXPECT_EQ(experiment.objects[0].target_K, before_K);
    judge.tryTargets({kelvinFromCelsius(42.0)});
    judge.tryTargets({kelvinFromCelsius(43.0)}); // each after the other, but for those in between
    judge.tryTargets({kelvinFromCelsius(44.0)});
    std::vector<double> judged;
    QObject::connect(&judge, &TargetJudge::verdictChanged, [&] {
        if (!judge.isStale())
            judged.push_back(std::round(celsiusFromKelvin(judge.verdict()->conditions1.at(0).target_K)));
    });
    ASSERT_TRUE(waitFor([&] { return judged.size() == 2; }));
    EXPECT_EQ(judged, (std::vector<double>{42.0, 44.0}));
    int changes = 0;
    QObject::connect(&judge, &TargetJudge::predictionChanged, [&] { ++changes; });
    judge.predict();
    EXPECT_FALSE(waitFor([&] { return changes > 0; }, 300));
}

// Catches a predicted time that is not what a run takes, or one that outlives an edit of target or
// controller.
TEST_F(TargetJudgeTest, PredictsHowLongARunTakes) {
    set(blank());
    setTargets({kelvinFromCelsius(45.0)});
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    ASSERT_FALSE(judge.predicted());
    judge.predict();
    ASSERT_TRUE(waitFor([&] { return judge.predicted(); }));
    const auto run = runSimulated(experiment, {});
    ASSERT_TRUE(run);
    ASSERT_TRUE(run->objects[0].settlingTime_s);
    EXPECT_EQ(judge.predictedSettling_s(), run->objects[0].settlingTime_s);
    experiment.controller.kind = ControllerKind::ModelBased;
    judge.setExperiment(experiment, Change::Controller);
    EXPECT_FALSE(judge.predicted());
    judge.predict();
    ASSERT_TRUE(waitFor([&] { return judge.predicted(); })) << "no verdict is needed anew";
    const auto another = runSimulated(experiment, {});
    ASSERT_TRUE(another);
    EXPECT_EQ(judge.predictedSettling_s(), another->objects[0].settlingTime_s);
    judge.setExperiment(experiment, Change::Controller);
    judge.predict();
    setTargets({kelvinFromCelsius(46.0)});
    EXPECT_FALSE(judge.predicted());
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    EXPECT_FALSE(judge.predicted());
}

Experiment twoCircles(double first_degC, double second_degC) {
    Experiment experiment = readExperiment(BASK_EXAMPLES "/two-circles.json").value();
    experiment.objects[0].target_K = kelvinFromCelsius(first_degC);
    experiment.objects[1].target_K = kelvinFromCelsius(second_degC);
    return experiment;
}

// Catches: maps that are made although nobody sees them, that do not come when somebody does, or that follow
// targets and objects of before.
TEST_F(TargetJudgeTest, MapsOfPairsAreMadeWhileWanted) {
    int made = 0;
    QObject::connect(&judge, &TargetJudge::pairsChanged, [&] { ++made; });
    const auto settled = [&] { return !judge.isStale(); };
    set(twoCircles(40.0, 40.0));
    ASSERT_TRUE(waitFor(settled));
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(made, 0);

    judge.wantPairs(true);
    ASSERT_TRUE(waitFor([&] { return made == 1; }));
    ASSERT_EQ(judge.pairs()->size(), 1U);
    const std::vector<double> density = judge.pairs()->at(0).density;
    setTargets({kelvinFromCelsius(150.0), kelvinFromCelsius(30.0)});
    EXPECT_TRUE(judge.pairs()) << "the maps stay, but for where the targets lie";
    ASSERT_TRUE(waitFor([&] { return made == 2; }));
    EXPECT_NEAR(judge.pairs()->at(0).target_K.x(), kelvinFromCelsius(150.0), 1e-9);
    EXPECT_FALSE(judge.pairs()->at(0).targetReachable);
    EXPECT_EQ(judge.pairs()->at(0).density, density);
    Experiment warmer = experiment;
    warmer.source.temperature_K += 20.0;
    set(warmer);
    EXPECT_FALSE(judge.pairs());
    ASSERT_TRUE(waitFor([&] { return made == 3; }));
    EXPECT_NE(judge.pairs()->at(0).density, density);

    judge.wantPairs(false);
    judge.wantPairs(true); // has them
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(made, 3);
    judge.wantPairs(false);
    setTargets({kelvinFromCelsius(40.0), kelvinFromCelsius(40.0)});
    ASSERT_TRUE(waitFor(settled));
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    judge.wantPairs(true);
    judge.wantPairs(false); // looked away again
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(made, 3);
    judge.wantPairs(true);
    ASSERT_TRUE(waitFor([&] { return made == 4; }));
    EXPECT_NEAR(judge.pairs()->at(0).target_K.x(), kelvinFromCelsius(40.0), 1e-9);
}

// Catches: maps of objects before that arrive after an edit and are taken for those of the present ones.
TEST_F(TargetJudgeTest, MapsOfAnOlderExperimentAreNotHeard) {
    judge.wantPairs(true);
    std::vector<std::size_t> maps;
    QObject::connect(&judge, &TargetJudge::pairsChanged, [&] { maps.push_back(judge.pairs()->size()); });
    QObject::connect(&judge, &TargetJudge::verdictChanged, [&] {
        if (judge.isStale() || experiment.objects.size() != 2)
            return;
        QTimer::singleShot(0, &judge, [this] {
            EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000)); // made, but not heard of
            Experiment fewer = experiment;
            fewer.objects.pop_back();
            set(fewer);
        });
    });
    set(twoCircles(40.0, 40.0));
    ASSERT_TRUE(waitFor([&] { return !maps.empty(); }));
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(maps, std::vector<std::size_t>{0});
}

// Catches a verdict on dragged targets that stays when the drag is broken off.
TEST_F(TargetJudgeTest, DroppedTriesGiveTheVerdictBack) {
    set(blank());
    const double own_K = experiment.objects[0].target_K;
    const auto settled = [&] { return !judge.isStale(); };
    ASSERT_TRUE(waitFor(settled));
    judge.dropTries();
    EXPECT_TRUE(settled()) << "there was none";
    judge.tryTargets({kelvinFromCelsius(41.0)});
    ASSERT_TRUE(waitFor(settled));
    judge.dropTries();
    ASSERT_TRUE(waitFor(settled));
    EXPECT_EQ(judge.verdict()->conditions1.at(0).target_K, own_K);
}

// Catches tries that wait for ever for maps that nobody wants any more.
TEST_F(TargetJudgeTest, TriesGoOnWhenMapsAreNotWantedAnyMore) {
    set(twoCircles(40.0, 40.0));
    const auto settled = [&] { return !judge.isStale(); };
    ASSERT_TRUE(waitFor(settled));
    judge.wantPairs(true);
    QObject::connect(&judge, &TargetJudge::verdictChanged, [&] {
        if (settled()) // the maps come next
            QTimer::singleShot(0, &judge, [this] { judge.wantPairs(false); });
    });
    judge.tryTargets({kelvinFromCelsius(41.0), kelvinFromCelsius(41.0)});
    judge.tryTargets({kelvinFromCelsius(42.0), kelvinFromCelsius(42.0)});
    EXPECT_TRUE(waitFor([&] {
        return settled() &&
               std::abs(judge.verdict()->conditions1.at(0).target_K - kelvinFromCelsius(42.0)) < 1e-9;
    }));
}

// Catches ticks that make it judge an experiment that is not there yet.
TEST_F(TargetJudgeTest, TicksMayComeBeforeTheExperiment) {
    judge.setKept({false, true});
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_FALSE(judge.verdict());
    set(twoCircles(40.0, 40.0));
    EXPECT_TRUE(waitFor([&] { return !judge.isStale(); }));
}

// Catches targets kept that are those of objects which are gone.
TEST_F(TargetJudgeTest, KeptTargetsGoWithTheirObjects) {
    const Experiment two = twoCircles(20.0, 40.0); // the first below the room's
    set(two);
    judge.setKept({true, false});
    const auto settled = [&] { return !judge.isStale(); };
    ASSERT_TRUE(waitFor(settled));
    EXPECT_FALSE(judge.verdict()->fixedKept);
    Experiment one = two;
    one.objects.pop_back();
    set(one);
    set(two);
    ASSERT_TRUE(waitFor(settled));
    EXPECT_TRUE(judge.verdict()->fixedKept);
}

// Catches: a verdict without word of the shade at its pose, or with that of other objects.
TEST_F(TargetJudgeTest, TellsWhoShadesWhomAtTheVerdictsPose) {
    Experiment stacked = readExperiment(BASK_EXAMPLES "/two-circles.json").value();
    stacked.objects[1].mounting = stacked.objects[0].mounting;
    stacked.objects[1].mounting[kZ] += 0.04;
    set(stacked);
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    ASSERT_EQ(judge.shade().size(), 1u);
    EXPECT_EQ(judge.shade()[0].objects, (std::vector<int>{1, 0}));
    set(readExperiment(BASK_EXAMPLES "/two-circles.json").value());
    ASSERT_TRUE(waitFor([&] { return !judge.isStale(); }));
    EXPECT_TRUE(judge.shade().empty());
}

} // namespace
} // namespace bask::test
