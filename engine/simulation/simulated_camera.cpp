#include "engine/simulation/simulated_camera.h"

#include "engine/base/message_code.h"
#include "engine/simulation/board_script.h"

#include <algorithm>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

SimulatedCameraConfig checked(SimulatedCameraConfig config) {
    if (!checkLayout(config.markers) || !(config.frameRate_Hz > 0.0) || config.camera.width < 1 ||
        config.camera.height < 1)
        throw std::invalid_argument("SimulatedCamera: a layout and a frame rate that can be used are needed");
    return config;
}

Error lost(const char* why) {
    return {MessageCode::CameraLost, "", {"simulated", why}};
}

} // namespace

Pose lookingAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& at) {
    const Eigen::Vector3d forward = (at - eye).normalized();
    Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ());
    if (right.norm() < 1e-6) // straight down or up
        right = Eigen::Vector3d::UnitX();
    right.normalize();
    Pose X = Pose::Identity();
    X.linear() << right, forward.cross(right), forward;
    X.translation() = eye;
    return X;
}

CameraModel usualCamera() {
    CameraModel camera;
    camera.width = 1280;
    camera.height = 720;
    camera.fx = 1002.0;
    camera.fy = 1000.0;
    camera.cx = 645.0;
    camera.cy = 354.0;
    camera.distortion = {-0.1, 0.03, 0.0005, -0.0003, 0.0};
    return camera;
}

Pose usualCameraPose() {
    return lookingAt({0.14, -0.5, 0.64}, {0.0, 0.01, 0.103});
}

SimulatedCamera::SimulatedCamera(SimulatedCameraConfig config)
    : m_config(checked(std::move(config))), m_markers(m_config.markers) {}

void SimulatedCamera::setMarkers(const MarkerLayout& markers) {
    if (!checkLayout(markers))
        throw std::invalid_argument("SimulatedCamera: a layout that can be used is needed");
    const std::scoped_lock lock(m_mutex);
    m_markers = markers;
    m_areMarkersNew = true;
}

void SimulatedCamera::prepare() {
    SimulatedCameraConfig now = m_config;
    {
        const std::scoped_lock lock(m_mutex);
        if (!std::exchange(m_areMarkersNew, false))
            return;
        now.markers = m_markers;
    }
    m_rig = rigFaces(now);
    m_hands = handFaces(now.markers);
    if (!m_renderer)
        m_renderer.emplace(now.camera, now.X_RC,
                           PictureQuality{now.noise_grey, now.blur_px, now.lightFall, now.seed});
}

void SimulatedCamera::observe(const SceneMoment& moment) {
    const std::scoped_lock lock(m_mutex);
    while (!m_observed.empty() && m_observed.back().moment.time_s >= moment.time_s) // a clock set back, too
        m_observed.pop_back();
    m_observed.push_back({moment, m_wall.now_s()});
    while (m_observed.size() > 1 && m_observed[1].moment.time_s <= moment.time_s - m_config.delay_s)
        m_observed.pop_front();
}

void SimulatedCamera::setBoard(std::optional<Board> board) {
    const std::scoped_lock lock(m_mutex);
    m_board.reset();
    if (board)
        m_board = ShownBoard{*board, m_observed.empty() ? 0.0 : m_observed.back().moment.time_s};
}

void SimulatedCamera::setCovered(bool covered) {
    const std::scoped_lock lock(m_mutex);
    m_isCovered = covered;
}

bool SimulatedCamera::isCovered() const {
    const std::scoped_lock lock(m_mutex);
    return m_isCovered;
}

void SimulatedCamera::setUnplugged(bool unplugged) {
    const std::scoped_lock lock(m_mutex);
    m_isUnplugged = unplugged;
}

bool SimulatedCamera::isUnplugged() const {
    const std::scoped_lock lock(m_mutex);
    return m_isUnplugged;
}

// Under the lock.
std::optional<SimulatedCamera::View> SimulatedCamera::view() const {
    if (m_observed.empty())
        return std::nullopt;
    const Observed &oldest = m_observed.front(), &newest = m_observed.back();
    View view{oldest, m_board, m_isCovered};
    SceneMoment& now = view.now.moment;
    now.time_s = newest.moment.time_s - m_config.delay_s;
    view.now.caught_s = newest.caught_s - m_config.delay_s;
    if (m_observed.size() > 1 && now.time_s > oldest.moment.time_s) {
        const SceneMoment &a = oldest.moment, &b = m_observed[1].moment;
        const double share = (now.time_s - a.time_s) / (b.time_s - a.time_s);
        now.X_RE = poseBetween(a.X_RE, b.X_RE, share);
        now.X_RS = poseBetween(a.X_RS, b.X_RS, share);
    }
    return view;
}

bool SimulatedCamera::isDue(const Observed& now, double wall_s) const {
    if (!m_frame)
        return true;
    const double period_s = 1.0 / m_config.frameRate_Hz, passed_s = now.moment.time_s - m_frame->time_s;
    constexpr double kJitter = 0.9; // of who asks at this rate, and would get every other frame
    if (m_config.isWallLimited && wall_s - m_rendered_s < kJitter * period_s)
        return false;
    return passed_s < 0.0 || passed_s > period_s - 1e-6; // before: the clock was set back
}

GreyPicture SimulatedCamera::rendered(const View& view, std::uint64_t number) {
    const Pose X_CR = m_config.X_RC.inverse();
    const auto X_CP = [&](Part part) -> Pose {
        if (part == Part::Base)
            return X_CR;
        return X_CR * (part == Part::Source ? view.now.moment.X_RS : view.now.moment.X_RE);
    };
    std::vector<PlacedFace> faces;
    const auto place = [&](const std::vector<PartFace>& parts) {
        for (const PartFace& part : parts)
            faces.push_back({&part.face, X_CP(part.part) * part.X_PF});
    };
    place(m_rig);
    if (view.isCovered)
        place(m_hands);
    std::vector<PlacedFace> onTop;
    SceneFace board;
    if (view.board) {
        board = boardFace(view.board->board);
        const Pose X_CB =
            boardPoseAt(view.board->board, m_config.camera, view.now.moment.time_s - view.board->since_s);
        onTop.push_back({&board, X_CB * Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX())});
    }
    return m_renderer->render(faces, onTop, number);
}

Result<std::shared_ptr<const CameraFrame>> SimulatedCamera::newest() {
    std::optional<View> seen;
    {
        const std::scoped_lock lock(m_mutex);
        if (m_isUnplugged)
            return lost("unplugged");
        seen = view();
    }
    if (!seen)
        return lost("not started");
    const double wall_s = m_wall.now_s();
    if (isDue(seen->now, wall_s)) {
        prepare();
        const std::uint64_t number = m_frame ? m_frame->number + 1 : 1;
        m_frame = std::make_shared<CameraFrame>(
            CameraFrame{seen->now.moment.time_s, seen->now.caught_s, number, rendered(*seen, number)});
        m_rendered_s = wall_s;
    }
    return m_frame;
}

} // namespace bask
