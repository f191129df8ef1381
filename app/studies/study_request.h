#pragma once
// What is asked of `bask study`, read from its options and checked.

#include "app/studies/shard_run.h"
#include "engine/model/experiment.h"
#include "engine/studies/alarm_draw.h"

#include <QString>
#include <QStringList>
#include <nlohmann/json_fwd.hpp>

#include <variant>

namespace bask {

struct ViewFactorRequest {
    int maxElements = 0;
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

struct AlarmRequest {
    AlarmDraw draw = AlarmDraw::Healthy;
    ReadBy readBy = ReadBy::Contact;
    int count = 200;
    std::uint64_t seed = 1;
    int first = 1;          ///< first random draw
    std::string asked = {}; ///< all this as PartHeader::work
};

struct StudyRequest {
    std::variant<ViewFactorRequest, ClosedLoopRequest, AlarmRequest> study;
    QString folder;     ///< of the files
    ShardOptions shard; ///< of the studies that can be divided
};

/// A request, or an exit code: help was printed, or a refusal reported on standard error.
using AskedStudy = std::variant<StudyRequest, int>;

/// Reads the arguments after `study`.
AskedStudy readStudy(const QStringList& arguments);
/// Reads what parts of a study were asked for; `work` is that of the parts, read.
AskedStudy readMergedStudy(const nlohmann::json& work, const QString& folder);

} // namespace bask
