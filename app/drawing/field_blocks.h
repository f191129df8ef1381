#pragma once
// A field that is sampled block by block: into its file, or into the part of a shard; and parts put together.

#include "app/studies/shard_run.h"
#include "engine/radiation/field_sampler.h"

#include <nlohmann/json_fwd.hpp>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace bask {

/// Samples of one block: the cases of a field that is divided. Few enough for many cores to have work, enough
/// that writing them takes no time.
inline constexpr std::size_t kFieldBlock = 8192;

/// What is printed of samples.
struct FieldFigures {
    FieldTally tally;
    double min = INFINITY, max = -INFINITY; ///< of those that have a value

    void add(const FieldFigures& more);
};

/// A file to be, and what is in it.
struct FieldFile {
    std::string path; ///< .vti or .h5; empty: nothing is written
    std::string title;
    bool withGradient = false;
};

/// Refuses other endings, files of other programs, and grids that the kind of file cannot hold.
Result<void> checkFieldOutput(const std::string& path, const std::vector<FieldAxis>& axes, bool withGradient);

/// Samples a whole field into its file.
Result<FieldFigures> sampleInto(const FieldFile& file, const FieldSampler& sampler, int threads);

/// Returns a field without samples as PartHeader::work, with what was asked for besides as a JSON object.
std::string fieldAsked(const FieldFile& file, const Field& header, const std::string& besides);
/// Returns the work of a shard; `sampler` must live as long.
DividedWork fieldWork(const FieldSampler& sampler, bool withGradient, std::string asked);

/// What was merged.
struct MergedField {
    Field header;
    FieldFigures figures;
};
/// Puts the parts of a field together; `work` is that of the parts, read. Errors: NotAPart, those of the
/// file.
Result<MergedField> mergeFieldInto(const MergedParts& parts, const nlohmann::json& work,
                                   const std::string& path);
/// The same with words, as a command: returns an exit code.
int mergeField(const MergedParts& parts, const nlohmann::json& work, const QString& path);

} // namespace bask
