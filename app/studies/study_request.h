#pragma once
// The studies of `bask study`, called with checked options: each does the work, writes its files into
// `folder`, prints its summary and returns an exit code; or does the work of one shard and writes its part.

#include "app/drawing/shard_run.h"
#include "engine/studies/alarm_draw.h"
#include "engine/studies/closed_loop_study.h"

#include <QString>
#include <nlohmann/json_fwd.hpp>

namespace bask {

int viewFactorStudyCommand(const QString& folder, int maxElements);

/// How the runs of a study are come by: computed here, or by shards and merged.
struct StudyWay {
    ShardOptions shard;
    const MergedParts* merged = nullptr; ///< null: computed

    const char* command() const { return merged != nullptr ? "merge" : "study"; }
};

enum class StudyMounting { Triangle, Line, Random, Heights };

/// Options of the closed-loop study; the rig is that of the three-object examples.
struct ClosedLoopRequest {
    ControllerKind controller = ControllerKind::LevelServo;
    SourceModel sourceModel = SourceModel::Gray;
    StudyMounting mounting = StudyMounting::Triangle;
    double rateError = 4.0;
    double convection_W_m2K = 0.0; ///< these three: as in ClosedLoopStudy
    double sensorLag_s = 0.0;
    double robotLatency_s = 0.0;
    double uneven = 0.0; ///< share
    int count = 200;
    std::uint64_t seed = 1;
    std::string asked = {}; ///< all this as PartHeader::work
};
int closedLoopStudyCommand(const QString& folder, const ClosedLoopRequest& request, const StudyWay& way);

struct AlarmRequest {
    AlarmDraw draw = AlarmDraw::Healthy;
    ReadBy readBy = ReadBy::Contact;
    int count = 200;
    std::uint64_t seed = 1;
    int first = 1;          ///< first random draw
    std::string asked = {}; ///< all this as PartHeader::work
};
/// Returns kExitNegative if there was a false alarm, or if a fault with effects was not detected.
int alarmStudyCommand(const QString& folder, const AlarmRequest& request, const StudyWay& way);

/// Writes the files of a study that was divided, and prints its summary. `work` is that of the parts, read.
int mergeStudy(const MergedParts& parts, const nlohmann::json& work, const QString& folder);

} // namespace bask
