#pragma once
// Tells the cameras what to look for: the camera of the rig, and a camera chosen instead of the simulated
// one.

#include "engine/runtime/background_thread.h"
#include "engine/runtime/command.h"
#include "engine/runtime/engine_session.h"

#include <memory>
#include <string>

namespace bask {

/// Cameras are closed by `closer`, because processing a picture, or a driver that does not respond, may take
/// long.
class CameraWatch {
public:
    explicit CameraWatch(BackgroundThread& closer);
    ~CameraWatch();

    /// Sets what a person wants to see from now on.
    void watch(EngineSession& session, const WatchCamera& wanted);
    void watch(EngineSession& session, const WatchThermalCamera& wanted);
    /// Applies the same to another session, or after the task of the session has changed.
    void watchOn(EngineSession& session);
    /// Removes the calibration boards when a run begins and restores them after the run: the search for one
    /// takes long, and a simulated board hides the rig.
    void followRun(EngineSession& session);
    /// Uses another camera, by its name, instead of the simulated one; an empty name uses none. It is only
    /// watched and does not follow the source, since it does not see the simulated rig.
    void choose(EngineSession& session, const std::string& name);
    void setTask(EngineSession& session);
    void close(); ///< closes the chosen camera

    bool isThermalWatched() const { return m_thermalWanted.show; }
    /// Returns the newest finished view of the watched camera; null if there is none. `session` may be null.
    std::shared_ptr<const VisionView> newest(const EngineSession* session) const;

private:
    struct Chosen;
    BackgroundThread& m_closer;
    WatchCamera m_wanted;
    WatchThermalCamera m_thermalWanted;
    bool m_mayShowBoard = true; ///< as it was when followRun() looked last
    std::unique_ptr<Chosen> m_chosen;
};

} // namespace bask
