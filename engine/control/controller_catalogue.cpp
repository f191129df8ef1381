#include "engine/control/controller_catalogue.h"

#include "engine/base/translated.h"
#include "engine/control/adaptive.h"
#include "engine/control/level_servo.h"
#include "engine/control/model_based.h"

#include <algorithm>
#include <stdexcept>

namespace bask {
namespace {

using namespace unit;
using enum Loosens;

// clang-format off
constexpr Parameter<LevelServoGains> kLevelServo[]{
    {{"time_constant", kSeconds, {0.0, 1e5, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Time constant"),
      QT_TRANSLATE_NOOP("Parameter", "Wanted rate = error / time constant: shorter is faster and rougher.")}, &LevelServoGains::timeConstant_s},
    {{"integral_time", kSeconds, {0.0, 1e6, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Integral time"),
      QT_TRANSLATE_NOOP("Parameter", "Of the slow integral action near the target.")}, &LevelServoGains::integralTime_s},
};

constexpr Parameter<ModelBasedGains> kModelBased[]{
    {{"D", kPerSecond, {0.0, 100.0}, Never, QT_TRANSLATE_NOOP("Parameter", "Damping D"),
      QT_TRANSLATE_NOOP("Parameter", "dv/dt = −D v \u2212 K \u0394\u03c4"), 4, false, "D"}, &ModelBasedGains::D},
    {{"K", kPerSecond2, {0.0, 100.0, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Stiffness K"),
      QT_TRANSLATE_NOOP("Parameter", "dv/dt = −D v \u2212 K \u0394\u03c4"), 4, false, "K"}, &ModelBasedGains::K},
};

constexpr Parameter<AdaptiveGains> kAdaptive[]{
    {{"mu", kPerSecond, {0.0, 100.0, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Weight of the error \u03bc"),
      QT_TRANSLATE_NOOP("Parameter", "\u03b6 = v + \u03bc \u0394\u03c4"), 4, false, "\u03bc"}, &AdaptiveGains::mu},
    {{"K", kPerKelvin, {0.0, 1e3, true}, Never, QT_TRANSLATE_NOOP("Parameter", "Feedback K"),
      QT_TRANSLATE_NOOP("Parameter", "Of \u03b6 in the velocity command"), 4, false, "K"}, &AdaptiveGains::K},
    {{"gamma1", kSeconds3PerKelvin3, {0.0, 1e6}, Never, QT_TRANSLATE_NOOP("Parameter", "Adaptation \u03b3\u2081"),
      QT_TRANSLATE_NOOP("Parameter", "Speed at which 1/\u03bb\u2081 is adapted"), 4, false, "\u03b3\u2081"}, &AdaptiveGains::gamma1},
    {{"gamma2", kSecondsPerKelvin9, ValidRange{0.0, 1.0}, Never, QT_TRANSLATE_NOOP("Parameter", "Adaptation \u03b3\u2082"),
      QT_TRANSLATE_NOOP("Parameter", "Speed at which \u03bb\u2082/\u03bb\u2081 is adapted"), 4, false, "\u03b3\u2082"}, &AdaptiveGains::gamma2},
};

// clang-format on

template <class Gains, std::size_t n>
std::vector<ControllerGain> gains(const Parameter<Gains> (&table)[n], Gains ControllerSettings::*kept) {
    std::vector<ControllerGain> out;
    for (const Parameter<Gains>& gain : table)
        out.push_back({&gain,
                       [&gain, kept](const ControllerSettings& s) { return gain.get(s.*kept).value(); },
                       [&gain, kept](ControllerSettings& s, double si) { gain.set(s.*kept, si); }});
    return out;
}

template <class Made>
std::unique_ptr<Controller> make(const ControllerSettings& settings, ControlModel model) {
    return std::make_unique<Made>(settings, std::move(model));
}

} // namespace

const std::vector<ControllerEntry>& controllerCatalogue() {
    static const std::vector<ControllerEntry> entries{
        {ControllerKind::LevelServo, "level_servo", QT_TRANSLATE_NOOP("Controller", "Level servo"),
         QT_TRANSLATE_NOOP("Controller",
                           "Moves to the view factor each object needs; learns the rates on the way."),
         "Level servo: the wanted rate of the temperature is K_p times the error; the heat balance gives the "
         "view factor for it. No integral of the error: what the model leaves unexplained is learnt with the "
         "integral time. All objects share the robot.",
         gains(kLevelServo, &ControllerSettings::levelServo), make<LevelServo>},
        {ControllerKind::ModelBased, "model_based", QT_TRANSLATE_NOOP("Controller", "Model-based"),
         QT_TRANSLATE_NOOP("Controller",
                           "The paper's law with known heat rates: dv/dt = −D v \u2212 K \u0394\u03c4."),
         "Model-based law: d2T/dt2 = K_p error - K_d dT/dt by the interaction matrix. All objects share the "
         "robot.",
         gains(kModelBased, &ControllerSettings::modelBased), make<ModelBasedController>},
        {ControllerKind::Adaptive, "adaptive", QT_TRANSLATE_NOOP("Controller", "Adaptive"),
         QT_TRANSLATE_NOOP("Controller", "The paper's law with adapted heat rates."),
         "Adaptive law, no PID: zeta = dT/dt + mu (T - target), with estimates of the heat rates on the way. "
         "All objects share the robot.",
         gains(kAdaptive, &ControllerSettings::adaptive), make<AdaptiveController>},
    };
    return entries;
}

const ControllerEntry& controllerEntry(ControllerKind kind) {
    const auto& entries = controllerCatalogue();
    const auto entry = std::ranges::find(entries, kind, &ControllerEntry::kind);
    if (entry == entries.end())
        throw std::invalid_argument("a controller that is not in the catalogue");
    return *entry;
}

std::unique_ptr<Controller> makeController(const ControllerSettings& settings, ControlModel model) {
    return controllerEntry(settings.kind).make(settings, std::move(model));
}

} // namespace bask
