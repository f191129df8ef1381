#pragma once
// The studies of `bask study`, called with checked options: each does the work, or takes what shards have
// done, writes its files into `folder`, prints its summary and returns an exit code.

#include "app/studies/study_request.h"

namespace bask {

int viewFactorStudyCommand(const ViewFactorRequest& request, const QString& folder);

/// How the runs of a study are come by: computed here, or by shards and merged.
struct StudyWay {
    int threads = 0;                     ///< 0: one for each core
    const MergedParts* merged = nullptr; ///< null: computed

    const char* command() const { return merged != nullptr ? "merge" : "study"; }
};

int closedLoopStudyCommand(const ClosedLoopRequest& request, const QString& folder, const StudyWay& way);
/// Returns kExitNegative if there was a false alarm, or if a fault with effects was not detected.
int alarmStudyCommand(const AlarmRequest& request, const QString& folder, const StudyWay& way);

/// Writes the files of a study that was divided, and prints its summary. `work` is that of the parts, read.
int mergeStudy(const MergedParts& parts, const nlohmann::json& work, const QString& folder);

} // namespace bask
