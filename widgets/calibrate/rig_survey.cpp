#include "widgets/calibrate/rig_survey.h"

#include <algorithm>

namespace bask {
namespace {

constexpr double kThere = 2e-3; // m, rad
constexpr double kSame = 1e-6;

} // namespace

std::vector<Vector6d> surveyPoses(const RigGeometry& geometry, const Vector6d& from) {
    constexpr double kShift_m = 0.05, kLift_m = 0.06, kTurn_rad = 0.2;
    // Signs of x, y, z, theta_x, theta_y, theta_z.
    constexpr int kWays[][6] = {{1, 1, 0, 1, 0, 1},   {-1, 1, 1, 0, 1, -1}, {-1, -1, 0, -1, 0, 1},
                                {1, -1, 1, 0, -1, 0}, {0, 1, 2, 1, 1, 0},   {1, 0, 1, -1, -1, -1},
                                {-1, 0, 2, 1, -1, 1}, {0, -1, 0, -1, 1, -1}};
    const RobotLimits& limits = geometry.limits();
    const Eigen::Vector3d away = geometry.away();
    const double height_m = geometry.lowestPoint_m(from) - kSame;
    std::vector<Vector6d> poses;
    for (const auto& way : kWays) {
        Vector6d shift;
        shift << kShift_m * way[0], kShift_m * way[1], 0.0, kTurn_rad * way[3], kTurn_rad * way[4],
            kTurn_rad * way[5];
        const Eigen::Vector3d sideways = shift.head<3>() - away * away.dot(shift.head<3>());
        shift.head<3>() = sideways + away * (kLift_m * way[2] + 0.02);
        Vector6d pose = from;
        for (int k = 0; k < 6; ++k)
            if (limits.free[static_cast<std::size_t>(k)])
                pose[k] = std::clamp(from[k] + shift[k], std::min(limits.lower[k], from[k]),
                                     std::max(limits.upper[k], from[k]));
        const auto isSame = [&](const Vector6d& other) {
            return (other - pose).cwiseAbs().maxCoeff() < kThere;
        };
        const bool isNew = !isSame(from) && std::ranges::none_of(poses, isSame);
        if (isNew && geometry.allowed(pose) && geometry.lowestPoint_m(pose) >= height_m)
            poses.push_back(pose);
    }
    poses.push_back(from);
    return poses;
}

void RigSurvey::begin(std::vector<Vector6d> goals, int frames) {
    m_goals = std::move(goals);
    m_start = m_robot;
    m_frames = frames;
    m_goal = 0;
    m_views.clear();
    m_state = m_goals.empty() ? State::Standing : State::Travelling;
    m_goalTold = m_goals.empty();
    m_setOff = false;
    m_still_s.reset();
    m_sent_s.reset();
}

void RigSurvey::setRobot(const Vector6d& coordinates, bool isMoving) {
    if (isMoving || (coordinates - m_robot).cwiseAbs().maxCoeff() > kSame)
        m_still_s.reset();
    m_setOff = m_setOff || (m_goalTold && isMoving);
    m_robot = coordinates;
    m_isMoving = isMoving;
    if (m_state == State::Travelling && m_setOff && !isMoving && !isThere())
        cancel();
}

std::optional<Vector6d> RigSurvey::takeGoal() {
    if (m_state != State::Travelling || m_goalTold)
        return std::nullopt;
    m_goalTold = true;
    return m_goals[m_goal];
}

bool RigSurvey::isThere() const {
    return m_goalTold && !m_isMoving && (m_goals[m_goal] - m_robot).cwiseAbs().maxCoeff() < kThere;
}

bool RigSurvey::addFrame(double time_s, const MarkerFrame& frame) {
    if (!isOn() || m_isMoving)
        return false;
    if (m_state == State::Travelling) {
        if (!m_sent_s || time_s < *m_sent_s) // or the clock has begun anew
            m_sent_s = time_s;
        if (!isThere() && time_s - *m_sent_s < kNoMove_s)
            return false;
        m_state = State::Standing;
        m_still_s.reset();
    }
    if (!m_still_s || time_s < *m_still_s)
        m_still_s = time_s;
    if (time_s - *m_still_s < kStill_s)
        return false;
    if (m_views.size() <= m_goal)
        m_views.push_back({poseFromCoordinates(m_robot), {}});
    m_views.back().frames.push_back(frame);
    if (std::ssize(m_views.back().frames) >= m_frames)
        next();
    return true;
}

void RigSurvey::next() {
    ++m_goal;
    if (m_goal >= m_goals.size()) {
        m_state = State::Done;
        return;
    }
    m_state = State::Travelling;
    m_goalTold = false;
    m_setOff = false;
    m_sent_s.reset();
}

bool RigSurvey::hasMoved() const {
    const Eigen::Matrix4d start = poseFromCoordinates(m_start).matrix();
    return std::ranges::any_of(m_views, [&](const HandEyeView& view) {
        return (view.X_RE.matrix() - start).cwiseAbs().maxCoeff() > kThere;
    });
}

int RigSurvey::framesTaken() const {
    int taken = 0;
    for (const HandEyeView& view : m_views)
        taken += static_cast<int>(view.frames.size());
    return taken;
}

} // namespace bask
