#include "engine/runtime/frozen_watch.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kMark_s = 3.0;    // between two marks
constexpr double kAnchor_s = 10.0; // between two anchors
constexpr std::size_t kAnchors = 6;
constexpr int kMinEqual = 3;             // readings
constexpr double kMinSame_s = 6.0;       // some devices repeat their readings
constexpr double kTimesRepeat = 3.0;     // as long as they do is no fault
constexpr double kJumped = 1.5;          // steps: what a sensor that does not repeat seldom changes by
constexpr std::size_t kMinPoints = 5;    // of a fit
constexpr double kWrong = 0.05;          // of the energy, as source, pose and air change
constexpr double kTimesAtOnce = 2.0;     // a device that repeats its readings shows their changes at once
constexpr double kUnknownStep_K = 0.5;   // of a sensor that has not changed yet
constexpr double kRoomGuessed_K = 2.5;   // standard deviation of the room before the sensor is zeroed,
constexpr double kRoomMeasured_K = 0.15; // and after
constexpr double kRoomDrift_K_s = 1.0 / 3600.0;
constexpr double kNoisy = 4.0;           // standard deviations of noise between two readings
constexpr double kNewNoise = 0.02;       // weight of one reading
constexpr double kSecondOfNoise = 1.954; // mean of |x1 - 2 x2 + x3| over the deviation of normal readings

} // namespace

FrozenWatch::FrozenWatch(LossRange losses, double environment_K)
    : m_losses(losses), m_room{environment_K, kRoomGuessed_K} {}

void FrozenWatch::reset() {
    m_marks.clear();
    m_anchors.clear();
    m_now = {};
    m_count = m_same = 0;
    m_step_K = m_noise_K = m_missing_K = m_repeat_s = 0.0;
}

void FrozenWatch::restAt(double time_s, double temperature_K) {
    const double power_K_s = m_count > 0 ? m_power.now_K_s() : 0.0;
    reset();
    m_room = {temperature_K, kRoomMeasured_K, power_K_s};
    m_rest_s = time_s;
}

/// What the sensor was zeroed by, as if it had lasted a while: a run may begin at once.
void FrozenWatch::rememberRest() {
    for (auto i = static_cast<double>(kMinPoints); i > 0.0; i -= 1.0) {
        Mark& mark = m_marks.emplace_back();
        const double ago_s = i * kMark_s;
        mark.time_s = m_now.time_s - ago_s;
        mark.temperature_K = m_room.temperature_K;
        mark.integral_K_s = (m_first_K - m_room.temperature_K) * ago_s;
        mark.energy_K.fill(-m_room.rest_K_s * ago_s);
    }
}

double FrozenWatch::step_K() const {
    return m_step_K > 0.0 ? m_step_K : kUnknownStep_K;
}

void FrozenWatch::integrate(double dt_s, double power_K_s) {
    m_power.advance(dt_s, power_K_s, m_now.energy_K);
    m_now.integral_K_s += (m_now.temperature_K - m_first_K) * dt_s;
}

void FrozenWatch::add(double time_s, std::optional<double> temperature_K, double power_K_s) {
    if (std::isnan(power_K_s)) // the object's position is not known
        return reset();
    if (m_count == 0 && !temperature_K)
        return;
    const bool wasAtRest = m_count == 0 && time_s - m_rest_s <= kMark_s;
    if (m_count == 0) {
        m_power.begin(wasAtRest ? m_room.rest_K_s : power_K_s);
        m_first_K = *temperature_K;
    } else {
        integrate(time_s - m_now.time_s, power_K_s);
    }
    m_now.time_s = time_s;
    if (wasAtRest)
        rememberRest();
    if (temperature_K)
        take(*temperature_K);
}

void FrozenWatch::take(double temperature_K) {
    const double change_K = m_count > 0 ? std::abs(temperature_K - m_now.temperature_K) : 0.0;
    if (m_count > 1 && m_same < kMinEqual) { // a frozen sensor has none
        const double noise_K =
            std::abs(temperature_K - 2.0 * m_now.temperature_K + m_before_K) / kSecondOfNoise;
        m_noise_K += std::max(kNewNoise, 1.0 / (m_count - 1)) * (noise_K - m_noise_K);
    }
    m_before_K = m_now.temperature_K;
    m_now.temperature_K = temperature_K;
    m_now.jump_K = std::max(m_now.jump_K, change_K);
    if (m_count++ == 0 || change_K > 0.0) {
        if (change_K > 0.0)
            m_step_K = m_step_K > 0.0 ? std::min(m_step_K, change_K) : change_K;
        if (m_same > 1 && change_K > kJumped * m_step_K) // while it was the same the device had more to say
            m_repeat_s = std::max(m_repeat_s, m_now.time_s - m_anchors.front().mark.time_s);
        m_same = 1;
        m_anchors.assign(1, Anchor{m_now});
    } else {
        ++m_same;
        if (m_now.time_s - m_anchors.back().mark.time_s >= kAnchor_s)
            m_anchors.push_back(Anchor{m_now});
        if (m_anchors.size() > kAnchors) // what is before the first reading is surely good
            m_anchors.erase(m_anchors.begin() + 1);
    }
    if (m_marks.empty() || m_now.time_s - m_marks.back().time_s >= kMark_s) {
        m_marks.push_back(m_now);
        m_now.jump_K = 0.0;
    }
    const double oldest_s =
        m_anchors.front().isFitted ? m_now.time_s - kAnchor_s : m_anchors.front().mark.time_s;
    while (m_marks.front().time_s < oldest_s - kWindow_s)
        m_marks.pop_front();
    judge();
}

void FrozenWatch::fit(Anchor& anchor) const {
    anchor.isFitted = true;
    const Mark& at = anchor.mark;
    std::vector<Mark> marks;
    for (const Mark& mark : m_marks)
        if (mark.time_s >= at.time_s - kWindow_s && mark.time_s < at.time_s)
            marks.push_back(mark);
    marks.push_back(at);
    if (marks.size() < kMinPoints)
        return;
    anchor.usual_K = step_K();
    for (const Mark& mark : marks)
        anchor.usual_K = std::max(anchor.usual_K, mark.jump_K - kNoisy * m_noise_K);
    const auto count = static_cast<Eigen::Index>(marks.size());
    Eigen::MatrixX3d design(count, 3);
    Eigen::VectorXd change_K(count);
    std::vector<Eigen::VectorXd> energies_K(LaggedPower::kLags_s.size(), Eigen::VectorXd(count));
    for (Eigen::Index i = 0; i < count; ++i) {
        const Mark& mark = marks[static_cast<std::size_t>(i)];
        const double since_s = mark.time_s - at.time_s;
        design.row(i) << 1.0, -since_s,
            at.integral_K_s - mark.integral_K_s + (at.temperature_K - m_first_K) * since_s;
        change_K[i] = mark.temperature_K - at.temperature_K;
        for (std::size_t lag = 0; lag < LaggedPower::kLags_s.size(); ++lag)
            energies_K[lag][i] = mark.energy_K[lag] - at.energy_K[lag];
    }
    LossFit::Room room = m_room;
    room.deviation_K = std::min(kRoomGuessed_K, room.deviation_K + kRoomDrift_K_s * (at.time_s - m_rest_s));
    const LossFit fit(m_losses, room, at.temperature_K, std::move(design), std::move(change_K));
    anchor.explanations = fit.explain(energies_K, std::max(step_K() / std::sqrt(12.0), m_noise_K));
}

/// The smallest change since an anchor that an explanation demands, with its sign; 0 if the sign is not
/// certain.
double FrozenWatch::expected_K(const Anchor& anchor) const {
    double min_K = 1e300, max_K = -1e300;
    const double time_s = m_now.time_s - anchor.mark.time_s;
    for (std::size_t lag = 0; lag < anchor.explanations.size(); ++lag)
        for (const LossFit::Explanation& each : anchor.explanations[lag]) {
            const double energy_K = m_now.energy_K[lag] - anchor.mark.energy_K[lag];
            const double change_K = each.k * energy_K - each.loss_K_s * time_s;
            const double sure_K = each.unsure_K_s * time_s + kWrong * each.k * std::abs(energy_K);
            min_K = std::min(min_K, change_K - sure_K);
            max_K = std::max(max_K, change_K + sure_K);
        }
    return min_K > 0.0 ? min_K : std::min(max_K, 0.0);
}

void FrozenWatch::judge() {
    m_missing_K = 0.0;
    const double same_s = m_now.time_s - m_anchors.front().mark.time_s;
    if (m_same < kMinEqual || same_s < std::max(kMinSame_s, kTimesRepeat * m_repeat_s))
        return;
    for (Anchor& anchor : m_anchors) {
        if (!anchor.isFitted)
            fit(anchor);
        if (anchor.explanations.empty())
            continue;
        const double missing_K = expected_K(anchor);
        if (std::abs(missing_K) > std::max(kMin_K, kTimesAtOnce * (anchor.usual_K + step_K())) &&
            std::abs(missing_K) > std::abs(m_missing_K))
            m_missing_K = missing_K;
    }
}

} // namespace bask
