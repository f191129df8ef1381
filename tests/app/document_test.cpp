#include "app/document.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/runtime/simulated_run.h"
#include "tests/support/wait_for.h"

#include <QThreadPool>
#include <QTimer>

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
    document.tryTargets({kelvinFromCelsius(42.0)});
    document.tryTargets({kelvinFromCelsius(43.0)}); // each after the other, but for those in between
    document.tryTargets({kelvinFromCelsius(44.0)});
    std::vector<double> judged;
    QObject::connect(&document, &Document::verdictChanged, [&] {
        if (!document.verdictStale())
            judged.push_back(std::round(celsiusFromKelvin(document.verdict()->conditions1.at(0).target_K)));
    });
    ASSERT_TRUE(waitFor([&] { return judged.size() == 2; }));
    EXPECT_EQ(judged, (std::vector<double>{42.0, 44.0}));
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
    ControllerSettings other = document.experiment().controller;
    other.kind = ControllerKind::ModelBased;
    ASSERT_TRUE(document.setController(other).ok());
    EXPECT_FALSE(document.predicted());
    document.predict();
    ASSERT_TRUE(waitFor([&] { return document.predicted(); })) << "no verdict is needed anew";
    EXPECT_NE(document.predictedSettling_s(), run->objects[0].settlingTime_s);
    ASSERT_TRUE(document.setController(document.experiment().controller).ok());
    document.predict();
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(46.0)}).ok());
    EXPECT_FALSE(document.predicted());
    ASSERT_TRUE(waitFor([&] { return !document.verdictStale(); }));
    EXPECT_FALSE(document.predicted());
}

// Catches a verdict on dragged targets that stays when the drag is broken off.
TEST(Document, DroppedTriesGiveTheVerdictBack) {
    Document document;
    document.open(Document::blank(), {});
    const double own_K = document.experiment().objects[0].target_K;
    const auto settled = [&] { return !document.verdictStale(); };
    ASSERT_TRUE(waitFor(settled));
    document.dropTries();
    EXPECT_TRUE(settled()) << "there was none";
    document.tryTargets({kelvinFromCelsius(41.0)});
    ASSERT_TRUE(waitFor(settled));
    document.dropTries();
    ASSERT_TRUE(waitFor(settled));
    EXPECT_EQ(document.verdict()->conditions1.at(0).target_K, own_K);
    EXPECT_FALSE(document.modified());
}

Experiment twoCircles(double first_degC, double second_degC) {
    Experiment experiment = readExperiment(std::string(BASK_EXAMPLES) + "/two-circles.json").value();
    experiment.objects[0].target_K = kelvinFromCelsius(first_degC);
    experiment.objects[1].target_K = kelvinFromCelsius(second_degC);
    return experiment;
}

// Catches: maps that are made although nobody sees them, that do not come when somebody does, or that follow
// targets and objects of before.
TEST(Document, MapsOfPairsAreMadeWhileWanted) {
    Document document;
    int made = 0;
    QObject::connect(&document, &Document::pairsChanged, [&] { ++made; });
    const auto settled = [&] { return !document.verdictStale(); };
    document.open(twoCircles(40.0, 40.0), {});
    ASSERT_TRUE(waitFor(settled));
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(made, 0);

    document.wantPairs(true);
    ASSERT_TRUE(waitFor([&] { return made == 1; }));
    ASSERT_EQ(document.pairs()->size(), 1U);
    const std::vector<double> density = document.pairs()->at(0).density;
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(150.0), kelvinFromCelsius(30.0)}).ok());
    EXPECT_TRUE(document.pairs()) << "the maps stay, but for where the targets lie";
    ASSERT_TRUE(waitFor([&] { return made == 2; }));
    EXPECT_NEAR(document.pairs()->at(0).target_K.x(), kelvinFromCelsius(150.0), 1e-9);
    EXPECT_FALSE(document.pairs()->at(0).targetReachable);
    EXPECT_EQ(document.pairs()->at(0).density, density);
    Experiment warmer = document.experiment();
    warmer.source.temperature_K += 20.0;
    ASSERT_TRUE(document.edit(warmer).ok());
    EXPECT_FALSE(document.pairs());
    ASSERT_TRUE(waitFor([&] { return made == 3; }));
    EXPECT_NE(document.pairs()->at(0).density, density);

    document.wantPairs(false);
    document.wantPairs(true); // has them
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(made, 3);
    document.wantPairs(false);
    ASSERT_TRUE(document.setTargets({kelvinFromCelsius(40.0), kelvinFromCelsius(40.0)}).ok());
    ASSERT_TRUE(waitFor(settled));
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    document.wantPairs(true);
    document.wantPairs(false); // looked away again
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(made, 3);
    document.wantPairs(true);
    ASSERT_TRUE(waitFor([&] { return made == 4; }));
    EXPECT_NEAR(document.pairs()->at(0).target_K.x(), kelvinFromCelsius(40.0), 1e-9);
}

// Catches tries that wait for ever for maps that nobody wants any more.
TEST(Document, TriesGoOnWhenMapsAreNotWantedAnyMore) {
    Document document;
    document.open(twoCircles(40.0, 40.0), {});
    const auto settled = [&] { return !document.verdictStale(); };
    ASSERT_TRUE(waitFor(settled));
    document.wantPairs(true);
    QObject::connect(&document, &Document::verdictChanged, [&] {
        if (settled()) // the maps come next
            QTimer::singleShot(0, &document, [&document] { document.wantPairs(false); });
    });
    document.tryTargets({kelvinFromCelsius(41.0), kelvinFromCelsius(41.0)});
    document.tryTargets({kelvinFromCelsius(42.0), kelvinFromCelsius(42.0)});
    EXPECT_TRUE(waitFor([&] {
        return settled() &&
               std::abs(document.verdict()->conditions1.at(0).target_K - kelvinFromCelsius(42.0)) < 1e-9;
    }));
}

// Catches targets kept that are those of objects which are gone.
TEST(Document, KeptTargetsGoWithTheirObjects) {
    Document document;
    const Experiment two = twoCircles(20.0, 40.0); // the first below the room's
    document.open(two, {});
    document.setKept({true, false});
    const auto settled = [&] { return !document.verdictStale(); };
    ASSERT_TRUE(waitFor(settled));
    EXPECT_FALSE(document.verdict()->heldKept);
    Experiment one = two;
    one.objects.pop_back();
    ASSERT_TRUE(document.edit(one).ok());
    ASSERT_TRUE(document.edit(two).ok());
    ASSERT_TRUE(waitFor(settled));
    EXPECT_TRUE(document.verdict()->heldKept);
}

// Catches: maps of objects before that arrive after an edit and are taken for those of the present ones.
TEST(Document, MapsOfAnOlderExperimentAreNotHeard) {
    Document document;
    document.wantPairs(true);
    std::vector<std::size_t> maps;
    QObject::connect(&document, &Document::pairsChanged, [&] { maps.push_back(document.pairs()->size()); });
    QObject::connect(&document, &Document::verdictChanged, [&] {
        if (document.verdictStale() || document.experiment().objects.size() != 2)
            return;
        QTimer::singleShot(0, &document, [&document] {
            EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000)); // made, but not heard of
            Experiment fewer = document.experiment();
            fewer.objects.pop_back();
            EXPECT_TRUE(document.edit(fewer).ok());
        });
    });
    document.open(twoCircles(40.0, 40.0), {});
    ASSERT_TRUE(waitFor([&] { return !maps.empty(); }));
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    QCoreApplication::processEvents();
    EXPECT_EQ(maps, std::vector<std::size_t>{0});
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
