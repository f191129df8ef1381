#pragma once
// The run as it was predicted before Start, in a session's table `prediction` (docs/session-format.md).

#include "engine/model/predicted_run.h"
#include "engine/recording/session_store.h"

#include <string>
#include <vector>

namespace bask {

inline constexpr const char* kPredictedEndKey = "prediction"; ///< in the table meta: how it ends
/// Returns the word for it there: "settled", "limit", "cut" or "fault".
const char* predictedEndWord(PredictedEnd end);

/// Returns the last prediction of a session, with what it does not tell as NaN; without samples where there
/// is none. Places of the end-effector are not kept. Errors: a damaged file.
Result<PredictedRun> readPrediction(const SessionStore& store, const std::vector<std::string>& objects);

} // namespace bask
