#include "engine/simulation/simulated_source_tracker.h"

namespace bask {

SimulatedSourceTracker::SimulatedSourceTracker(const SimulatedTrackerConfig& config, const Clock& clock)
    : m_config(config), m_clock(clock), m_random(config.seed) {}

void SimulatedSourceTracker::observe(const Pose& X_RS) {
    m_history.push_back({m_clock.now_s(), X_RS});
    while (m_history.size() > 1 && m_history[1].time_s <= m_clock.now_s() - m_config.delay_s)
        m_history.pop_front();
}

Result<PoseReading> SimulatedSourceTracker::read() {
    if (m_lost || m_history.empty())
        return PoseReading{m_clock.now_s()};
    std::normal_distribution<double> noise(0.0, 1.0);
    const auto draw = [&](double deviation) {
        const double x = noise(m_random);
        const double y = noise(m_random);
        return Eigen::Vector3d(deviation * Eigen::Vector3d(x, y, noise(m_random)));
    };
    const Moment& moment = m_history.front();
    PoseReading reading{moment.time_s, moment.X_RS, true, moment.time_s};
    if (m_config.noise_rad > 0.0)
        reading.X_RS.linear() =
            poseFromRotationVector(Eigen::Vector3d::Zero(), draw(m_config.noise_rad)).linear() *
            moment.X_RS.linear();
    if (m_config.noise_m > 0.0)
        reading.X_RS.translation() += draw(m_config.noise_m);
    return reading;
}

} // namespace bask
