#pragma once
// What the cameras are asked to look for: the rig's own, and one that was chosen instead of the simulated
// one.

#include "engine/runtime/background_thread.h"
#include "engine/runtime/command.h"
#include "engine/runtime/engine_session.h"

#include <memory>
#include <string>

namespace bask {

/// A picture that is looked at, and a driver that hangs, take their time: cameras are closed by `closer`.
class CameraWatch {
public:
    explicit CameraWatch(BackgroundThread& closer);
    ~CameraWatch();

    /// What a person wants to see, from now on.
    void watch(EngineSession& session, const WatchCamera& wanted);
    /// The same for another session or another task of it.
    void watchOn(EngineSession& session) { watch(session, m_wanted); }
    /// Puts the board away when a run begins, and out again after it: its search takes long, and a simulated
    /// one hides the source.
    void followRun(EngineSession& session);
    /// Another camera instead of the simulated one, by its name; empty: none. It is watched, never followed
    /// by, since it does not see the simulated rig.
    void choose(EngineSession& session, const std::string& name);
    void setTask(EngineSession& session);
    void close(); ///< the chosen one

    /// The newest look at what is watched, once finished; null: none. `session` may be null.
    std::shared_ptr<const VisionView> newest(const EngineSession* session) const;

private:
    struct Chosen;
    BackgroundThread& m_closer;
    WatchCamera m_wanted;
    bool m_isBoardOut = true;
    std::unique_ptr<Chosen> m_chosen;
};

} // namespace bask
