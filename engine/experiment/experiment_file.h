#pragma once
// An experiment as JSON: docs/experiment-format.md.

#include "engine/model/experiment.h"

#include <string>

namespace bask {

/// Reads an experiment file, resolving contours given as files relative to it; refuses unknown keys and wrong
/// types.
Result<Experiment> readExperiment(const std::string& path);
/// Same from text; `where` names it in errors, `folder` is where relative contour files are looked for.
Result<Experiment> experimentFromJson(const std::string& text, const std::string& where,
                                      const std::string& folder);
/// Self-contained, indented JSON: raw outlines and coefficients are embedded.
std::string experimentToJson(const Experiment& experiment);
/// Writes it, whole or not at all.
Result<void> writeExperiment(const Experiment& experiment, const std::string& path);

} // namespace bask
