#include "engine/runtime/run_control.h"

#include "engine/rig/rig_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

} // namespace

RunControl::RunControl(const Experiment& experiment, const RigReadings& readings, const Clock& clock)
    : m_experiment(experiment), m_readings(readings), m_clock(clock),
      m_estimates(experiment.objects.size(), {kUnknown, kUnknown}) {}

void RunControl::makeController() {
    m_geometry = m_readings.geometry();
    m_controller = bask::makeController(m_experiment.controller, {m_geometry, m_estimates, targets_K()});
}

std::vector<double> RunControl::targets_K() const {
    std::vector<double> out;
    for (const ObjectSpec& object : m_experiment.objects)
        out.push_back(object.target_K);
    return out;
}

void RunControl::begin() {
    m_began_s = m_clock.now_s();
    countBandAnew();
    forgetCompromise();
    m_estimates = estimatedRates(m_experiment, m_readings.environment_K());
    makeController();
}

std::optional<ControlOutput> RunControl::step(const Vector6d& lastRates) {
    const TraceSample& sample = m_readings.sample();
    const bool known = std::ranges::all_of(sample.objects, [](const ObjectSample& object) {
        return std::isfinite(object.estimated_K) && std::isfinite(object.rate_K_s);
    });
    if (!known || !(m_readings.sourceStrength() > 0.0))
        return std::nullopt;
    if (m_geometry != m_readings.geometry()) {
        m_geometry = m_readings.geometry();
        m_controller->setGeometry(m_geometry);
    }
    Observation observation;
    observation.time_s = m_clock.now_s() - m_began_s;
    observation.coordinates = m_readings.coordinates();
    observation.sourceStrength = m_readings.sourceStrength();
    observation.lastRates = lastRates;
    for (const ObjectSample& object : sample.objects)
        observation.objects.push_back({object.estimated_K, object.rate_K_s});
    ControlOutput output = m_controller->step(observation, m_experiment.sampling.period_s);
    m_estimates = output.estimate;
    m_isOnTheWay = output.isOnTheWay;
    noteCompromise(output);
    return output;
}

void RunControl::useTargets() {
    if (m_controller)
        m_controller->setTargets(targets_K());
    countBandAnew();
    forgetCompromise();
}

void RunControl::useSettings(bool isSameKind) {
    if (!m_controller)
        return;
    if (isSameKind)
        m_controller->setGains(m_experiment.controller);
    else
        makeController();
}

void RunControl::noteCompromise(const ControlOutput& output) {
    m_compromise.clear();
    for (std::size_t i = 0; i < output.compromise_K.size(); ++i) {
        const double error_K = output.compromise_K[i] - m_experiment.objects[i].target_K;
        m_compromise.push_back({m_experiment.objects[i].name, error_K});
    }
}

void RunControl::forgetCompromise() {
    m_compromise.clear();
    m_isCompromiseTold = false;
}

Message RunControl::compromise() const {
    return m_compromise.empty()
               ? Message{}
               : Message{MessageCode::EventCompromise, {MessageArg::differences(m_compromise)}};
}

bool RunControl::isCompromiseNew() {
    const bool isNew = !m_compromise.empty() && !m_isCompromiseTold;
    m_isCompromiseTold = m_isCompromiseTold || isNew;
    return isNew;
}

} // namespace bask
