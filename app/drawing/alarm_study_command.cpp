// bask study alarms: whether the engine's alarms are true, over healthy and faulty runs at random.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/studies.h"
#include "app/studies/study_work.h"
#include "engine/studies/row_bytes.h"

#include <cstdio>

namespace bask {
namespace {

void printFaults(const AlarmSummary& summary) {
    if (summary.faults.empty())
        return;
    std::printf("%-20s %6s %6s %6s %6s %9s %9s %9s %10s\n", "fault", "draws", "shown", "found", "acted",
                "rate %", "median s", "worst s", "unseen K");
    for (const FaultSummary& fault : summary.faults)
        std::printf("%-20s %6d %6d %6d %6d %9.1f %9.1f %9.1f %10.1f\n", simulatedFaultName(fault.fault),
                    fault.draws, fault.shown, fault.found, fault.acted,
                    fault.shown > 0 ? 100.0 * fault.found / fault.shown : 100.0, fault.median_s,
                    fault.worst_s, fault.unseen_K);
}

void printSummary(const AlarmStudy& study, const std::vector<AlarmStudyRow>& rows) {
    int run = study.first;
    for (const AlarmStudyRow& row : rows) {
        if (!row.refusal.empty())
            std::printf("run %d was not begun: %s\n", run, row.refusal.c_str());
        for (const RaisedAlarm& alarm : row.alarms)
            if (alarm.isFalse)
                std::printf("run %d, %.0f s, false: %s\n", run, alarm.time_s, alarm.sentence.c_str());
        ++run;
    }
    const AlarmSummary summary = summarize(rows);
    printFaults(summary);
    const int all = summary.alarms[0] + summary.alarms[1] + summary.alarms[2];
    for (std::size_t p = 0; p < summary.alarms.size(); ++p)
        std::printf("alarms of priority %zu: %d (%.0f %%), %.3f per 10 minutes\n", p + 1, summary.alarms[p],
                    all > 0 ? 100.0 * summary.alarms[p] / all : 0.0, summary.per10min[p]);
    if (!summary.faults.empty())
        std::printf("with each fault as often as in a laboratory (estimated, see docs/safety.md): "
                    "priorities 1, 2, 3: %.0f, %.0f, %.0f %%\n",
                    100.0 * summary.shares[0], 100.0 * summary.shares[1], 100.0 * summary.shares[2]);
    std::printf("most alarms of one run within 10 minutes: %d\n", summary.maxIn10min);
    std::printf("hottest true temperature over its trip limit: %.1f K\n", summary.overTrip_K);
    std::printf("simulated: %.1f h in %zu runs\n", summary.hours, rows.size());
    if (study.draw != AlarmDraw::Faulty)
        std::printf("false trips: %d (%.4f per hour), false words: %d (%.4f per hour)\n", summary.falseTrips,
                    summary.falseTrips / summary.hours, summary.falseWords,
                    summary.falseWords / summary.hours);
}

/// Whether all is as it has to be: no false word, and every fault that showed itself was found.
bool isMet(const AlarmSummary& summary) {
    for (const FaultSummary& fault : summary.faults)
        if (fault.found < fault.shown)
            return false;
    return summary.falseTrips == 0 && summary.falseWords == 0;
}

Result<std::vector<AlarmStudyRow>> rowsOf(const AlarmStudy& study, const StudyWay& way) {
    if (way.merged == nullptr) {
        Progress progress(study.count, "runs");
        return runAlarmStudy(study, way.threads, [&](int done) { progress.tell(done); });
    }
    return mergedRows<AlarmStudyRow>(*way.merged, study.count, alarmRowOf);
}

} // namespace

int alarmStudyCommand(const AlarmRequest& request, const QString& folder, const StudyWay& way) {
    const auto files = studyFiles(way.command(), folder, namesOf(request));
    if (!files)
        return kExitBadInput;
    const auto study = studyOf(request);
    if (!study)
        return refuse(way.command(), study.error());
    const auto rows = rowsOf(*study, way);
    if (!rows)
        return refuse(way.command(), rows.error());
    if (const auto written = writeFiles(*files, {alarmCsv(*study, *rows)}); !written)
        return refuse(way.command(), written.error());
    printSummary(*study, *rows);
    return isMet(summarize(*rows)) ? kExitDone : kExitNegative;
}

} // namespace bask
