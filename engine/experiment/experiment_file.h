#pragma once
// An experiment as JSON, see docs/experiment-format.md.

#include "engine/model/experiment.h"

#include <string>

namespace bask {

/// Reads an experiment file. Contours given as files are searched relative to it. Refuses unknown keys and
/// wrong types.
Result<Experiment> readExperiment(const std::string& path);
/// Like readExperiment, from text; `where` names it in errors, and relative contour files are searched in
/// `folder`.
Result<Experiment> experimentFromJson(const std::string& text, const std::string& where,
                                      const std::string& folder);
/// Returns self-contained, indented JSON with embedded outlines and coefficients.
std::string experimentToJson(const Experiment& experiment);
/// Writes the whole experiment or leaves the old file.
Result<void> writeExperiment(const Experiment& experiment, const std::string& path);

} // namespace bask
