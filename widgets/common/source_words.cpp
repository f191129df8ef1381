#include "widgets/common/source_words.h"

#include "widgets/common/device_words.h"
#include "widgets/common/display.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kRoughly_s = 10.0; ///< nobody is told seconds of an estimate

struct SourceWords {
    Q_DECLARE_TR_FUNCTIONS(bask::SourceWords)
};

} // namespace

double sourceGoal_K(const Snapshot& snapshot) {
    if (snapshot.heatSetPoint_K)
        return *snapshot.heatSetPoint_K;
    return snapshot.warmUp ? snapshot.warmUp->setPoint_K : std::numeric_limits<double>::quiet_NaN();
}

bool isSourceCold(const Snapshot& snapshot) {
    return snapshot.warmUp &&
           snapshot.warmUp->setPoint_K - sourceTemperature_K(snapshot) > SourceWarmUp::kWarm_K;
}

QString warmUpText(const SourceWarmUp& warmUp) {
    if (!warmUp.in_s)
        return SourceWords::tr("How long it takes to heat it is not known.");
    return SourceWords::tr("Heated from now on it takes about %1.")
        .arg(formatDuration(kRoughly_s * std::ceil(*warmUp.in_s / kRoughly_s)));
}

QString coldSourceText(const Snapshot& snapshot, TemperatureUnit unit) {
    const double goal_K = snapshot.warmUp->setPoint_K, now_K = sourceTemperature_K(snapshot);
    return SourceWords::tr("The source has %1, its set point is %2 (%3). Start does not wait for it: the run "
                           "begins, and its time counts, while the source warms up.")
               .arg(formatTemperature(now_K, unit, 0), formatTemperature(goal_K, unit, 0),
                    formatDifference(now_K - goal_K, unit, 0)) +
           u' ' + warmUpText(*snapshot.warmUp);
}

QString recordedUntilColdText(const Snapshot& snapshot, TemperatureUnit unit) {
    return SourceWords::tr("The run has ended. Its time and its recording go on until the source and the "
                           "objects are cold (source %1), or until the next Arm.")
        .arg(sourceReadingText(snapshot, unit));
}

} // namespace bask
