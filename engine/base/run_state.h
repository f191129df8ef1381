#pragma once
// The states of the run.

namespace bask {

/// States of the run, as the state bar shows them.
enum class RunState { Idle, NotReady, Ready, Armed, Running, Holding, Settled, Stopping, Stopped, Fault };

const char* runStateName(RunState state); ///< English: "Idle", "Not ready" ...

} // namespace bask
