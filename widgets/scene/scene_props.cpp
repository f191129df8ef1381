#include "widgets/scene/scene_props.h"

#include "widgets/common/theme.h"
#include "widgets/scene/planned_path.h"
#include "widgets/scene/scene_part.h"
#include "widgets/scene/source_glow.h"
#include "widgets/scene/source_pattern.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkContourTriangulator.h>
#include <vtkFloatArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace bask {

namespace {

constexpr double kGridStep_m = 0.05;
constexpr double kDash = 0.012; ///< of a planned path: share of the frame's diagonal
// Incandescent, and nothing else on screen has it: middle and rim of the source.
constexpr QRgb kSourceMiddle = 0xffffb45c;
constexpr QRgb kSourceRim = 0xffd9481c;
constexpr QRgb kSourceCold = 0xff6b6460; // where nothing radiates
constexpr int kGlowCells = 64, kPatternCells = 256;
constexpr double kFadesFrom = 1024.0, kFadedAt = 3072.0; ///< points of a trail
constexpr double kFaded = 0.8;                           ///< of the colour of the oldest, then

using Points = std::vector<Eigen::Vector3d>;

vtkSmartPointer<vtkPoints> pointsOf(const Points& points) {
    auto result = vtkSmartPointer<vtkPoints>::New();
    for (const Eigen::Vector3d& p : points)
        result->InsertNextPoint(p.data());
    return result;
}

/// One line through all points.
void setPolyline(vtkPolyData& data, const Points& points) {
    vtkNew<vtkCellArray> lines;
    const auto count = static_cast<vtkIdType>(points.size());
    if (count > 1) {
        lines->InsertNextCell(static_cast<int>(count));
        for (vtkIdType i = 0; i < count; ++i)
            lines->InsertCellPoint(i);
    }
    data.SetPoints(pointsOf(points));
    data.SetLines(lines);
}

/// One closed line a ring.
void setRings(vtkPolyData& data, const std::vector<std::vector<Eigen::Vector2d>>& rings) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    vtkNew<vtkCellArray> lines;
    for (const std::vector<Eigen::Vector2d>& ring : rings) {
        const vtkIdType first = points->GetNumberOfPoints();
        lines->InsertNextCell(static_cast<int>(ring.size() + 1));
        for (const Eigen::Vector2d& p : ring)
            lines->InsertCellPoint(points->InsertNextPoint(p.x(), p.y(), 0.0));
        lines->InsertCellPoint(first);
    }
    data.SetPoints(points);
    data.SetLines(lines);
}

/// Pieces of line from each even point to the odd one after it.
void setSegments(vtkPolyData& data, const Points& points) {
    vtkNew<vtkCellArray> lines;
    for (vtkIdType i = 0; i + 1 < static_cast<vtkIdType>(points.size()); i += 2) {
        const vtkIdType ids[2]{i, i + 1};
        lines->InsertNextCell(2, ids);
    }
    data.SetPoints(pointsOf(points));
    data.SetLines(lines);
}

Points flat(const std::vector<Eigen::Vector2d>& outline) {
    Points points;
    points.reserve(outline.size());
    for (const Eigen::Vector2d& p : outline)
        points.emplace_back(p.x(), p.y(), 0.0);
    return points;
}

/// The inside of an outline as rows so thin that their steps hide under its line.
void addRows(vtkPoints& points, vtkCellArray& cells, const std::vector<Eigen::Vector2d>& outline) {
    constexpr int kRows = 400;
    const Eigen::AlignedBox2d box = boxOf(outline);
    const double step = box.sizes().y() / kRows;
    for (int row = 0; row < kRows; ++row) {
        const double y = box.min().y() + row * step;
        const std::vector<double> ends = outlineCrossings(outline, 0, y + 0.5 * step);
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
            cells.InsertNextCell(4);
            cells.InsertCellPoint(points.InsertNextPoint(ends[k], y, 0.0));
            cells.InsertCellPoint(points.InsertNextPoint(ends[k + 1], y, 0.0));
            cells.InsertCellPoint(points.InsertNextPoint(ends[k + 1], y + step, 0.0));
            cells.InsertCellPoint(points.InsertNextPoint(ends[k], y + step, 0.0));
        }
    }
}

/// The inside of an outline, convex or not, less its holes.
void setFilled(vtkPolyData& data, const std::vector<std::vector<Eigen::Vector2d>>& rings) {
    const std::vector<Eigen::Vector2d> outline = chained(rings);
    const vtkSmartPointer<vtkPoints> points = pointsOf(flat(outline));
    vtkNew<vtkIdList> polygon;
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
        polygon->InsertNextId(i);
    vtkNew<vtkCellArray> cells;
    // No triangles for a chain, nor for an outline that crosses itself, as fits of few harmonics do.
    if (rings.size() > 1 || vtkContourTriangulator::TriangulatePolygon(polygon, points, cells) == 0) {
        cells->Reset();
        addRows(*points, *cells, outline);
    }
    data.SetPoints(points);
    data.SetPolys(cells);
}

/// Of the source where it is lit; 1: as in its middle.
QRgb glowColour(double glow) {
    return mixed(QColor(kSourceMiddle), QColor(kSourceRim), glow).rgb();
}

/// From the middle of an even source to its rim.
std::vector<QRgb> glowColours(const std::vector<Eigen::Vector2d>& outline, int cells) {
    std::vector<QRgb> colours;
    for (const double glow : sourceGlow(outline, boxOf(outline), cells))
        colours.push_back(glowColour(glow));
    return colours;
}

/// Of an uneven source: from the weakest part to the strongest, and grey where nothing radiates.
std::vector<QRgb> patternColours(const Experiment& experiment, const Eigen::AlignedBox2d& box, int cells) {
    const std::vector<double> pattern = sourcePattern(experiment, box, cells);
    const double max = std::ranges::max(pattern);
    double min = max;
    for (const double weight : pattern)
        min = weight > 0.0 ? std::min(min, weight) : min;
    std::vector<QRgb> colours;
    colours.reserve(pattern.size());
    for (const double weight : pattern)
        colours.push_back(weight > 0.0 ? glowColour(max > min ? (weight - min) / (max - min) : 1.0)
                                       : kSourceCold);
    return colours;
}

/// Colours the inside of an outline by a texture of `cells` x `cells` over its box.
void setTexture(vtkPolyData& data, vtkTexture& texture, const std::vector<Eigen::Vector2d>& outline,
                const std::vector<QRgb>& colours, int cells) {
    const Eigen::AlignedBox2d box = boxOf(outline);
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (vtkIdType i = 0; i < data.GetNumberOfPoints(); ++i) {
        const Eigen::Vector2d p(data.GetPoint(i));
        const Eigen::Vector2d place = (p - box.min()).cwiseQuotient(box.sizes());
        places->InsertNextTuple(place.data());
    }
    data.GetPointData()->SetTCoords(places);
    vtkNew<vtkImageData> image;
    image->SetDimensions(cells, cells, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
    for (const QRgb colour : colours)
        for (const int part : {qRed(colour), qGreen(colour), qBlue(colour)})
            *out++ = static_cast<unsigned char>(part);
    texture.SetInputData(image);
}

/// What the glow is multiplied by: at room temperature its middle is as grey as what does not radiate.
QColor warmthTint(double share) {
    const auto part = [share](int cold, int hot) {
        return static_cast<float>(share + (1.0 - share) * std::min(1.0, double(cold) / hot));
    };
    return QColor::fromRgbF(part(qRed(kSourceCold), qRed(kSourceMiddle)),
                            part(qGreen(kSourceCold), qGreen(kSourceMiddle)),
                            part(qBlue(kSourceCold), qBlue(kSourceMiddle)));
}

/// What the picture of a source is made from.
struct SourceLook {
    SourceSpec source;
    double environment_K = 0.0;

    /// An even source looks the same at any temperature and wherever it lies.
    static SourceLook of(const Experiment& experiment) {
        SourceLook look;
        look.source.shape = experiment.source.shape;
        if (experiment.source.uneven.isEven())
            return look;
        look = {experiment.source, experiment.environment_K};
        look.source.pose.setZero();
        return look;
    }
    bool operator==(const SourceLook&) const = default;
};

/// An outline in S as it stands over the floor, the plane z = 0 of R.
std::vector<Eigen::Vector2d> overTheFloor(const std::vector<Eigen::Vector2d>& outline, const Pose& X_RS) {
    std::vector<Eigen::Vector2d> points;
    for (const Eigen::Vector2d& p : outline)
        points.emplace_back((X_RS * Eigen::Vector3d(p.x(), p.y(), 0.0)).head<2>());
    return points;
}

/// Floor lines every kGridStep_m, left out where the source is over them.
Points gridLines(const Box& frame, const std::vector<Eigen::Vector2d>& source) {
    Points points;
    for (const int along : {1, 0}) {
        const int across = 1 - along;
        const double first = std::ceil(frame.min()[across] / kGridStep_m - 1e-9);
        for (double k = first; k * kGridStep_m <= frame.max()[across] + 1e-9; k += 1.0) {
            const double at = k * kGridStep_m;
            std::vector<double> ends = outlineCrossings(source, along, at);
            for (double& end : ends) // a source that has left the frame: the ends ascend all the same
                end = std::clamp(end, frame.min()[along], frame.max()[along]);
            ends.insert(ends.begin(), frame.min()[along]);
            ends.push_back(frame.max()[along]);
            for (const double end : ends) {
                Eigen::Vector3d p = Eigen::Vector3d::Zero();
                p[across] = at;
                p[along] = end;
                points.push_back(p);
            }
        }
    }
    return points;
}

/// Edges of a box without the three that meet in the corner nearest to the viewer: they would cross what is
/// inside.
Points boxEdges(const Box& box, int nearest) {
    Points points;
    for (int a = 0; a < 8; ++a)
        for (const int bit : {1, 2, 4})
            if ((a & bit) == 0 && a != nearest && (a | bit) != nearest) {
                points.push_back(box.corner(static_cast<Box::CornerType>(a)));
                points.push_back(box.corner(static_cast<Box::CornerType>(a | bit)));
            }
    return points;
}

int nearestCorner(const Eigen::Vector3d& viewDirection) {
    return (viewDirection.x() < 0.0 ? 1 : 0) | (viewDirection.y() < 0.0 ? 2 : 0) |
           (viewDirection.z() < 0.0 ? 4 : 0);
}

struct ObjectParts {
    ScenePart fill;
    ScenePart outline;
    ScenePart mount;
    ScenePart drop; ///< from the centroid along the source's normal to its plane
    ScenePart trail;
    ScenePart plan; ///< path of the centre that a run is predicted to take
    Pose X_EO = Pose::Identity();
};

/// A fixture or a shield.
struct PlateParts {
    ScenePart fill;
    ScenePart outline;
    Pose X = Pose::Identity(); ///< in E of a fixture, in R of a shield
    bool isHeld = false;
};

constexpr double kPlateOpacity = 0.45;

} // namespace

struct SceneProps::Impl {
    explicit Impl(vtkRenderer& target) : renderer(target) {
        glow->InterpolateOn();
        glow->RepeatOff();
        glow->EdgeClampOn();
        source.actor->SetTexture(glow);
    }

    vtkRenderer& renderer;
    SceneColours colours;
    double lineScale = 1.0;
    ScenePart source;
    vtkNew<vtkTexture> glow;
    std::optional<SourceLook> glowing; ///< what source, glow and rim show
    ScenePart sourceRim;
    std::optional<HeatState> heat;
    ScenePart grid;
    Box frame;
    std::vector<Eigen::Vector2d> sourceOutline;
    std::optional<Pose> gridFor; ///< where the source is that the floor lines leave out
    ScenePart workspace;
    Box workspaceBox;
    int nearest = -1; ///< corner of the workspace whose edges are left out
    std::vector<ObjectParts> objects;
    bool arePlansDim = false;
    std::vector<PlateParts> plates;

    void forEach(const std::function<void(ScenePart&)>& visit) {
        for (ScenePart* part : {&grid, &source, &sourceRim, &workspace})
            visit(*part);
        for (ObjectParts& object : objects)
            for (ScenePart* part :
                 {&object.plan, &object.trail, &object.drop, &object.mount, &object.fill, &object.outline})
                visit(*part);
        for (PlateParts& plate : plates)
            for (ScenePart* part : {&plate.fill, &plate.outline})
                visit(*part);
    }
    void addPlate(const PlateSpec& spec, bool isHeld);
    void applyColours();
    QColor rimColour() const;
};

void SceneProps::Impl::applyColours() {
    renderer.SetBackground(colours.ground.redF(), colours.ground.greenF(), colours.ground.blueF());
    grid.setColour(colours.grid);
    workspace.setColour(colours.workspace);
    sourceRim.setColour(rimColour());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        objects[i].mount.setColour(colours.mount);
        objects[i].plan.setColour(arePlansDim ? colours.workspace : colours.mount);
        objects[i].drop.setColour(colours.workspace);
        objects[i].outline.setColour(seriesColor(static_cast<int>(i), colours.dark));
    }
    for (PlateParts& plate : plates) {
        plate.fill.setColour(colours.mount);
        plate.outline.setColour(colours.mount);
    }
}

QColor SceneProps::Impl::rimColour() const {
    if (heat == HeatState::Off)
        return colours.mount;
    if (heat == HeatState::Unknown)
        return unknownColor(colours.dark);
    return QColor::fromRgb(kSourceRim).darker(colours.dark ? 100 : 120);
}

void SceneProps::Impl::addPlate(const PlateSpec& spec, bool isHeld) {
    PlateParts plate;
    plate.X = poseFromCoordinates(spec.pose);
    plate.isHeld = isHeld;
    const std::vector<std::vector<Eigen::Vector2d>> rings = shapeRings(spec.shape, kOutlinePoints);
    setFilled(*plate.fill.data, rings);
    plate.fill.actor->GetProperty()->SetOpacity(kPlateOpacity);
    setRings(*plate.outline.data, rings);
    plate.outline.width_px = 2.0F;
    plates.push_back(plate);
}

SceneProps::SceneProps(vtkRenderer& renderer) : m(std::make_unique<Impl>(renderer)) {}

SceneProps::~SceneProps() = default;

void SceneProps::build(const Experiment& experiment, const Box& frame) {
    m->renderer.RemoveAllViewProps();
    m->objects.clear();
    m->plates.clear();

    const std::vector<std::vector<Eigen::Vector2d>> rings =
        shapeRings(experiment.source.shape, kOutlinePoints);
    const std::vector<Eigen::Vector2d> source = chained(rings);
    if (SourceLook look = SourceLook::of(experiment); m->glowing != look) {
        const bool isEven = experiment.source.uneven.isEven();
        const int cells = isEven ? kGlowCells : kPatternCells;
        setFilled(*m->source.data, rings);
        setTexture(*m->source.data, *m->glow, source,
                   isEven ? glowColours(source, cells) : patternColours(experiment, boxOf(source), cells),
                   cells);
        std::vector<std::vector<Eigen::Vector2d>> lines = rings;
        std::ranges::move(partRings(experiment.source.uneven, kOutlinePoints), std::back_inserter(lines));
        setRings(*m->sourceRim.data, lines);
        m->glowing = std::move(look);
    }
    m->sourceRim.width_px = 3.0F;
    m->frame = frame;
    m->sourceOutline = source;
    m->gridFor.reset();
    const RobotLimits& robot = experiment.robot;
    m->workspaceBox = Box(robot.lower.head<3>().eval(), robot.upper.head<3>().eval());
    m->nearest = -1;
    m->workspace.width_px = 1.0F;

    for (const ObjectSpec& spec : experiment.objects) {
        ObjectParts object;
        object.X_EO = poseFromCoordinates(spec.mounting);
        const std::vector<std::vector<Eigen::Vector2d>> outline = shapeRings(spec.shape, kOutlinePoints);
        setFilled(*object.fill.data, outline);
        setRings(*object.outline.data, outline);
        object.outline.width_px = 3.0F;
        setSegments(*object.mount.data, {Eigen::Vector3d::Zero(), object.X_EO.translation()});
        object.mount.width_px = 2.0F;
        setSegments(*object.drop.data, {Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
        object.trail.width_px = 3.0F;
        object.trail.mapper->ScalarVisibilityOn();
        object.plan.width_px = 2.0F;
        m->objects.push_back(object);
    }
    for (const PlateSpec& fixture : experiment.fixtures)
        m->addPlate(fixture, true);
    for (const PlateSpec& shield : experiment.shields)
        m->addPlate(shield, false);
    m->forEach([this](ScenePart& part) {
        part.data->Modified();
        part.actor->GetProperty()->SetLineWidth(part.width_px * static_cast<float>(m->lineScale));
        m->renderer.AddActor(part.actor);
    });
    m->applyColours();
}

void SceneProps::setColours(const SceneColours& colours) {
    m->colours = colours;
    m->applyColours();
}

void SceneProps::setLineScale(double scale) {
    if (scale == m->lineScale)
        return;
    m->lineScale = scale;
    m->forEach([scale](ScenePart& part) {
        part.actor->GetProperty()->SetLineWidth(part.width_px * static_cast<float>(scale));
    });
}

void SceneProps::setViewDirection(const Eigen::Vector3d& direction) {
    const int nearest = nearestCorner(direction);
    if (nearest == m->nearest)
        return;
    m->nearest = nearest;
    setSegments(*m->workspace.data, boxEdges(m->workspaceBox, nearest));
    m->workspace.data->Modified();
}

void SceneProps::setPoses(const Pose& X_RE, const Pose& X_RS, const Eigen::Vector3d& lift) {
    const auto lifted = [&lift](const Pose& X) { return Pose(Eigen::Translation3d(lift) * X); };
    if (!m->gridFor || m->gridFor->matrix() != X_RS.matrix()) {
        setSegments(*m->grid.data, gridLines(m->frame, overTheFloor(m->sourceOutline, X_RS)));
        m->grid.data->Modified();
        m->gridFor = X_RS;
    }
    m->source.setTransform(X_RS);
    m->sourceRim.setTransform(lifted(X_RS));
    const Eigen::Vector3d normal = X_RS.linear().col(2);
    for (ObjectParts& object : m->objects) {
        const Pose X_RO = X_RE * object.X_EO;
        const double height_m = normal.dot(X_RO.translation() - X_RS.translation());
        object.fill.setTransform(X_RO);
        object.outline.setTransform(lifted(X_RO));
        object.mount.setTransform(lifted(X_RE));
        object.plan.setTransform(Pose(Eigen::Translation3d(-lift))); // behind a trail on the same path
        Pose drop = X_RS;
        drop.translation() = X_RO.translation() - height_m * normal;
        drop.linear().col(2) *= height_m; // a line of length one, stretched
        object.drop.setTransform(lifted(drop));
    }
    for (PlateParts& plate : m->plates) {
        const Pose X_RB = plate.isHeld ? X_RE * plate.X : plate.X;
        plate.fill.setTransform(X_RB);
        plate.outline.setTransform(lifted(X_RB));
    }
}

void SceneProps::setSourceWarmth(double share) {
    m->source.setColour(warmthTint(share));
}

void SceneProps::setSourceHeat(std::optional<HeatState> heat) {
    m->heat = heat;
    m->sourceRim.setColour(m->rimColour());
}

void SceneProps::setObjectColour(std::size_t index, const QColor& colour) {
    m->objects.at(index).fill.setColour(colour);
}

void SceneProps::setObjectOpacity(double opacity) {
    for (ObjectParts& object : m->objects)
        object.fill.actor->GetProperty()->SetOpacity(opacity);
}

void SceneProps::setTrail(std::size_t index, const Trail& trail, const TemperatureColour& colour) {
    Points points;
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    const auto count = static_cast<double>(trail.kept().size());
    const double faded = kFaded * std::clamp((count - kFadesFrom) / (kFadedAt - kFadesFrom), 0.0, 1.0);
    const auto add = [&](const Trail::Point& point) {
        const double age = 1.0 - static_cast<double>(points.size()) / std::max(1.0, count);
        points.push_back(point.p_RO);
        const QRgb rgb = mixed(m->colours.ground, colour(point.temperature_K), faded * age).rgb();
        for (const int part : {qRed(rgb), qGreen(rgb), qBlue(rgb)})
            colours->InsertNextValue(static_cast<unsigned char>(part));
    };
    points.reserve(trail.kept().size() + 1);
    for (const Trail::Point& point : trail.kept())
        add(point);
    if (!trail.empty())
        add(trail.newest());
    vtkPolyData& data = *m->objects.at(index).trail.data;
    setPolyline(data, points);
    data.GetPointData()->SetScalars(colours);
    data.Modified();
}

void SceneProps::setPlan(std::size_t index, const std::vector<Eigen::Vector3d>& path_R, bool arrives) {
    vtkPolyData& data = *m->objects.at(index).plan.data;
    const double dash_m = kDash * m->frame.diagonal().norm();
    setSegments(data, arrives ? plannedPath(path_R, dash_m) : dashedLine(path_R, dash_m));
    data.Modified();
}

void SceneProps::setPlansDim(bool dim) {
    if (dim == m->arePlansDim)
        return;
    m->arePlansDim = dim;
    m->applyColours();
}

} // namespace bask
