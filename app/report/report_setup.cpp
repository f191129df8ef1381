#include "app/report/report_setup.h"

#include "app/report/html_text.h"
#include "engine/base/message_code.h"
#include "engine/control/controller_catalogue.h"
#include "engine/model/experiment_parameters.h"
#include "engine/model/experiment_rig.h"
#include "engine/model/material_library.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/belief_words.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/evenness_words.h"
#include "widgets/common/parameter_form.h"
#include "widgets/common/verdict_words.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using html::facts;
using html::heading;
using html::paragraph;
using html::subheading;
using Facts = QList<std::pair<QString, QString>>;

struct SetupText {
    Q_DECLARE_TR_FUNCTIONS(bask::RunReport)
};

QString number(double value, int digits = 4) {
    return std::isfinite(value) ? QLocale().toString(value, 'g', digits) : SetupText::tr("not known");
}

QString axis(int coordinate) {
    static const QStringList kNames{"x", "y", "z", "\u03b8x", "\u03b8y", "\u03b8z"};
    return kNames[coordinate];
}

QString coordinate(int k, double value) {
    return k < kThetaX ? QStringLiteral("%1\u00a0%2\u00a0cm").arg(axis(k), formatSigned(100.0 * value, 2))
                       : QStringLiteral("%1\u00a0%2\u00b0").arg(axis(k), formatSigned(degFromRad(value), 2));
}

QString poseWords(const Vector6d& pose) {
    QStringList parts;
    for (int k = 0; k < 6; ++k)
        if (k < 3 || std::abs(pose[k]) > 1e-6)
            parts << coordinate(k, pose[k]);
    return parts.join(listSeparator());
}

QString shapeWords(const Shape& shape) {
    QString words;
    if (const auto* disk = outlineAs<Disk>(shape))
        words = SetupText::tr("disk, radius %1 mm").arg(number(1e3 * disk->radius_m));
    else if (outlineAs<FourierContour>(shape) != nullptr)
        words = SetupText::tr("Fourier contour, radius %1 mm").arg(number(1e3 * shapeRadius(shape)));
    else
        words = SetupText::tr("polygon, radius %1 mm").arg(number(1e3 * shapeRadius(shape)));
    if (const auto holes = static_cast<int>(holesOf(shape).size()); holes > 0)
        words += QStringLiteral(", ") + SetupText::tr("%n hole(s)", nullptr, holes);
    return words;
}

QString airWords(const Air& air) {
    if (air.isNatural)
        return SetupText::tr("natural convection, by correlation");
    if (air.convection_W_m2K)
        return SetupText::tr("convection h = %1 W/(m\u00b2 K)").arg(number(*air.convection_W_m2K));
    return SetupText::tr("convection not known, not counted");
}

QString area(const Shape& shape) {
    return number(1e4 * shapeArea(shape), 4) + QStringLiteral("\u00a0cm\u00b2");
}

QString date(const std::string& iso) {
    const QDateTime time = QDateTime::fromString(QString::fromStdString(iso), Qt::ISODate);
    return time.isValid()
               ? QLocale().toString(time.toUTC(), QStringLiteral("yyyy-MM-dd HH:mm")) + QStringLiteral(" UTC")
               : SetupText::tr("date not known");
}

Facts rigFacts(const SessionRecord& session) {
    const Experiment& e = session.experiment;
    if (session.simulated || !e.rig)
        return {{SetupText::tr("Rig"), session.simulated
                                           ? SetupText::tr("simulated, seed %1").arg(e.simulation.seed)
                                           : SetupText::tr("not known")}};
    Facts rows{{SetupText::tr("Rig"),
                e.rig->name.empty() ? SetupText::tr("without a name") : QString::fromStdString(e.rig->name)}};
    for (const DeviceRole role : kDeviceRoles)
        rows << std::pair(
            roleWord(role),
            hasDevice(*e.rig, role)
                ? (QStringList(driverText(*e.rig, role)) << portText(*e.rig, role)).join(QStringLiteral("  "))
                : SetupText::tr("none"));
    return rows;
}

/// Measured, with the set point of that moment: objects that settle over a source on its way are not as warm
/// by another one.
QString sourceReadings(const SessionRecord& session, TemperatureUnit unit) {
    QStringList parts;
    const auto add = [&](const QString& when, const TraceSample& sample) {
        if (std::isfinite(sample.source_K))
            parts << SetupText::tr("%1 %2 (set point %3)", "when: the source's temperature")
                         .arg(when, formatTemperature(sample.source_K, unit),
                              formatTemperature(sourceSetPoint_K(session.experiment.source, sample.time_s),
                                                unit));
    };
    const std::vector<TraceSample> samples = session.controlledSamples();
    if (samples.empty())
        return SetupText::tr("not known");
    add(SetupText::tr("at Start"), samples.front());
    for (const TraceEvent& event : session.events) {
        const auto settled = std::ranges::lower_bound(samples, event.time_s, {}, &TraceSample::time_s);
        if (event.message.code == MessageCode::EventSettled && settled != samples.end())
            add(SetupText::tr("settled at %1 s").arg(QLocale().toString(event.time_s, 'f', 1)), *settled);
    }
    add(SetupText::tr("at the end of control"), samples.back());
    return parts.isEmpty() ? SetupText::tr("not known") : parts.join(QStringLiteral("; "));
}

Facts sourceFacts(const SessionRecord& session, TemperatureUnit unit) {
    const SourceSpec& source = session.experiment.source;
    Facts facts{
        {SetupText::tr("Heat source"), shapeWords(source.shape) + QStringLiteral(", ") + area(source.shape)},
        {SetupText::tr("Set temperature"),
         formatTemperature(source.temperature_K, unit) +
             (source.temperatureProfile.empty() ? QString()
                                                : SetupText::tr(", changing by a profile during the run"))},
        {SetupText::tr("Source in the run"), sourceReadings(session, unit)},
        {SetupText::tr("Emittance of the source"), number(source.emittance)},
        {SetupText::tr("Model of the source"), source.model == SourceModel::Gray
                                                   ? SetupText::tr("grey, with reflection")
                                                   : SetupText::tr("as in the paper, without reflection")},
        {SetupText::tr("Pose of the source in the robot's base"),
         poseWords(source.pose) + (source.tracked ? SetupText::tr(", tracked during the run") : QString())},
        {SetupText::tr("Surroundings"), formatTemperature(session.experiment.environment_K, unit)},
        {SetupText::tr("Air"), airWords(session.experiment.air)}};
    if (!source.uneven.isEven())
        facts.insert(4, {SetupText::tr("Evenness of the source"), evennessText(session.experiment)});
    return facts;
}

Facts robotFacts(const Experiment& e) {
    QStringList free, bounds;
    for (int k = 0; k < 6; ++k) {
        if (!e.robot.free[static_cast<std::size_t>(k)])
            continue;
        free << axis(k);
        bounds << SetupText::tr("%1 to %2")
                      .arg(coordinate(k, e.robot.lower[k]),
                           coordinate(k, e.robot.upper[k]).section(u'\u00a0', 1));
    }
    QString speed =
        SetupText::tr("%1 mm/s and %2 \u00b0/s")
            .arg(number(1e3 * e.robot.maxSpeed_m_s), number(degFromRad(e.robot.maxRotation_rad_s)));
    return {{SetupText::tr("Free axes"), free.join(QStringLiteral(", "))},
            {SetupText::tr("Workspace"), bounds.join(QStringLiteral("; "))},
            {SetupText::tr("Speed limits"), speed},
            {SetupText::tr("Clearance to the source's plane"), formatLength_mm(e.robot.clearance_m)},
            {SetupText::tr("Start pose"), poseWords(e.start)}};
}

Facts controllerFacts(const Experiment& e) {
    const ControllerSettings& c = e.controller;
    QStringList gains;
    for (const ControllerGain& gain : controllerEntry(c.kind).gains) {
        const QString name = *gain.facts->symbol != '\0'
                                 ? QString::fromUtf8(gain.facts->symbol) + QStringLiteral(" = ")
                                 : parameterLabel(*gain.facts).toLower() + u' ';
        gains << name + number(gain.get(c)) + QChar(0x00a0) + QString::fromUtf8(gain.facts->unit.symbol);
    }
    return {{SetupText::tr("Controller"), controllerWord(c.kind)},
            {SetupText::tr("Gains at the start"), gains.join(listSeparator())},
            {SetupText::tr("Sampling"), SetupText::tr("every %1 s").arg(number(e.sampling.period_s))}};
}

/// \u03bb1 and \u03bb2 by the material and as the controller had them at the first sample; empty where no
/// sample has them.
QString beliefTable(const SessionRecord& session) {
    if (session.samples.empty())
        return {};
    const Surroundings surroundings = surroundingsOf(session.experiment);
    html::Table table({SetupText::tr("Object"), SetupText::tr("\u03bb\u2081 at Start (K/s)"),
                       SetupText::tr("by the material"),
                       SetupText::tr("\u03bb\u2082 at Start (1/(K\u00b3 s))"),
                       SetupText::tr("by the material"), SetupText::tr("Where from")},
                      {1, 2, 3, 4});
    bool isKnown = false;
    for (std::size_t i = 0; i < session.experiment.objects.size(); ++i) {
        const ObjectSpec& object = session.experiment.objects[i];
        const ObjectSample& first = session.samples.front().objects[i];
        const HeatRates material = heatRates(object, surroundings);
        isKnown = isKnown || std::isfinite(first.lambda1);
        table.add({QString::fromStdString(object.name), number(first.lambda1), number(material.lambda1),
                   number(first.lambda2), number(material.lambda2),
                   object.estimatedRates ? SetupText::tr("given by the experiment")
                   : session.experiment.controller.estimatedRateErrorFactor > 1.0
                       ? SetupText::tr("the material, made wrong")
                       : SetupText::tr("the material")});
    }
    return isKnown ? table.text() : QString();
}

/// With which heat rates the controller began: a comparison of controllers is one of these, too.
QString beliefSection(const SessionRecord& session) {
    const QString wrong = wrongRatesText(session.experiment), table = beliefTable(session);
    if (wrong.isEmpty() && table.isEmpty())
        return {};
    return subheading(SetupText::tr("Heat rates with which the controller began")) +
           (wrong.isEmpty() ? QString() : paragraph(wrong)) + table;
}

QString limitWords(const Parameter<SafetySpec>& limit, double si, TemperatureUnit unit) {
    if (limit.unit.edge == EdgeUnit::Temperature)
        return formatTemperature(si, unit, limit.decimals);
    const QString symbol = QString::fromUtf8(limit.unit.symbol);
    const QString text = QLocale().toString(si * limit.unit.symbolPerSi, 'f', limit.decimals);
    return symbol.isEmpty() ? text : text + QChar(0x00a0) + symbol;
}

/// Limits that follow from the experiment by themselves are left out.
Facts limitFacts(const SafetySpec& safety, TemperatureUnit unit) {
    Facts out;
    for (const Parameter<SafetySpec>& limit : safetyParameters())
        if (const std::optional<double> si = limit.get(safety))
            out.append({parameterLabel(limit), limitWords(limit, *si, unit)});
    return out;
}

/// Name, source and date, as far as the experiment has them.
QString materialWords(const Material& material) {
    const QString words =
        material.name.empty() ? SetupText::tr("without a name") : QString::fromStdString(material.name);
    const std::string origin = originText(material);
    return origin.empty() ? words : words + QStringLiteral(", ") + QString::fromStdString(origin);
}

/// "0.87 ± 0.017" with its standard uncertainty, where the experiment has one.
QString materialValue(const Material& material, const Parameter<Material>& value) {
    const double scale = value.unit.symbolPerSi;
    const QString text = number(value.get(material).value() * scale);
    const auto known = material.uncertainties.find(value.name);
    return known == material.uncertainties.end()
               ? text
               : text + QStringLiteral("\u00a0\u00b1\u00a0") + number(known->second * scale, 2);
}

QString objectTables(const Experiment& e, TemperatureUnit unit) {
    html::Table bodies({SetupText::tr("Object"), SetupText::tr("Outline"), SetupText::tr("Area"),
                        SetupText::tr("Place on the end-effector"), SetupText::tr("Target at the start"),
                        SetupText::tr("Warning, trip")},
                       {2, 4, 5});
    QStringList headings{SetupText::tr("Object"), SetupText::tr("Material")};
    QList<int> numbers;
    for (const Parameter<Material>& value : materialParameters()) {
        const QString symbol = QString::fromUtf8(value.unit.symbol);
        numbers << static_cast<int>(headings.size());
        headings << parameterLabel(value) +
                        (symbol.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(symbol));
    }
    numbers << static_cast<int>(headings.size());
    headings << SetupText::tr("Areal heat capacity");
    html::Table materials(headings, numbers);
    for (const ObjectSpec& object : e.objects) {
        const QString name = QString::fromStdString(object.name);
        bodies.add({name, shapeWords(object.shape), area(object.shape), poseWords(object.mounting),
                    formatTemperature(object.target_K, unit),
                    formatTemperatureNumber(warningLimit_K(e, object), unit, 0) + QStringLiteral(", ") +
                        formatTemperature(tripLimit_K(e, object), unit, 0)});
        QStringList row{name, materialWords(object.material)};
        for (const Parameter<Material>& value : materialParameters())
            row << materialValue(object.material, value);
        materials.add(row << number(object.material.arealHeatCapacity_J_m2K()) +
                                 QStringLiteral("\u00a0J/(m\u00b2\u00a0K)"));
    }
    const bool isAnyUncertain = std::ranges::any_of(
        e.objects, [](const ObjectSpec& object) { return !object.material.uncertainties.empty(); });
    return bodies.text() + materials.text() +
           (isAnyUncertain
                ? paragraph(SetupText::tr("\u00b1 is the standard uncertainty of a material's value."),
                            "quiet")
                : QString());
}

/// Empty without any.
QString screenTable(const Experiment& e) {
    html::Table plates({SetupText::tr("Fixture or shield"), SetupText::tr("Outline"), SetupText::tr("Area"),
                        SetupText::tr("Place")},
                       {2});
    for (const PlateSpec& fixture : e.fixtures)
        plates.add({QString::fromStdString(fixture.name), shapeWords(fixture.shape), area(fixture.shape),
                    SetupText::tr("on the end-effector: %1").arg(poseWords(fixture.pose))});
    for (const PlateSpec& shield : e.shields)
        plates.add({QString::fromStdString(shield.name), shapeWords(shield.shape), area(shield.shape),
                    SetupText::tr("in the robot's base: %1").arg(poseWords(shield.pose))});
    return e.fixtures.empty() && e.shields.empty() ? QString() : plates.text();
}

QString shadeParagraphs(const Experiment& e, const Vector6d& pose, ShadedPose which) {
    QString text;
    for (const MountingRemark& remark : shadeRemarks(e, pose, which))
        text += paragraph(messageText(remark.message) + u'.');
    return text;
}

QString verdictWords(const TargetVerdict& verdict) {
    if (verdict.verdict == FeasibilityVerdict::TooHot)
        return SetupText::tr("too hot");
    if (verdict.verdict == FeasibilityVerdict::TooCold)
        return SetupText::tr("too cold");
    return SetupText::tr("within the range");
}

QString cameraFact(const CameraModel& camera) {
    const QString size = QString::fromStdString(pixelsText(camera.width, camera.height));
    const QString rms = camera.rms_px ? SetupText::tr("%1 px rms").arg(number(*camera.rms_px, 2))
                                      : SetupText::tr("error not known");
    return SetupText::tr("%1 pixels, fx = %2 px, fy = %3 px, %4, %n view(s)", nullptr,
                         static_cast<int>(camera.views.size()))
        .arg(size, number(camera.fx, 5), number(camera.fy, 5), rms);
}

} // namespace

QString setupSection(const SessionRecord& session, TemperatureUnit unit) {
    return heading(SetupText::tr("Set-up")) +
           facts(rigFacts(session) + sourceFacts(session, unit) + robotFacts(session.experiment) +
                 controllerFacts(session.experiment)) +
           beliefSection(session) + subheading(SetupText::tr("Safety limits")) +
           facts(limitFacts(session.experiment.safety, unit)) + subheading(SetupText::tr("Objects")) +
           objectTables(session.experiment, unit) + screenTable(session.experiment) +
           shadeParagraphs(session.experiment, session.experiment.start, ShadedPose::Start);
}

std::vector<double> lastTargets_K(const SessionRecord& session) {
    std::vector<double> targets_K;
    for (const ObjectSpec& object : session.experiment.objects)
        targets_K.push_back(object.target_K);
    if (const auto samples = session.controlledSamples(); !samples.empty())
        for (std::size_t i = 0; i < targets_K.size(); ++i)
            if (std::isfinite(samples.back().objects[i].target_K))
                targets_K[i] = samples.back().objects[i].target_K;
    return targets_K;
}

QString feasibilitySection(const SessionRecord& session, const std::vector<double>& targets_K,
                           const std::optional<JointVerdict>& verdict, TemperatureUnit unit) {
    QString text = heading(SetupText::tr("Feasibility of the targets"));
    if (!verdict)
        return text + paragraph(SetupText::tr("It was not computed."));
    if (!verdict->anyPose)
        return text + paragraph(SetupText::tr("No pose keeps the workspace and the clearance."));
    if (verdict->feasible)
        text += paragraph(
            SetupText::tr(
                "All targets can be held together, by the materials as given, at %1; margin %2 to the "
                "nearest limit (%3).")
                .arg(poseWords(verdict->pose), marginText(verdict->margin), limitWord(verdict->margin)));
    else
        text += paragraph(SetupText::tr("The targets cannot be held together, by the materials as given: %1.")
                              .arg(messageText(verdict->reason)),
                          "warning");
    html::Table table({SetupText::tr("Object"), SetupText::tr("Target"), SetupText::tr("By itself"),
                       SetupText::tr("Range in the workspace"), SetupText::tr("View factor needed"),
                       SetupText::tr("Steady, all together"), SetupText::tr("Nearest that can be held")},
                      {1, 3, 4, 5, 6});
    for (std::size_t i = 0; i < targets_K.size() && i < verdict->conditions1.size(); ++i) {
        const TargetVerdict& own = verdict->conditions1[i];
        table.add({QString::fromStdString(session.experiment.objects[i].name),
                   formatTemperature(targets_K[i], unit), verdictWords(own),
                   SetupText::tr("%1 to %2")
                       .arg(formatTemperatureNumber(own.reachableMin_K, unit),
                            formatTemperature(own.reachableMax_K, unit)),
                   number(own.neededViewFactor, 3), formatTemperature(verdict->steady_K.at(i), unit),
                   formatTemperature(verdict->nearest_K.at(i), unit)});
    }
    return text + table.text() + shadeParagraphs(session.experiment, verdict->pose, ShadedPose::Here);
}

QString calibrationSection(const SessionRecord& session) {
    const VisionSpec& vision = session.experiment.vision;
    const bool isPoseMeasured = !vision.sourcePoseDate.empty();
    QString text = heading(SetupText::tr("Calibration"));
    if (!vision.camera && !vision.cameraPose && !isPoseMeasured)
        return text +
               paragraph(SetupText::tr("The experiment has none: the pose of the source is as typed."));
    Facts rows;
    rows << std::pair(SetupText::tr("Camera"),
                      vision.camera
                          ? cameraFact(*vision.camera) + QStringLiteral(", ") + date(vision.cameraDate)
                          : SetupText::tr("not calibrated"));
    rows << std::pair(SetupText::tr("Pose of the camera in the robot's base"),
                      vision.cameraPose
                          ? poseWords(*vision.cameraPose) + QStringLiteral(", ") + date(vision.cameraPoseDate)
                          : SetupText::tr("not calibrated"));
    rows << std::pair(SetupText::tr("Pose of the source"),
                      isPoseMeasured
                          ? SetupText::tr("measured by the camera, %1").arg(date(vision.sourcePoseDate))
                          : SetupText::tr("as typed"));
    rows << std::pair(SetupText::tr("Markers"), SetupText::tr("%n marker(s) of dictionary %1", nullptr,
                                                              static_cast<int>(vision.markers.size()))
                                                    .arg(QString::fromStdString(vision.dictionary)));
    return text + facts(rows);
}

} // namespace bask
