#include "app/session_count.h"

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/recording/session_store.h"
#include "engine/runtime/simulated_run.h"
#include "tests/support/wait_for.h"

#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

/// A run of the three objects with wrong beliefs, recorded, and what was counted of it.
struct Recorded {
    SessionRecord facts;
    SessionNumbers numbers;
};

const Recorded& recorded() {
    static const Recorded record = [] {
        Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
        experiment.controller.estimatedRateErrorFactor = 3.0;
        const QTemporaryDir folder;
        const std::string path = folder.filePath("run.bask").toStdString();
        SimulatedRunOptions options;
        options.duration_s = 300.0;
        options.sessionPath = path;
        EXPECT_TRUE(runSimulated(experiment, options).ok());
        const auto session = RecordedSession::open(path).value();
        std::atomic<std::size_t> done = 0;
        Recorded out{session->facts(), countSession(session->facts(), session->size(), done).value()};
        EXPECT_EQ(done, session->size());
        return out;
    }();
    return record;
}

} // namespace

// Catches numbers of the retreat, and a way that is not the run's.
TEST(SessionCount, MetricsAndWayAreThoseOfTheRun) {
    const SessionNumbers& numbers = recorded().numbers;
    ASSERT_EQ(numbers.metrics.objects.size(), 3U);
    EXPECT_TRUE(numbers.metrics.objects[0].settling_s);
    EXPECT_LE(numbers.metrics.last.time_s, controlledUntil_s(recorded().facts));
    ASSERT_GE(numbers.way.size(), numbers.metrics.samples) << "all of a short run";
    EXPECT_EQ(numbers.way.front().objects.size(), 3U);
    EXPECT_LT(numbers.shade, 0.005) << "they are side by side";
}

// Catches numbers of a run that is no longer open, a count that is not told of, and damage that is not found.
TEST(SessionCount, TheRunOpenedLastIsCountedAndDamageIsTold) {
    const QTemporaryDir folder;
    const auto run = [&](const char* name, int samples) {
        const std::string path = folder.filePath(QString::fromLatin1(name)).toStdString();
        auto writer = SessionWriter::create(path, recorded().facts.experiment, true, 1e6,
                                            SessionWriter::Earlier::Replaced);
        TraceSample sample = recorded().numbers.way.front();
        for (int k = 0; k < samples; ++k) {
            sample.time_s = k;
            EXPECT_TRUE((*writer)->add(sample));
        }
        EXPECT_TRUE((*writer)->finish("stopped"));
        writer->reset();
        return RecordedSession::open(path).value();
    };
    SessionCount count;
    std::vector<std::size_t> counted;
    std::vector<MessageCode> failed;
    int told = 0;
    QObject::connect(&count, &SessionCount::counted,
                     [&](const std::shared_ptr<const SessionNumbers>& numbers) {
                         counted.push_back(numbers->metrics.samples);
                     });
    QObject::connect(&count, &SessionCount::failed,
                     [&](const Error& error) { failed.push_back(error.code()); });
    QObject::connect(&count, &SessionCount::progressed, [&](int percent) {
        EXPECT_TRUE(percent >= 0 && percent <= 100);
        ++told;
    });
    const auto longer = run("a.bask", 80'000), shorter = run("b.bask", 500);
    count.start(*longer);
    QTest::qWait(30);
    count.start(*shorter);
    ASSERT_TRUE(test::waitFor([&] { return !counted.empty(); }));
    EXPECT_EQ(counted, std::vector<std::size_t>{500});
    count.start(*longer);
    QTest::qWait(30);
    count.stop();
    count.start(*longer);
    ASSERT_TRUE(test::waitFor([&] { return counted.size() == 2; }));
    EXPECT_EQ(counted.back(), 80'000U);
    EXPECT_GT(told, 0);

    const auto store = SessionStore::create(shorter->facts().path);
    ASSERT_TRUE((*store)->execute("DELETE FROM step WHERE number = 300"));
    count.start(*shorter);
    ASSERT_TRUE(test::waitFor([&] { return !failed.empty(); }));
    EXPECT_EQ(failed, std::vector{MessageCode::SessionDamaged});
    EXPECT_EQ(counted.size(), 2U);
}

// Catches rates that are not the plant's, or stand beside the wrong object.
TEST(SessionRates, AreThoseOfThePlant) {
    const auto& rates = recorded().numbers.rates;
    ASSERT_TRUE(rates.ok());
    ASSERT_EQ(rates->identified.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(rates->identified[i].usable()) << i;
        EXPECT_NEAR(rates->identified[i].lambda1.value / rates->material[i].lambda1, 1.0, 0.03) << i;
    }
}

// Catches: a loss that is not the plant's, and an h beside the object that it is not of, in another unit, or
// where the record does not tell it.
TEST(SessionRates, TellTheLossAndTheAirWhereTheyCan) {
    const auto& rates = recorded().numbers.rates;
    ASSERT_TRUE(rates.ok());
    ASSERT_EQ(rates->withAir.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        IdentifiedRates fit = rates->withAir[i];
        const double T_K = fit.workingTemperature_K;
        const double loss_K_s = -rates->material[i].rate_K_s(0.0, T_K); // the simulated air takes nothing
        EXPECT_NEAR(fit.loss.value, loss_K_s, 4.0 * fit.loss.standardError + 0.03 * loss_K_s) << i;
        fit.reason = {};
        fit.convection = {0.003, 0.0005};
        fit.lambda1 = {rates->material[i].lambda1, 0.0};
        const Estimate h = convection_W_m2K(fit, recorded().facts.experiment, i);
        const double capacity = recorded().facts.experiment.objects[i].material.arealHeatCapacity_J_m2K();
        EXPECT_NEAR(h.value, 0.003 * capacity, 1e-9 * capacity);
        EXPECT_NEAR(h.standardError, 0.0005 * capacity, 1e-9 * capacity);
        fit.reason = {MessageCode::IdentificationUnheated, {}};
        EXPECT_TRUE(std::isnan(convection_W_m2K(fit, recorded().facts.experiment, i).value));
    }
}

// Catches start values that reach an object of another name, material or heat source.
TEST(SessionRates, StartValuesGoToTheSameObjectsUnderTheSameSourceOnly) {
    const SessionRates& rates = recorded().numbers.rates.value();
    Experiment experiment = recorded().facts.experiment;
    experiment.objects[0].name = "another";
    experiment.objects[1].material.emittance *= 0.5;
    const StartValues start = withStartValues(experiment, recorded().facts.experiment, rates);
    EXPECT_EQ(start.objects, std::vector<std::string>{experiment.objects[2].name});
    EXPECT_FALSE(start.experiment.objects[0].estimatedRates);
    EXPECT_FALSE(start.experiment.objects[1].estimatedRates);
    ASSERT_TRUE(start.experiment.objects[2].estimatedRates);
    EXPECT_EQ(start.experiment.objects[2].estimatedRates->lambda1, rates.identified[2].lambda1.value);

    experiment = recorded().facts.experiment;
    experiment.source.temperature_K += 50.0;
    EXPECT_TRUE(withStartValues(experiment, recorded().facts.experiment, rates).objects.empty());
}

} // namespace bask
