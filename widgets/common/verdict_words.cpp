#include "widgets/common/verdict_words.h"

#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kSameTemperature_K = 0.01;

struct VerdictWords {
    Q_DECLARE_TR_FUNCTIONS(bask::VerdictText)
};

/// Two view factors with as many decimals as it takes to tell them apart, at most four.
struct Pair {
    QString needed;
    QString bound;
};
Pair viewFactors(double needed, double bound) {
    int decimals = 2;
    while (decimals < 4 && std::abs(needed - bound) < std::pow(10.0, -decimals))
        ++decimals;
    return {QLocale().toString(needed, 'f', decimals), QLocale().toString(bound, 'f', decimals)};
}

} // namespace

FeasibilityVerdict verdictHere(const TargetVerdict& v) {
    if (v.verdict != FeasibilityVerdict::Reachable)
        return v.verdict;
    if (v.target_K > v.reachableMax_K + kReachedWithin_K)
        return FeasibilityVerdict::TooHot;
    if (v.target_K < v.reachableMin_K - kReachedWithin_K)
        return FeasibilityVerdict::TooCold;
    return FeasibilityVerdict::Reachable;
}

QString verdictWord(FeasibilityVerdict verdict) {
    switch (verdict) {
    case FeasibilityVerdict::TooHot:
        return VerdictWords::tr("Too hot");
    case FeasibilityVerdict::TooCold:
        return VerdictWords::tr("Too cold");
    case FeasibilityVerdict::Reachable:
        break;
    }
    return VerdictWords::tr("Reachable");
}

QString verdictDetail(const TargetVerdict& v, double environment_K, TemperatureUnit unit) {
    switch (verdictHere(v)) {
    case FeasibilityVerdict::TooHot: {
        const Pair f = viewFactors(v.neededViewFactor, v.reachableMax_F);
        return VerdictWords::tr("needs F = %1, at most %2 here; at most %3")
            .arg(f.needed, f.bound, formatTemperature(v.reachableMax_K, unit));
    }
    case FeasibilityVerdict::TooCold: {
        if (v.target_K < v.lowest_K && std::abs(v.lowest_K - environment_K) < kSameTemperature_K)
            return VerdictWords::tr("below the room's %1").arg(formatTemperature(environment_K, unit));
        if (v.target_K < v.lowest_K)
            return VerdictWords::tr("below the %1 it settles at far from the source")
                .arg(formatTemperature(v.lowest_K, unit));
        const Pair f = viewFactors(v.neededViewFactor, v.reachableMin_F);
        return VerdictWords::tr("needs F = %1, at least %2 here; at least %3")
            .arg(f.needed, f.bound, formatTemperature(v.reachableMin_K, unit));
    }
    case FeasibilityVerdict::Reachable:
        break;
    }
    const Pair f = viewFactors(v.neededViewFactor, v.reachableMax_F);
    return VerdictWords::tr("needs F = %1, up to %2 here").arg(f.needed, f.bound);
}

double nearestReachable_K(const TargetVerdict& v, TemperatureUnit unit) {
    const auto tenths = [unit](double t_K) { return displayTemperature(t_K, unit) * 10.0; };
    switch (verdictHere(v)) {
    case FeasibilityVerdict::TooHot:
        return kelvinFromDisplay(std::floor(tenths(v.reachableMax_K)) / 10.0, unit);
    case FeasibilityVerdict::TooCold:
        return kelvinFromDisplay(std::ceil(tenths(std::max(v.reachableMin_K, v.lowest_K)) - 1e-9) / 10.0,
                                 unit);
    case FeasibilityVerdict::Reachable:
        break;
    }
    return v.target_K;
}

QString axisName(int coordinate) {
    static const QStringList kNames{"x", "y", "z", "\u03b8x", "\u03b8y", "\u03b8z"};
    return kNames[coordinate];
}

QString coordinateText(int coordinate, double value) {
    constexpr double kCmPerM = 100.0;
    return coordinate < kThetaX
               ? QStringLiteral("%1 %2 cm").arg(axisName(coordinate), formatSigned(value * kCmPerM, 1))
               : QStringLiteral("%1 %2\u00b0").arg(axisName(coordinate), formatSigned(degFromRad(value), 1));
}

QString poseText(const Vector6d& pose, const RobotLimits& robot) {
    const Vector6d minShown = (Vector6d() << Eigen::Vector3d::Constant(0.05 / 100.0),
                               Eigen::Vector3d::Constant(radFromDeg(0.05)))
                                  .finished(); // half a tenth of a cm or degree
    QStringList parts;
    for (int k = 0; k < 6; ++k)
        if (robot.free[static_cast<std::size_t>(k)] || std::abs(pose[k]) >= minShown[k])
            parts << coordinateText(k, pose[k]);
    return parts.join(listSeparator());
}

QString marginText(const PoseMargin& margin) {
    if (margin.limit == Limit::Workspace && margin.coordinate >= kThetaX)
        return QLocale().toString(degFromRad(margin.distance_m / kRadianLength_m), 'f', 1) + u'\u00b0';
    return QLocale().toString(margin.distance_m * 100.0, 'f', 1) + QStringLiteral("\u00a0cm");
}

QString limitWord(const PoseMargin& margin) {
    return margin.limit == Limit::Clearance
               ? VerdictWords::tr("clearance")
               : VerdictWords::tr("workspace %1").arg(axisName(margin.coordinate));
}

} // namespace bask
