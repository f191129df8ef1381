#pragma once
// A rig alone as a JSON file, to be used with other experiments: "format": "bask-rig", "version": 1.

#include "engine/base/result.h"
#include "engine/model/rig_spec.h"

#include <string>

namespace bask {

inline constexpr int kRigFormat = 1; ///< version written to and accepted from rig files

/// Returns whether a file declares that it is a rig file, valid or not.
bool isRigFile(const std::string& path);
/// Reads a rig file. Refuses unknown keys, wrong types and other formats; what depends on an experiment, such
/// as the channels, is checked where the rig is used.
Result<RigSpec> readRigFile(const std::string& path);
/// Writes the whole rig or leaves the old file.
Result<void> writeRigFile(const RigSpec& rig, const std::string& path);

} // namespace bask
