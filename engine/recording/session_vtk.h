#pragma once
// A recorded run as VTK files for ParaView: trajectories, outlines over time, fields over the workspace.

#include "engine/base/share_done.h"
#include "engine/recording/session_file.h"

#include <stop_token>
#include <string>
#include <vector>

namespace bask {

inline constexpr int kMaxOutlineSteps =
    200; ///< of the collection; evenly chosen where there are more samples

/// Writes all files or none into the folder and returns them. Everything is in the robot's base R, in m:
/// - trajectories.vtp: the path of each object's centre, one line for each, with time_s, measured_K,
/// estimated_K, target_K, error_K, view_factor, reading_valid and, if simulated, true_K as point data; object
/// as line data;
/// - end_effector.vtp: the path of its origin, with speeds, source_K and limits;
/// - outlines.pvd and outlines/*.vtp: outlines with holes of source (object 0) and objects (1, 2 ...) over
/// time, with temperature_K and target_K;
/// - view_factor_*.vti and steady_temperature_*.vti of each object, over the positions of its own centre in
/// the workspace, at the angles of the last sample before Stop (or of the experiment's start). Without
/// samples it writes the fields and the outlines at the start. Errors: FileUnwritable, OutputForeign if files
/// of another program are there, FieldCancelled.
Result<std::vector<std::string>> exportVtk(const SessionRecord& session, const std::string& folder,
                                           const std::stop_token& stop = {}, const ShareDone& done = {});

} // namespace bask
