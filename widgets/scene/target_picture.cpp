#include "widgets/scene/target_picture.h"

#include "engine/base/units.h"
#include "engine/model/experiment_rig.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/scene/cut_sheet.h"
#include "widgets/scene/scene_frame.h"
#include "widgets/scene/scene_rays.h"
#include "widgets/scene/source_shadow.h"

#include <QLocale>
#include <QPainter>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace bask {

namespace {

constexpr int kContourSteps = 10; ///< of the colour bar, and so contour lines
constexpr double kLineLift_px = 8.0;
constexpr double kGhostOpacity = 0.55;
constexpr double kMarkShare = 0.009; ///< radius of a mark, of the frame's diagonal
constexpr double kArrowShare = 0.1;

QString tenthsText(double value) {
    const double tenths = std::round(10.0 * value) + 0.0; // no minus before zero
    return QLocale()
        .toString(tenths / 10.0, 'f', 1)
        .replace(QLocale().negativeSign(), QStringLiteral("\u2212"));
}

/// Degrees, without a tenth that is none.
QString angleText(double angle_rad) {
    const double angle_deg = degFromRad(angle_rad);
    return formatSigned(angle_deg, std::abs(angle_deg - std::round(angle_deg)) < 0.05 ? 0 : 1).remove(u'+');
}

Box angleBox() {
    constexpr double kRightAngle = std::numbers::pi / 2.0; // as surfaceAxes has it
    return {Eigen::Vector3d::Constant(-kRightAngle), Eigen::Vector3d::Constant(kRightAngle)};
}

/// The end-effector's frame and as far as it carries an object to a side or up.
Box ownFrameOf(const Experiment& experiment) {
    Box box = frameOf(experiment);
    double reach_m = 0.0;
    for (const ObjectSpec& object : experiment.objects)
        reach_m = std::max(reach_m, object.mounting.head<3>().norm());
    box.extend(Eigen::Vector3d(box.min() - Eigen::Vector3d(reach_m, reach_m, 0.0)));
    box.extend(Eigen::Vector3d(box.max() + Eigen::Vector3d::Constant(reach_m)));
    return box;
}

Box boxOf(const Field& field) {
    Box box;
    for (const int end : {0, 1}) {
        Eigen::Vector3d corner;
        for (int a = 0; a < 3; ++a) {
            const FieldAxis& axis = field.axes[static_cast<std::size_t>(a)];
            corner[a] = axis.at(end * (axis.count - 1));
        }
        box.extend(corner);
    }
    return box;
}

/// But for the targets, which no part of the picture but its labels shows.
bool haveOneGeometry(Experiment a, const Experiment& b) {
    if (a.objects.size() != b.objects.size())
        return false;
    for (std::size_t i = 0; i < a.objects.size(); ++i)
        a.objects[i].target_K = b.objects[i].target_K;
    return a == b;
}

} // namespace

bool TargetPicture::setExperiment(const Experiment& next) {
    const bool known = rig && haveOneGeometry(experiment, next);
    experiment = next;
    if (known)
        return true;
    rates.clear();
    for (const ObjectSpec& object : experiment.objects)
        rates.push_back(heatRates(object, surroundingsOf(experiment)));
    rig = rigGeometryWithoutExchange(experiment);
    fixed = experiment.start;
    surfaces.clear();
    verdict.reset();
    setSubset(subset);
    return false;
}

void TargetPicture::setSubset(PoseSubset next) {
    subset = next;
    frame = isOverAngles() ? angleBox() : isOverOwn() ? ownFrameOf(experiment) : frameOf(experiment);
    cut.reset();
    rebuild = true;
}

/// The drawn three of a pose's coordinates.
Eigen::Vector3d TargetPicture::drawn(const Vector6d& q) const {
    return q.segment<3>(isOverAngles() ? kThetaX : kX);
}

Box TargetPicture::limits() const {
    return {drawn(experiment.robot.lower), drawn(experiment.robot.upper)};
}

/// The angles that the robot can have; those that it does not move are as at the start.
Box TargetPicture::turns() const {
    Vector6d lower = experiment.robot.lower, upper = experiment.robot.upper;
    for (int k = kThetaX; k <= kThetaZ; ++k)
        if (!experiment.robot.free[static_cast<std::size_t>(k)])
            lower[k] = upper[k] = experiment.start[k];
    return {lower.tail<3>(), upper.tail<3>()};
}

/// "Robot: θx −35 to 35°", of each angle that it turns.
QString TargetPicture::turnText() const {
    static const QStringList kNames{"\u03b8x", "\u03b8y", "\u03b8z"};
    const Box box = turns();
    QStringList ranges;
    for (int a = 0; a < 3; ++a)
        if (box.min()[a] < box.max()[a])
            ranges << TargetScene::tr("%1 %2 to %3\u00b0", "an angle, its least and largest value")
                          .arg(kNames[a], angleText(box.min()[a]), angleText(box.max()[a]));
    return ranges.isEmpty() ? TargetScene::tr("The robot does not turn")
                            : TargetScene::tr("Robot: %1").arg(ranges.join(QStringLiteral(", ")));
}

bool TargetPicture::isPickAt(const Vector6d& other) const {
    const int k = isOverAngles() ? kX : kThetaX;
    return !picked || picked->q.segment<3>(k) == other.segment<3>(k);
}

/// cm or degrees.
double TargetPicture::inUnit(double value) const {
    return isOverAngles() ? degFromRad(value) : 100.0 * value;
}

QString TargetPicture::unitWord() const {
    return isOverAngles() ? QStringLiteral("°") : QStringLiteral("cm");
}

QString TargetPicture::placeText(const Eigen::Vector3d& p) const {
    return QStringLiteral("(%1, %2, %3) %4")
        .arg(tenthsText(inUnit(p.x())), tenthsText(inUnit(p.y())), tenthsText(inUnit(p.z())), unitWord());
}

/// From the end-effector to where an object is drawn over.
Eigen::Vector3d TargetPicture::offsetOf(std::size_t object) const {
    if (!isOverOwn())
        return Eigen::Vector3d::Zero();
    return centreOffset(poseFromCoordinates(experiment.objects[object].mounting), fixed);
}

/// Whether the surfaces are those through the verdict's pose: others meet elsewhere, if at all.
bool TargetPicture::isAtVerdict() const {
    constexpr double kSame = 1e-6;
    const int other = isOverAngles() ? kX : kThetaX;
    return verdict && !isOverOwn() &&
           (fixed.segment<3>(other) - verdict->pose.segment<3>(other)).norm() < kSame;
}

/// The verdict's pose; without one the start, turned as the surfaces are held.
Vector6d TargetPicture::ghost() const {
    Vector6d q = experiment.start;
    q.tail<3>() = fixed.tail<3>();
    return verdict ? verdict->pose : q;
}

double TargetPicture::markRadius() const {
    return kMarkShare * frame.diagonal().norm();
}

std::vector<QColor> TargetPicture::colours(bool dark) const {
    std::vector<QColor> result;
    for (std::size_t i = 0; i < experiment.objects.size(); ++i)
        result.push_back(seriesColor(static_cast<int>(i), dark));
    return result;
}

/// What the cut shows of a view factor, in the operator's unit.
double TargetPicture::cutValue(double F) const {
    if (!cut->asTemperature)
        return F;
    return displayTemperature(rates.at(static_cast<std::size_t>(cut->object)).steadyTemperature_K(F), unit);
}

/// Where the end-effector is at the held angles when the lowest object has just the clearance.
std::vector<Eigen::Vector3d> TargetPicture::clearancePolygon() const {
    Vector6d q = fixed;
    q.head<3>() = rig->X_RS().translation();
    const Eigen::Vector3d n = rig->away();
    const double offset =
        n.dot(rig->X_RS().translation()) + experiment.robot.clearance_m - rig->lowestPoint_m(q);
    return planeInBox(limits(), n, offset);
}

void TargetPicture::showCut(bool dark) {
    if (!cut) {
        targets->setCut({}, [](double) { return QColor(); });
        return;
    }
    double min = std::numeric_limits<double>::infinity();
    double max = -min;
    for (const double F : cut->field->values) // comparisons with NaN are false
        min = F < min ? F : min, max = F > max ? F : max;
    cutRange = min <= max ? niceRange(cutValue(min), cutValue(max), kContourSteps) : NiceRange{};
    CutSheet sheet = sheetOf(*cut->field, cut->axis % 3, cut->position);
    for (double& value : sheet.values)
        value = cutValue(value);
    for (double line = cutRange.min + cutRange.step; line < cutRange.max; line += cutRange.step)
        sheet.lines.push_back(line);
    targets->setCut(sheet, [this, dark](double value) {
        return mapColour((value - cutRange.min) / (cutRange.max - cutRange.min), dark);
    });
}

/// Of each object at the ghost's pose, in its colour: what the others hide from its centre.
void TargetPicture::showShadows(bool dark) {
    std::vector<Eigen::Vector3d> all;
    std::vector<QColor> lineColours;
    if (!isOverAngles() && rig->mayShade())
        for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
            const std::vector<Eigen::Vector3d> lines = shadowLines(experiment, i, ghost());
            all.insert(all.end(), lines.begin(), lines.end());
            lineColours.insert(lineColours.end(), lines.size() / 2, seriesColor(static_cast<int>(i), dark));
        }
    targets->setShadows(all, lineColours);
}

void TargetPicture::showMarks(bool dark) {
    std::vector<Eigen::Vector3d> points;
    if (isAtVerdict() && verdict->feasible)
        points = {drawn(verdict->pose)};
    else if (isAtVerdict() && verdict->closest)
        points = {verdict->closest->first, verdict->closest->second};
    targets->setMarks(points, markRadius());
    targets->setArrows(picked ? &picked->arrows : nullptr, 0.7 * markRadius(), colours(dark));
}

void TargetPicture::addObjectLabels(OverlayContent& result, bool dark) const {
    const Pose X_RE = poseFromCoordinates(ghost());
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const ObjectSpec& object = experiment.objects[i];
        SceneLabel label;
        label.text = QString::fromStdString(object.name);
        label.value = formatTemperature(object.target_K, unit);
        label.colour = seriesColor(static_cast<int>(i), dark);
        if (!isOverAngles()) {
            const Pose X_RO = X_RE * poseFromCoordinates(object.mounting);
            for (const Eigen::Vector3d& p_OQ : labelOutline(object.shape))
                label.outline_R.push_back(X_RO * p_OQ);
        } else if (i < surfaces.size()) {
            // No object is there to carry its name: its surface does, else the space's upper end.
            const auto& points = surfaces[i].points;
            label.outline_R.push_back(points.empty() ? Eigen::Vector3d(0.0, 0.0, frame.max().z())
                                                     : points[points.size() / 2]);
        } else {
            continue;
        }
        if (!stale && i < surfaces.size() && surfaces[i].empty()) {
            label.text =
                TargetScene::tr("%1 %2: nowhere here", "object, target").arg(label.text, label.value);
            label.value.clear();
        }
        result.labels.push_back(label);
    }
}

OverlayContent TargetPicture::overlayContent(bool dark) const {
    OverlayContent result;
    if (!rig)
        return result;
    result.frame = frame;
    result.axes = subset;
    result.hasBar = cut.has_value();
    result.bar = cutRange;
    if (cut)
        result.barTitle = QStringLiteral("%1, %2").arg(
            QString::fromStdString(experiment.objects[static_cast<std::size_t>(cut->object)].name),
            cut->asTemperature ? temperatureUnitSymbol(unit) : QStringLiteral("F"));
    const auto add = [&result](const QString& text, const QString& value,
                               const std::vector<Eigen::Vector3d>& outline) {
        SceneLabel label;
        label.text = text;
        label.value = value;
        label.outline_R = outline;
        result.labels.push_back(label);
    };
    if (picked) {
        std::vector<Eigen::Vector3d> outline{picked->place}; // with its arrows: no label hides them
        for (std::size_t i = 0; i < picked->arrows.from.size(); ++i)
            if (picked->arrows.from[i].isApprox(picked->place))
                outline.push_back(picked->place + picked->arrows.length * picked->arrows.directions[i]);
        add(TargetScene::tr("Picked"), placeText(picked->place), outline);
    }
    if (isAtVerdict() && verdict->feasible)
        add(TargetScene::tr("All targets"), placeText(drawn(verdict->pose)), {drawn(verdict->pose)});
    else if (isAtVerdict() && verdict->closest) {
        const auto& [a, b] = *verdict->closest;
        add(TargetScene::tr("Closest"), tenthsText(inUnit((a - b).norm())) + QLatin1Char(' ') + unitWord(),
            {a, b});
    }
    if (isOverAngles())
        add(turnText(), {}, edgesOf(turns()));
    addObjectLabels(result, dark);
    return result;
}

void TargetPicture::pointArrows(PickedPose& pose) const {
    pose.arrows.length = kArrowShare * frame.diagonal().norm();
    const ViewFactors factors = rig->viewFactors(pose.q);
    for (Eigen::Index i = 0; i < factors.F.size(); ++i) {
        pose.arrows.from.push_back(drawn(pose.q) + offsetOf(static_cast<std::size_t>(i)));
        pose.arrows.directions.push_back(drawn(factors.dF.row(i).transpose()).stableNormalized());
    }
}

QStringList TargetPicture::words(const PickedPose& pose) const {
    QStringList sentences;
    const ViewFactors factors = rig->viewFactors(pose.q);
    for (Eigen::Index i = 0; i < factors.F.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double steady_K = rates[k].steadyTemperature_K(factors.F[i]);
        const double perF_K = rates[k].lambda1 * rates[k].timeConstant_s(steady_K);
        const double slope_K = perF_K * drawn(factors.dF.row(i).transpose()).norm() / inUnit(1.0);
        sentences << TargetScene::tr("%1: F %2, steady %3, %4/%5", "name, view factor, temperature, slope")
                         .arg(QString::fromStdString(experiment.objects[k].name),
                              QLocale().toString(factors.F[i], 'f', 3), formatTemperature(steady_K, unit),
                              formatDifference(slope_K, unit), unitWord());
    }
    return sentences;
}

void TargetPicture::paint(QPainter& painter, const QPalette& palette, const QFont& font) {
    painter.setFont(font);
    painter.scale(scale, scale);
    if (stale) {
        QColor ground = palette.color(QPalette::Base);
        ground.setAlphaF(0.35F);
        QColor hatch = palette.color(QPalette::Text);
        hatch.setAlphaF(0.22F);
        painter.fillRect(QRectF({}, size()), ground);
        painter.fillRect(QRectF({}, size()), QBrush(hatch, Qt::BDiagPattern));
    }
    overlay.paint(painter, size(), palette, Projection(*view->renderer().GetActiveCamera(), size()), content);
}

std::optional<PickedPose> TargetPicture::poseAt(QPointF place) const {
    if (!rig)
        return std::nullopt;
    const Ray ray = rayThrough(*view->renderer().GetActiveCamera(), view->size(), place);
    std::optional<double> nearest;
    std::size_t object = 0;
    const auto take = [&](std::size_t of, const std::optional<double>& along) {
        if (along && (!nearest || *along < *nearest))
            nearest = along, object = of;
    };
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        take(i, distanceTo(surfaces[i], ray));
    if (cut)
        take(static_cast<std::size_t>(cut->object),
             distanceToCut(boxOf(*cut->field), cut->axis % 3, cut->position, ray));
    if (!nearest)
        return std::nullopt;
    PickedPose pose;
    pose.place = ray.origin + *nearest * ray.direction;
    pose.q = fixed;
    pose.q.segment<3>(isOverAngles() ? kThetaX : kX) = pose.place - offsetOf(object);
    try {
        pointArrows(pose);
    } catch (const std::invalid_argument&) {
        return std::nullopt; // object and source in one plane
    }
    return pose;
}

void TargetPicture::prepare(const QPalette& palette, const QFont& font) {
    const bool dark = isDark(palette);
    if (rebuild)
        props->setColours(sceneColours(palette));
    if (rig) {
        if (!cameraIsPersons)
            fitCamera(*view->renderer().GetActiveCamera(), frame, size(),
                      SceneOverlay::margins(font, size()));
        if (rebuild)
            rebuildActors(dark);
        if (rebuild || resurface) {
            targets->setSurfaces(surfaces);
            showBounds();
        }
        if (rebuild || resurface || remark) {
            showCut(dark);
            showMarks(dark);
            showShadows(dark);
            targets->setColours(colours(dark), palette.color(QPalette::Text), palette.color(QPalette::Base),
                                stale);
        }
        placeActors();
    }
    content = overlayContent(dark);
    rebuild = resurface = remark = false;
}

/// Of the objects' own centres each has another clearance: none is drawn.
void TargetPicture::showBounds() {
    if (isOverAngles())
        return targets->setBounds(edgesOf(turns()), {}, true);
    const auto clearance = isOverOwn() ? std::vector<Eigen::Vector3d>() : clearancePolygon();
    targets->setBounds(sidesOf(clearance), clearance, false);
}

void TargetPicture::rebuildActors(bool dark) {
    if (isOverAngles()) {
        view->renderer().RemoveAllViewProps();
    } else {
        props->build(experiment, frame);
        props->setObjectOpacity(kGhostOpacity);
        for (std::size_t i = 0; i < experiment.objects.size(); ++i)
            props->setObjectColour(i, seriesColor(static_cast<int>(i), dark));
    }
    targets->addActors();
}

void TargetPicture::placeActors() {
    vtkCamera& camera = *view->renderer().GetActiveCamera();
    const double lineScale = scale * view->devicePixelRatioF() *
                             std::clamp(std::min(size().width() / 800.0, size().height() / 560.0), 0.5, 1.0);
    props->setLineScale(lineScale);
    targets->setLineScale(lineScale);
    const Eigen::Vector3d direction(camera.GetDirectionOfProjection());
    const double metresPerPixel = 2.0 * camera.GetParallelScale() / std::max(1.0, size().height());
    const Eigen::Vector3d lift = -kLineLift_px * metresPerPixel * direction;
    props->setViewDirection(direction);
    props->setPoses(poseFromCoordinates(ghost()), rig->X_RS(), lift);
    targets->setLift(0.25 * lift, -1.5 * frame.diagonal().norm() * direction);
}

} // namespace bask
