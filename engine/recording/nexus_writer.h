#pragma once
// What the NeXus file of a recorded run holds: NeXus base classes and nothing that they do not have
// (nexusformat/definitions), docs/exports.md.

#include "engine/base/share_done.h"
#include "engine/exchange/hdf5_file.h"
#include "engine/recording/session_file.h"
#include "engine/thermography/camera_profile.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Where the pictures of the thermal camera are in the file.
inline constexpr const char* kNexusPictures = "/entry/instrument/thermal_camera/data";

/// The recorded pictures of a session, but for their pixels.
struct ThermalPictures {
    ThermalProfile profile;
    std::vector<double> times_s;
};

/// Writes all but the pixels of the pictures, for which it makes room; `name` is the file's. The root's
/// attributes come first, and of them the program's name.
void writeNexus(Hdf5File& file, const SessionRecord& session, const std::string& name,
                const std::optional<ThermalPictures>& pictures, const ShareDone& done = {});

} // namespace bask
