#include "engine/thermography/face_temperature.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "tests/engine/thermography/radiometry_reference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace bask {
namespace {

FaceSurroundings faceOf(const nlohmann::json& one) {
    FaceSurroundings face{
        one["emittance"].get<double>(), {}, kelvinFromCelsius(one["room_degC"].get<double>())};
    for (const auto& s : one["surfaces"])
        face.surfaces.push_back({s["view_factor"].get<double>(), kelvinFromCelsius(s["T_degC"].get<double>()),
                                 s["emittance"].get<double>()});
    return face;
}

/// Over the plate of the document: 200 degC, emittance 0.25, room 25 degC.
FaceSurroundings overThePlate(double emittance, double F) {
    return {emittance, {{F, kelvinFromCelsius(200.0), 0.25}}, kelvinFromCelsius(25.0)};
}

const double kFace_K = kelvinFromCelsius(40.0);

} // namespace

// Catches: a wrong sign or factor in the equation. The four pairs stand in docs/model.md.
TEST(FaceTemperature, hasTheDocumentedValues) {
    const double cases[][4] = {{0.9, 0.3, 40.652, 2.27},
                               {0.6, 0.3, 42.587, 13.04},
                               {0.9, 0.9, 44.687, 6.69},
                               {0.95, 0.1, 39.639, 0.36}};
    for (const auto& [emittance, F, apparent_degC, naiveError_K] : cases) {
        const FaceSurroundings face = overThePlate(emittance, F);
        const double apparent_K = apparentTemperature(thermalBand(), face, kFace_K);
        EXPECT_NEAR(celsiusFromKelvin(apparent_K), apparent_degC, 1e-3);
        EXPECT_NEAR(faceTemperature(thermalBand(), face, apparent_K)->T_K, kFace_K, 1e-8);
        const FaceSurroundings room{emittance, {}, face.T_env_K}; // as other programs take it
        EXPECT_NEAR(faceTemperature(thermalBand(), room, apparent_K)->T_K - kFace_K, naiveError_K, 5e-3);
    }
}

// Catches the same with several sources, curves, and hotter and colder faces, against sums and bisections.
TEST(FaceTemperature, meetsAnIndependentIntegral) {
    int checked = 0;
    for (const auto& one : test::radiometryReference()["cases"]) {
        SCOPED_TRACE(one.dump());
        const BandRadiance& band = test::referenceBand(one["curve"].get<std::string>());
        const FaceSurroundings face = faceOf(one);
        const double T_K = kelvinFromCelsius(one["face_degC"].get<double>());
        const double apparent_K = kelvinFromCelsius(one["apparent_degC"].get<double>());
        EXPECT_NEAR(apparentTemperature(band, face, T_K), apparent_K, 1e-7);
        const auto solved = faceTemperature(band, face, apparent_K);
        ASSERT_TRUE(solved);
        EXPECT_NEAR(solved->T_K, T_K, 1e-7);
        ++checked;
    }
    EXPECT_EQ(checked, 29);
}

// Catches: a derivative that is not one. Against differences of the solution.
TEST(FaceTemperature, sensitivitiesAreDerivatives) {
    FaceSurroundings face{0.7,
                          {{0.3, kelvinFromCelsius(250.0), 0.6}, {0.2, kelvinFromCelsius(90.0), 0.9}},
                          kelvinFromCelsius(22.0)};
    const double apparent_K = apparentTemperature(thermalBand(), face, kelvinFromCelsius(55.0));
    const FaceSensitivities by = faceTemperature(thermalBand(), face, apparent_K)->sensitivities;
    const auto slope = [&](double& value, double step) {
        const double middle = value;
        value = middle + step;
        const double up = faceTemperature(thermalBand(), face, apparent_K)->T_K;
        value = middle - step;
        const double down = faceTemperature(thermalBand(), face, apparent_K)->T_K;
        value = middle;
        return (up - down) / (2.0 * step);
    };
    EXPECT_NEAR(by.byEmittance, slope(face.emittance, 1e-5), 1e-5 * std::abs(by.byEmittance));
    EXPECT_NEAR(by.byRoom, slope(face.T_env_K, 1e-3), 1e-6);
    for (std::size_t p = 0; p < 2; ++p) {
        EXPECT_NEAR(by.byViewFactor[p], slope(face.surfaces[p].viewFactor, 1e-5),
                    1e-5 * std::abs(by.byViewFactor[p]));
        EXPECT_NEAR(by.bySurface[p], slope(face.surfaces[p].T_K, 1e-3), 1e-6);
        EXPECT_NEAR(by.bySurfaceEmittance[p], slope(face.surfaces[p].emittance, 1e-5),
                    1e-5 * std::abs(by.bySurfaceEmittance[p]));
    }
    const double step = 1e-3;
    const double byApparent = (faceTemperature(thermalBand(), face, apparent_K + step)->T_K -
                               faceTemperature(thermalBand(), face, apparent_K - step)->T_K) /
                              (2.0 * step);
    EXPECT_NEAR(by.byApparent, byApparent, 1e-6);
    EXPECT_LT(by.byViewFactor[0], 0.0) << "more of the source is seen: the face itself is colder";
    EXPECT_GT(by.byApparent, 1.0);
}

// Catches: causes that are forgotten or added twice. Truth: many draws from the stated uncertainties.
TEST(FaceReading, uncertaintyIsThatOfManyDraws) {
    const FaceSurroundings face = overThePlate(0.85, 0.5);
    const double apparent_K = apparentTemperature(thermalBand(), face, kFace_K);
    ReadingUncertainty u;
    u.pixels_K = 0.02;
    u.gain = 0.01;
    u.gainAbout_K = kelvinFromCelsius(25.0);
    u.offset_K = 0.1;
    u.drift_K = 0.05;
    u.emittance = standardOfLimits(0.02);
    u.T_env_K = 0.5;
    u.surfaces = {{0.01, 2.0, 0.02}};
    const auto reading = readFace(thermalBand(), face, apparent_K, u);
    ASSERT_TRUE(reading);
    EXPECT_NEAR(reading->T_K, kFace_K, 1e-8);
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    double sum = 0.0, squares = 0.0;
    constexpr int kDraws = 40000;
    for (int i = 0; i < kDraws; ++i) {
        FaceSurroundings drawn = face;
        drawn.emittance += u.emittance * normal(random);
        drawn.T_env_K += u.T_env_K * normal(random);
        drawn.surfaces[0].viewFactor += u.surfaces[0].viewFactor * normal(random);
        drawn.surfaces[0].T_K += u.surfaces[0].T_K * normal(random);
        drawn.surfaces[0].emittance += u.surfaces[0].emittance * normal(random);
        const double seen_K = apparent_K + u.pixels_K * normal(random) + u.offset_K * normal(random) +
                              u.drift_K * normal(random) +
                              u.gain * (apparent_K - u.gainAbout_K) * normal(random);
        const double off_K = faceTemperature(thermalBand(), drawn, seen_K)->T_K - kFace_K;
        sum += off_K;
        squares += off_K * off_K;
    }
    const double sd_K = std::sqrt(squares / kDraws - sum * sum / kDraws / kDraws);
    EXPECT_NEAR(reading->standardUncertainty_K / sd_K, 1.0, 0.03);
    const double parts[] = {
        reading->fromPixels_K,      reading->fromGain_K,      reading->fromOffset_K,
        reading->fromDrift_K,       reading->fromEmittance_K, reading->fromRoom_K,
        reading->fromViewFactors_K, reading->fromSurfaces_K,  reading->fromSurfaceEmittances_K};
    double together = 0.0;
    for (const double part : parts) {
        EXPECT_GT(part, 0.0);
        together += part * part;
    }
    EXPECT_NEAR(together, reading->standardUncertainty_K * reading->standardUncertainty_K, 1e-12);
}

// Catches: bare metal that is shown as a number.
TEST(FaceReading, bareMetalIsRefusedAndPaintIsNot) {
    ReadingUncertainty u;
    u.pixels_K = 0.01;
    u.offset_K = 0.15;
    u.emittance = standardOfLimits(0.02);
    u.T_env_K = 0.5;
    u.surfaces = {{0.01, 2.0, 0.02}};
    for (const double F : {0.0, 0.3, 0.9}) {
        const FaceSurroundings metal = overThePlate(0.04, F);
        const auto refused =
            readFace(thermalBand(), metal, apparentTemperature(thermalBand(), metal, kFace_K), u);
        ASSERT_FALSE(refused) << F;
        EXPECT_EQ(refused.error().code(), MessageCode::ThermalFaceUnusable);
        EXPECT_NE(describe(refused.error()).find("0.04"), std::string::npos) << describe(refused.error());
        const FaceSurroundings paint = overThePlate(0.9, F);
        const auto read =
            readFace(thermalBand(), paint, apparentTemperature(thermalBand(), paint, kFace_K), u);
        ASSERT_TRUE(read) << F;
        EXPECT_LT(2.0 * read->standardUncertainty_K, F < 0.5 ? 0.8 : 2.0) << F;
    }
}

// Catches: a temperature made up where the reflection explains all that was seen, or more.
TEST(FaceReading, aReflectionThatIsTooBrightIsToldSo) {
    const FaceSurroundings face = overThePlate(0.3, 0.9);
    const auto refused = faceTemperature(thermalBand(), face, kelvinFromCelsius(10.0));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ThermalReflectionBrighter);
}

TEST(FaceReading, aBrokenContractThrows) {
    const FaceSurroundings good = overThePlate(0.9, 0.3);
    const auto broken = [&](const std::function<void(FaceSurroundings&)>& change) {
        FaceSurroundings face = good;
        change(face);
        EXPECT_THROW(apparentTemperature(thermalBand(), face, kFace_K), std::invalid_argument);
        EXPECT_THROW((void)faceTemperature(thermalBand(), face, kFace_K), std::invalid_argument);
    };
    broken([](FaceSurroundings& face) { face.emittance = 0.0; });
    broken([](FaceSurroundings& face) { face.emittance = 1.01; });
    broken([](FaceSurroundings& face) { face.surfaces[0].viewFactor = -0.01; });
    broken([](FaceSurroundings& face) { face.surfaces.push_back({0.71, 400.0, 1.0}); });
    broken([](FaceSurroundings& face) { face.T_env_K = 20.0; });
    broken([](FaceSurroundings& face) { face.surfaces[0].T_K = std::nan(""); });
    EXPECT_THROW((void)readFace(thermalBand(), good, kFace_K, {}), std::invalid_argument) << "no surface";
    ReadingUncertainty negative;
    negative.surfaces.resize(1);
    negative.offset_K = -1.0;
    EXPECT_THROW((void)readFace(thermalBand(), good, kFace_K, negative), std::invalid_argument);
}

} // namespace bask
