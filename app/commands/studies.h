#pragma once
// The studies of `bask study`, each with its options checked: does the work, writes its files into `folder`,
// prints its summary and returns an exit code.

#include "engine/studies/alarm_draw.h"
#include "engine/studies/closed_loop_study.h"

#include <QString>

namespace bask {

int viewFactorStudyCommand(const QString& folder, int maxElements);

enum class StudyMounting { Triangle, Line, Random };

/// What is asked of the closed-loop study; the rig is the one of the three-object examples.
struct ClosedLoopRequest {
    ControllerKind controller = ControllerKind::LevelServo;
    SourceModel sourceModel = SourceModel::Gray;
    StudyMounting mounting = StudyMounting::Triangle;
    double rateError = 4.0;
    int count = 200;
    std::uint64_t seed = 1;
};
int closedLoopStudyCommand(const QString& folder, const ClosedLoopRequest& request);

struct AlarmRequest {
    AlarmDraw draw = AlarmDraw::Healthy;
    int count = 200;
    std::uint64_t seed = 1;
    int first = 1; ///< draw that is run first
};
/// Answers kExitNegative when an alarm was false, or a fault that showed itself was not found.
int alarmStudyCommand(const QString& folder, const AlarmRequest& request);

} // namespace bask
