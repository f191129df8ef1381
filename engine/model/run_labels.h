#pragma once
// What people say about a run: who operates, and what is heated.

#include "engine/base/result.h"

#include <string>

namespace bask {

/// Each is empty if nobody has said it.
struct RunLabels {
    std::string operatorName;
    std::string sample; ///< the specimen that is heated
    std::string batch;  ///< to which the sample belongs
    bool operator==(const RunLabels&) const = default;
};

/// Refuses what is no name (NameNotPlain), and more than 64 characters.
Result<void> validate(const RunLabels& labels);

} // namespace bask
