#pragma once
// What the commands about thermal pictures take: the camera's profile and its frames.

#include "engine/thermography/camera_profile.h"
#include "engine/thermography/frame_decoder.h"

#include <optional>
#include <string>

class QCommandLineParser;

namespace bask {

/// Returns the profile of the option --profile; empty without it. Errors: those of findThermalProfile.
Result<std::optional<ThermalProfile>> profileOption(const QCommandLineParser& parser);

/// Prints what a person should know of a frame on standard error.
void tellWarnings(const char* command, const std::string& path, const ThermalFrame& frame);

} // namespace bask
