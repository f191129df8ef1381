#include "app/session_rates.h"

#include "engine/runtime/simulated_run.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace bask {
namespace {

/// A run of the three objects with wrong beliefs, recorded and read again.
const SessionRecord& recorded() {
    static const SessionRecord record = [] {
        Experiment experiment = readExperiment(BASK_EXAMPLES "/three-objects.json").value();
        experiment.controller.believedRateErrorFactor = 3.0;
        const QTemporaryDir folder;
        const std::string path = folder.filePath("run.bask").toStdString();
        SimulatedRunOptions options;
        options.duration_s = 300.0;
        options.sessionPath = path;
        EXPECT_TRUE(runSimulated(experiment, options).ok());
        return readSession(path).value();
    }();
    return record;
}

} // namespace

// Catches rates that are not the plant's, or stand beside the wrong object.
TEST(SessionRates, AreThoseOfThePlant) {
    const auto rates = sessionRates(recorded());
    ASSERT_TRUE(rates.ok());
    ASSERT_EQ(rates->identified.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_TRUE(rates->identified[i].usable()) << i;
        EXPECT_NEAR(rates->identified[i].lambda1.value / rates->material[i].lambda1, 1.0, 0.03) << i;
    }
}

// Catches start values that reach an object of another name, material or heat source.
TEST(SessionRates, StartValuesGoToTheSameObjectsUnderTheSameSourceOnly) {
    const SessionRates rates = sessionRates(recorded()).value();
    Experiment experiment = recorded().experiment;
    experiment.objects[0].name = "another";
    experiment.objects[1].material.emittance *= 0.5;
    const StartValues start = withStartValues(experiment, recorded(), rates);
    EXPECT_EQ(start.objects, std::vector<std::string>{experiment.objects[2].name});
    EXPECT_FALSE(start.experiment.objects[0].believedRates);
    EXPECT_FALSE(start.experiment.objects[1].believedRates);
    ASSERT_TRUE(start.experiment.objects[2].believedRates);
    EXPECT_EQ(start.experiment.objects[2].believedRates->lambda1, rates.identified[2].lambda1.value);

    experiment = recorded().experiment;
    experiment.source.temperature_K += 50.0;
    EXPECT_TRUE(withStartValues(experiment, recorded(), rates).objects.empty());
}

} // namespace bask
