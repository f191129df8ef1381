#pragma once
// A sampled field of up to six axes as an HDF5 file (.h5), which is filled in range by range, so that memory
// holds a few ranges and not the field.

#include "engine/radiation/field_sampler.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace bask {

/// Refuses an existing file that is not a field of Bask's (an empty one may be replaced).
Result<void> checkFieldStore(const std::string& path);

/// Bytes that a field takes.
double fieldStoreBytes(const Field& header, bool withGradient);

/// Writes a field completely or not at all: it is filled in under another name beside its place.
///
/// The layout is NeXus's: /entry/field (NXdata) has the samples as "view_factor" or "steady_temperature",
/// indexed by the axes from the last to the first (the first one runs fastest), its axes as one-dimensional
/// data of their names with units m and rad, and "view_factor_gradient" (1/m, 1/rad) with a last index of
/// six, by the pose coordinates. /entry/held: the coordinates that are not axes. /entry/sampling: tolerance,
/// undefined_samples, samples_above_tolerance, largest_error_estimate, rough_shade (1 or 0).
class FieldStore {
public:
    /// `header` is a field without samples. Takes the room on the disk at once. Errors: FileUnwritable, those
    /// of checkFieldStore.
    static Result<std::unique_ptr<FieldStore>> create(const std::string& path, const Field& header,
                                                      bool withGradient, const std::string& title);
    ~FieldStore();
    FieldStore(const FieldStore&) = delete;
    FieldStore& operator=(const FieldStore&) = delete;

    /// Writes samples from number `begin` on, six numbers of gradient for each (none without). Thread-safe.
    Result<void> write(std::size_t begin, std::span<const double> values, std::span<const double> gradient);
    /// Call when every sample is written: the file takes its place.
    Result<void> finish(const FieldTally& tally);

private:
    struct Impl;
    explicit FieldStore(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> m_impl;
};

} // namespace bask
