// Identification of recorded runs, and `bask identify` as a script sees it.

#include "app/commands/command_line.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recording/session_identification.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"
#include "tests/engine/recording/recording.h"
#include "tests/support/captured_command.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QFile>
#include <QTemporaryDir>

#include <cmath>

namespace bask {
namespace {

test::Captured identify(const QStringList& arguments) {
    return test::captured(identifyCommand, arguments);
}

Experiment threeObjects() {
    auto read = readExperiment(BASK_EXAMPLES "/three-objects.json");
    EXPECT_TRUE(read);
    return read ? *read : Experiment();
}

/// Runs on the simulated rig into a session.
void record(const Experiment& experiment, const QString& session) {
    SimulatedRunOptions options;
    options.sessionPath = session.toStdString();
    options.mayReplace = true;
    const auto outcome = runSimulated(experiment, options);
    ASSERT_TRUE(outcome) << describe(outcome.error());
}

std::vector<IdentifiedRates> identifySession(const SessionRecord& session) {
    HeatRecords records(session);
    for (const TraceSample& sample : session.samples)
        records.add(sample);
    return records.identify();
}

void expectNear(const Estimate& estimate, double truth, double relative) {
    EXPECT_NEAR(estimate.value, truth, 4.0 * estimate.standardError);
    EXPECT_NEAR(estimate.value / truth, 1.0, relative);
}

QByteArray contents(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll();
}

} // namespace

// Catches: rates of a recorded run that are not the plant's, although every part is right: units, source
// strength, T3 of sensors that were zeroed, samples after Stop.
TEST(SessionIdentification, FindsThePlantsRatesFromWrongBeliefs) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("run.bask");
    Experiment experiment = threeObjects();
    ASSERT_EQ(experiment.controller.estimatedRateErrorFactor, 4.0);
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        experiment.simulation.seed = seed;
        ASSERT_NO_FATAL_FAILURE(record(experiment, path));
        const auto session = readSession(path.toStdString());
        ASSERT_TRUE(session);
        const std::vector<IdentifiedRates> identified = identifySession(*session);
        const std::vector<HeatRates> truth = nominalRates(experiment, experiment.environment_K);
        ASSERT_EQ(identified.size(), truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            ASSERT_TRUE(identified[i].usable()) << describe(identified[i].reason);
            expectNear(identified[i].lambda1, truth[i].lambda1, 0.03);
            expectNear(identified[i].lambda2, truth[i].lambda2, 0.12);
            expectNear(identified[i].lambda3, truth[i].lambda3, 0.12);
        }
    }
}

// Catches: cool-down and retreat taken for a run whose source heats, because it is still hot.
TEST(SessionIdentification, LeavesOutWhatComesAfterStop) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("run.bask");
    ASSERT_NO_FATAL_FAILURE(record(threeObjects(), path));
    auto session = readSession(path.toStdString());
    ASSERT_TRUE(session);
    const IdentifiedRates before = identifySession(*session).front();
    const double stop_s = session->samples.back().time_s;
    session->events.push_back({stop_s, {MessageCode::EventStopped, {}}});
    for (int k = 1; k <= 100; ++k) {
        TraceSample sample = session->samples.back();
        sample.time_s += 1.0;
        for (ObjectSample& object : sample.objects)
            object.measured_K -= 0.1;
        session->samples.push_back(sample);
    }
    EXPECT_EQ(identifySession(*session).front().lambda1.value, before.lambda1.value);
}

// Catches: a day that takes a day's memory, and rates that are others for it.
TEST(SessionIdentification, OfALongRunItKeepsSomeSamplesAndFindsTheSameRates) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("run.bask");
    ASSERT_NO_FATAL_FAILURE(record(threeObjects(), path));
    auto session = readSession(path.toStdString());
    ASSERT_TRUE(session);
    const std::vector<TraceSample> once = session->controlledSamples();
    session->events.clear();
    session->samples = once;
    const IdentifiedRates some = identifySession(*session).front();
    ASSERT_TRUE(some.usable());
    // The same run, so many samples in the place of each that they are too many.
    const auto times = static_cast<int>(5 * HeatRecords::kMax / 2 / once.size() + 1);
    HeatRecords records(*session);
    for (std::size_t k = 0; k + 1 < once.size(); ++k)
        for (int j = 0; j < times; ++j) {
            TraceSample sample = once[k];
            const double share = static_cast<double>(j) / times;
            sample.time_s += share * (once[k + 1].time_s - once[k].time_s);
            for (std::size_t i = 0; i < sample.objects.size(); ++i) {
                sample.objects[i].measured_K +=
                    share * (once[k + 1].objects[i].measured_K - sample.objects[i].measured_K);
                sample.objects[i].viewFactor +=
                    share * (once[k + 1].objects[i].viewFactor - sample.objects[i].viewFactor);
            }
            records.add(sample);
        }
    EXPECT_LE(records.size(), HeatRecords::kMax);
    EXPECT_GE(records.size(), HeatRecords::kMax / 2);
    const IdentifiedRates all = records.identify().front();
    ASSERT_TRUE(all.usable()) << describe(all.reason);
    EXPECT_NEAR(all.lambda1.value / some.lambda1.value, 1.0, 0.02);
    EXPECT_NEAR(all.lambda2.value / some.lambda2.value, 1.0, 0.05); // known to some per cent only
}

// Catches: a file of start values that is not the session's experiment, or that the next run does not start
// from.
TEST(IdentifyCommand, TheNextRunStartsWithTheRatesFound) {
    const QTemporaryDir folder;
    const QString first = folder.filePath("first.bask"), second = folder.filePath("second.bask"),
                  next = folder.filePath("next.json");
    const Experiment experiment = threeObjects();
    ASSERT_NO_FATAL_FAILURE(record(experiment, first));
    const test::Captured outcome = identify({first, "--json", "-o", next});
    ASSERT_EQ(outcome.code, kExitDone) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto json = nlohmann::json::parse(outcome.out);
    auto written = readExperiment(next.toStdString());
    ASSERT_TRUE(written) << describe(written.error());
    const auto nominal = nominalRates(experiment, experiment.environment_K);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(written->objects[i].estimatedRates);
        const HeatRates& rates = *written->objects[i].estimatedRates;
        const auto& row = json["objects"][i];
        EXPECT_EQ(row["name"], experiment.objects[i].name);
        EXPECT_EQ(row["lambda1_K_s"]["value"], rates.lambda1) << "all digits";
        EXPECT_EQ(row["lambda2_1_K3s"]["value"], rates.lambda2);
        EXPECT_EQ(row["lambda3_K_s"]["value"], rates.lambda3);
        EXPECT_EQ(row["lambda1_K_s"]["nominal"], nominal[i].lambda1);
        EXPECT_GT(row["lambda1_K_s"]["controller"], 0.0);
        EXPECT_NEAR(row["areal_heat_capacity_J_m2K"].get<double>() /
                        experiment.objects[i].material.arealHeatCapacity_J_m2K(),
                    1.0, 0.03);
        written->objects[i].estimatedRates.reset();
    }
    EXPECT_EQ(*written, experiment) << "nothing else is changed";

    const auto start = readExperiment(next.toStdString());
    ASSERT_NO_FATAL_FAILURE(record(*start, second));
    const auto session = readSession(second.toStdString());
    ASSERT_TRUE(session);
    for (std::size_t i = 0; i < 3; ++i) {
        // The first belief that is recorded is the controller's after its first step, with nothing learnt.
        const ObjectSample& sample = session->samples[1].objects[i];
        EXPECT_NEAR(sample.lambda1 / start->objects[i].estimatedRates->lambda1, 1.0, 1e-9);
        EXPECT_NEAR(sample.lambda2 / start->objects[i].estimatedRates->lambda2, 1.0, 1e-9);
    }
}

// Catches: rates of one object that change what the others start from.
TEST(BelievedRates, AreTakenAsTheyStandAndLeaveTheOthersAlone) {
    Experiment experiment = threeObjects();
    const auto before = estimatedRates(experiment, 298.15);
    experiment.objects[1].estimatedRates = HeatRates{0.5, 3e-11, 0.2};
    const auto after = estimatedRates(experiment, 298.15);
    EXPECT_EQ(after[0], before[0]);
    EXPECT_EQ(after[1], (HeatRates{0.5, 3e-11, 0.2}));
    EXPECT_EQ(after[2], before[2]);
    EXPECT_EQ(nominalRates(experiment, 298.15)[1], nominalRates(threeObjects(), 298.15)[1]);
}

TEST(IdentifyCommand, PrintsATableWithUnits) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("run.bask");
    ASSERT_NO_FATAL_FAILURE(record(threeObjects(), session));
    const test::Captured outcome = identify({session});
    EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
    for (const char* words : {"circle           lambda1", "hand             lambda3", "1/(K3 s)", "std_error",
                              "of_nominal", "of_controller", "circle: m c/A = "})
        EXPECT_NE(outcome.out.find(words), std::string::npos) << words << "\n" << outcome.out;
    EXPECT_EQ(outcome.out.find("h A/(m c)"), std::string::npos);
    // 15 K cannot tell the two apart, and it says so; start values are fitted without convection.
    const QString next = folder.filePath("next.json");
    const test::Captured convection = identify({session, "--convection", "-o", next});
    EXPECT_EQ(convection.code, kExitNegative);
    EXPECT_NE(convection.out.find("h A/(m c)"), std::string::npos);
    for (const char* object : {"circle", "bunny", "hand"})
        EXPECT_NE(convection.out.find(std::string(object) + ": not usable: "), std::string::npos)
            << convection.out;
    EXPECT_NE(convection.out.find("the record tells lambda2 within"), std::string::npos) << convection.out;
    EXPECT_TRUE(readExperiment(next.toStdString())->objects[0].estimatedRates);
    EXPECT_NE(identify({session, "--free-ambient"}).out, outcome.out);
}

// Catches: numbers made of a run too short, and an experiment written without any.
TEST(IdentifyCommand, ARunThatTellsNothingIsANegativeVerdict) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("run.bask"), next = folder.filePath("next.json");
    {
        auto writer = SessionWriter::create(session.toStdString(), test::twoDisks(), true);
        ASSERT_TRUE(writer);
        const test::Captured empty = identify({session}); // being recorded, no sample yet
        EXPECT_EQ(empty.code, kExitNegative);
        EXPECT_NE(empty.out.find("too few"), std::string::npos) << empty.out;
        for (int k = 0; k < 20; ++k)
            ASSERT_TRUE((*writer)->add(test::madeUpSample(test::twoDisks(), k)));
    }
    const test::Captured outcome = identify({session, "--json", "-o", next});
    EXPECT_EQ(outcome.code, kExitNegative);
    EXPECT_NE(outcome.err.find("interrupted"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("next.json is not written"), std::string::npos) << outcome.err;
    EXPECT_FALSE(QFile::exists(next));
    const auto json = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(json["objects"][1]["usable"], false);
    EXPECT_TRUE(json["objects"][1]["lambda1_K_s"]["value"].is_null());
}

// Catches: an experiment or session of the user's lost to the output.
TEST(IdentifyCommand, ReplacesNothingButItsOwnOutput) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("run.bask"), mine = folder.filePath("mine.json");
    ASSERT_NO_FATAL_FAILURE(record(threeObjects(), session));
    ASSERT_TRUE(writeExperiment(threeObjects(), mine.toStdString()));
    const QByteArray before = contents(mine), recorded = contents(session);
    EXPECT_EQ(identify({session, "-o", mine}).code, kExitBadInput);
    EXPECT_EQ(contents(mine), before);
    EXPECT_EQ(identify({session, "-o", session}).code, kExitBadInput);
    EXPECT_EQ(contents(session), recorded);
    EXPECT_EQ(identify({session, "-o", folder.filePath("gone/e.json")}).code, kExitBadInput);
    EXPECT_EQ(identify({session, "-o", ""}).code, kExitBadInput);
    const QString next = folder.filePath("next.json");
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(identify({session, "-o", next}).code, kExitDone) << "the second time over its own";
}

TEST(IdentifyCommand, RefusesWhatIsNoSession) {
    const QTemporaryDir folder;
    const QString session = folder.filePath("run.bask");
    const auto write = [&](const char* name, const QByteArray& bytes) {
        QFile file(folder.filePath(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
        return file.fileName();
    };
    ASSERT_NO_FATAL_FAILURE(record(threeObjects(), session));
    QByteArray damaged = contents(session);
    damaged.replace(damaged.size() / 3, damaged.size() / 3, QByteArray(damaged.size() / 3, '\x5a'));
    for (const QString& path :
         {write("empty.bask", ""), write("text.bask", "temperature,300\n"), write("damaged.bask", damaged),
          write("short.bask", damaged.left(5000)), folder.filePath("none.bask"), folder.path()}) {
        const test::Captured outcome = identify({path});
        EXPECT_EQ(outcome.code, kExitBadInput) << path.toStdString();
        EXPECT_EQ(outcome.out, "") << path.toStdString();
        EXPECT_NE(outcome.err.find("bask identify: " + path.toStdString() + ": "), std::string::npos)
            << outcome.err;
    }
    for (const QStringList& arguments : {QStringList{}, QStringList{session, session},
                                         QStringList{session, "--frobnicate"}, QStringList{session, "-o"}})
        EXPECT_EQ(identify(arguments).code, kExitBadInput) << arguments.join(' ').toStdString();
}

} // namespace bask
