#pragma once
// A rig alone as a JSON file, to be used with other experiments: "format": "bask-rig", "version": 1.

#include "engine/base/result.h"
#include "engine/model/rig_spec.h"

#include <string>

namespace bask {

inline constexpr int kRigFormat = 1; ///< version written to and accepted from rig files

/// Whether a file says that it is one, sound or not.
bool isRigFile(const std::string& path);
/// Refuses unknown keys, wrong types and other formats; what depends on an experiment, such as the channels,
/// is checked where the rig is used.
Result<RigSpec> readRigFile(const std::string& path);
/// Writes it, whole or not at all.
Result<void> writeRigFile(const RigSpec& rig, const std::string& path);

} // namespace bask
