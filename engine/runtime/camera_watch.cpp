#include "engine/runtime/camera_watch.h"

#include "engine/devices/video_camera.h"
#include "engine/rig/rig_setup.h"

#include <utility>

namespace bask {

struct CameraWatch::Chosen {
    explicit Chosen(const std::string& name) : camera(name, clock), vision(camera, name, clock) {}
    SteadyClock clock;
    VideoCamera camera;
    VisionThread vision;
};

CameraWatch::CameraWatch(BackgroundThread& closer) : m_closer(closer) {}
CameraWatch::~CameraWatch() = default;

namespace {

/// After a run the objects are hot, and are looked at until they have cooled.
bool mayShowBoard(const EngineSession& session) {
    const ServoLoop& loop = session.loop;
    return !loop.isArmedOrOn() && (!loop.isCooling() || loop.areObjectsCold());
}

} // namespace

void CameraWatch::watch(EngineSession& session, const WatchCamera& wanted) {
    m_wanted = wanted;
    if (session.simulated)
        session.simulated->simulatedCamera().setBoard(
            wanted.show && !m_chosen && mayShowBoard(session) ? wanted.board : std::nullopt);
    setTask(session);
}

void CameraWatch::watch(EngineSession& session, const WatchThermalCamera& wanted) {
    m_thermalWanted = wanted;
    const auto board = wanted.show && mayShowBoard(session) ? wanted.board : std::nullopt;
    if (auto* camera = session.simulated ? session.simulated->simulatedThermalCamera() : nullptr)
        camera->setBoard(board);
    if (session.thermometer)
        session.thermometer->camera().setBoardShown(board.has_value());
}

void CameraWatch::watchOn(EngineSession& session) {
    watch(session, m_wanted);
    watch(session, m_thermalWanted);
}

void CameraWatch::followRun(EngineSession& session) {
    const bool mayShow = mayShowBoard(session);
    if (std::exchange(m_mayShowBoard, mayShow) != mayShow && (m_wanted.board || m_thermalWanted.board))
        watchOn(session);
}

void CameraWatch::choose(EngineSession& session, const std::string& name) {
    close();
    m_chosen = name.empty() ? nullptr : std::make_unique<Chosen>(name);
    watchOn(session);
}

void CameraWatch::setTask(EngineSession& session) {
    const Experiment& experiment = session.loop.experiment();
    const VisionSpec& vision = experiment.vision;
    VisionTask task;
    task.layout = markerLayout(vision);
    task.camera = vision.camera;
    if (vision.cameraPose)
        task.X_RC = poseFromCoordinates(*vision.cameraPose);
    task.follow = experiment.source.tracked && vision.followsSource();
    if (mayShowBoard(session))
        task.board = m_wanted.board;
    task.show = m_wanted.show && !m_chosen;
    if (session.vision)
        session.vision->setTask(task);
    if (m_chosen) {
        task.follow = false;
        task.show = m_wanted.show;
        m_chosen->vision.setTask(task);
    }
}

void CameraWatch::close() {
    m_closer.dispose(std::move(m_chosen));
}

std::shared_ptr<const VisionView> CameraWatch::newest(const EngineSession* session) const {
    if (m_chosen)
        return m_chosen->vision.newest();
    return session != nullptr && session->vision ? session->vision->newest() : nullptr;
}

} // namespace bask
