#include "widgets/review/run_differences.h"

#include "engine/base/message_code.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

ListedObject listed(const char* name, double target_degC, const char* material = "steel",
                    double emittance = 0.9) {
    return {name, kelvinFromCelsius(target_degC), material, emittance};
}

SessionHeader listedRun(const char* stem, std::vector<ListedObject> objects,
                        const char* controller = "level-servo") {
    SessionHeader made;
    made.path = std::string("/runs/") + stem + ".bask";
    made.title = "three objects";
    made.objects = std::move(objects);
    made.controller = controller;
    return made;
}

std::vector<std::string> told(const std::vector<SessionHeader>& runs,
                              TemperatureUnit unit = TemperatureUnit::Celsius) {
    std::vector<std::string> out;
    for (QString text : runDifferences(runs, unit))
        out.push_back(text.replace(QChar(0x00a0), u' ').toStdString());
    return out;
}

constexpr const char* kFirst = "20260314T092653Z";
constexpr const char* kSecond = "20260314T102653Z";
constexpr const char* kThird = "20260314T112653Z";

} // namespace

// Catches a difference that is not told, is told of what is the same, or of another object.
TEST(RunDifferences, TellWhatDiffersOnly) {
    EXPECT_EQ(told({listedRun(kFirst, {listed("circle", 40), listed("hand", 40)}),
                    listedRun(kSecond, {listed("circle", 40), listed("hand", 55)})}),
              (std::vector<std::string>{"hand 40.0 °C", "hand 55.0 °C"}));
    EXPECT_EQ(told({listedRun(kFirst, {listed("circle", 40), listed("hand", 40)}),
                    listedRun(kSecond, {listed("circle", 55), listed("hand", 55)}, "adaptive")}),
              (std::vector<std::string>{"all 40.0 °C · Level servo", "all 55.0 °C · Adaptive"}))
        << "one temperature where all have the same";
    EXPECT_EQ(told({listedRun(kFirst, {listed("circle", 40, "steel", 0.9), listed("hand", 40, "PLA")}),
                    listedRun(kSecond, {listed("circle", 40, "steel", 0.85), listed("hand", 40, "cork")})}),
              (std::vector<std::string>{"circle ε 0.9 · hand PLA", "circle ε 0.85 · hand cork"}));
    EXPECT_EQ(told({listedRun(kFirst, {listed("circle", 40)}),
                    listedRun(kSecond, {listed("circle", 40), listed("ring", 50)})}),
              (std::vector<std::string>{"circle 40.0 °C", "circle 40.0 °C, ring 50.0 °C"}))
        << "what each has: the first has no ring";
    EXPECT_EQ(
        told({listedRun(kFirst, {listed("circle", 40), listed("hand", 40)}),
              listedRun(kSecond, {listed("circle", 40), listed("hand", 40), listed("ring", 50)})}),
        (std::vector<std::string>{"circle, hand: 40.0 °C", "circle 40.0 °C, hand 40.0 °C, ring 50.0 °C"}));
    EXPECT_EQ(told({listedRun(kFirst, {listed("hand", 40)}), listedRun(kSecond, {listed("hand", 55)})},
                   TemperatureUnit::Kelvin),
              (std::vector<std::string>{"hand 313.2 K", "hand 328.2 K"}));
}

// Catches rows that look alike, and names of files where something else tells them apart.
TEST(RunDifferences, WhatIsAlikeHasItsFilesName) {
    auto a = listedRun(kFirst, {listed("hand", 40)}), b = listedRun(kSecond, {listed("hand", 40)});
    const auto c = listedRun(kThird, {listed("hand", 55)});
    EXPECT_EQ(told({a, b}), (std::vector<std::string>{kFirst, kSecond}));
    EXPECT_EQ(told({a, b, c}),
              (std::vector<std::string>{std::string("hand 40.0 °C · ") + kFirst,
                                        std::string("hand 40.0 °C · ") + kSecond, "hand 55.0 °C"}));
    a.labels.sample = "plate 7";
    EXPECT_EQ(told({a, b}), (std::vector<std::string>{"", ""})) << "their samples tell them apart";
    a.labels.sample.clear();
    b.path = "/runs/evening.bask";
    EXPECT_EQ(told({a, b}), (std::vector<std::string>{"", ""})) << "it is listed by its own name";
    EXPECT_EQ(givenName(b), "evening");
    EXPECT_EQ(givenName(a), "");
}

// Catches runs of other experiments that are compared, and damaged files among them.
TEST(RunDifferences, OnlyRunsOfOneTitleAreCompared) {
    const auto a = listedRun(kFirst, {listed("hand", 40)});
    auto other = listedRun(kSecond, {listed("hand", 55)}), damaged = listedRun(kThird, {});
    other.title = "two disks";
    damaged.error = Error(MessageCode::SessionDamaged, damaged.path, {"it is cut short"});
    EXPECT_EQ(told({a, other, damaged}), (std::vector<std::string>{"", "", ""}));
    EXPECT_EQ(told({}), std::vector<std::string>());
    auto newer = listedRun(kSecond, {listed("hand", 40)}, "fuzzy");
    EXPECT_EQ(told({a, newer})[1], "fuzzy") << "a controller of a later version";
}

// Catches a key of a run that does not tell it from the others, tells what is the same of all, or has the
// time of recording where something else tells them apart.
TEST(RunKeys, TellWhatDiffers) {
    const auto keys = [](const std::vector<SessionHeader>& runs) {
        std::vector<std::string> out;
        for (QString text : runKeys(runs, TemperatureUnit::Celsius))
            out.push_back(text.replace(QChar(0x00a0), u' ').toStdString());
        return out;
    };
    auto a = listedRun(kFirst, {listed("hand", 40)}),
         b = listedRun(kSecond, {listed("hand", 40)}, "adaptive");
    EXPECT_EQ(keys({a, b}), (std::vector<std::string>{"Level servo", "Adaptive"}));
    b = listedRun(kSecond, {listed("hand", 40)});
    EXPECT_EQ(keys({a, b}), (std::vector<std::string>{kFirst, kSecond})) << "nothing else tells them apart";
    a.labels.operatorName = "A. Hu";
    b.labels.operatorName = "B. Li";
    EXPECT_EQ(keys({a, b}), (std::vector<std::string>{"A. Hu", "B. Li"}));
    b.title = "two disks";
    EXPECT_EQ(keys({a, b}),
              (std::vector<std::string>{"three objects \u00b7 A. Hu", "two disks \u00b7 B. Li"}));
    a.labels = b.labels = {};
    b.title = a.title;
    b.simulated = true;
    EXPECT_EQ(keys({a, b})[1].substr(0, 16), std::string(kSecond).substr(0, 16)) << "and its rig";
    EXPECT_EQ(keys({a}), std::vector<std::string>{kFirst});
}

} // namespace bask
