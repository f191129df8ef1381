#include "widgets/scene/target_props.h"

#include "widgets/scene/scene_part.h"

#include <vtkActor.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkContourFilter.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>

namespace bask {

namespace {

constexpr double kSurfaceOpacity = 0.42;
constexpr double kStaleOpacity = 0.16;

/// Lit from the viewer, both sides alike, so that its form is seen.
ScenePart surfacePart() {
    ScenePart part;
    vtkProperty* look = part.actor->GetProperty();
    look->LightingOn();
    look->SetAmbient(0.45);
    look->SetDiffuse(0.55);
    look->SetSpecular(0.0);
    return part;
}

void fill(vtkPolyData& data, const Isosurface& surface) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        points->InsertNextPoint(surface.points[i].data());
        normals->InsertNextTuple(surface.normals[i].data());
    }
    vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : surface.triangles)
        triangles->InsertNextCell({a, b, c});
    data.SetPoints(points);
    data.SetPolys(triangles);
    data.GetPointData()->SetNormals(normals);
    data.Modified();
}

void setSpheres(vtkPolyData& data, const std::vector<Eigen::Vector3d>& points, double radius) {
    vtkNew<vtkAppendPolyData> all;
    all->AddInputData(vtkSmartPointer<vtkPolyData>::New());
    for (const Eigen::Vector3d& point : points) {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetCenter(point.x(), point.y(), point.z());
        sphere->SetRadius(radius);
        sphere->SetThetaResolution(20);
        sphere->SetPhiResolution(12);
        sphere->Update();
        all->AddInputData(sphere->GetOutput());
    }
    all->Update();
    data.ShallowCopy(all->GetOutput());
    data.GetPointData()->SetNormals(nullptr); // unlit
}

/// Lines from each even point to the odd one after it, in that many colours, one a line.
void setLines(vtkPolyData& data, const std::vector<Eigen::Vector3d>& ends,
              const std::vector<QColor>& colours) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkUnsignedCharArray> scalars;
    scalars->SetNumberOfComponents(3);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const vtkIdType from = points->InsertNextPoint(ends[i].data());
        const vtkIdType to = points->InsertNextPoint(ends[i + 1].data());
        lines->InsertNextCell({from, to});
        for (int k = 0; k < 2 && !colours.empty(); ++k) {
            const QColor& colour = colours[(i / 2) % colours.size()];
            for (const int part : {colour.red(), colour.green(), colour.blue()})
                scalars->InsertNextValue(static_cast<unsigned char>(part));
        }
    }
    data.SetPoints(points);
    data.SetLines(lines);
    data.GetPointData()->SetScalars(colours.empty() ? nullptr : scalars.Get());
    data.Modified();
}

/// The sheet's cells that have all their values.
void setSheet(vtkPolyData& data, const CutSheet& sheet) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkDoubleArray> values;
    for (std::size_t i = 0; i < sheet.points.size(); ++i) {
        points->InsertNextPoint(sheet.points[i].data());
        values->InsertNextValue(sheet.values[i]);
    }
    vtkNew<vtkCellArray> cells;
    const vtkIdType columns = sheet.columns;
    const auto count = static_cast<vtkIdType>(sheet.points.size());
    for (vtkIdType i = 0; i + columns + 1 < count; ++i) {
        if ((i + 1) % columns == 0)
            continue;
        double sum = 0.0;
        for (const vtkIdType k : {i, i + 1, i + columns, i + columns + 1})
            sum += sheet.values[static_cast<std::size_t>(k)];
        if (std::isnan(sum))
            continue;
        cells->InsertNextCell({i, i + 1, i + columns + 1});
        cells->InsertNextCell({i, i + columns + 1, i + columns});
    }
    data.SetPoints(points);
    data.SetPolys(cells);
    data.GetPointData()->SetScalars(values);
}

} // namespace

struct TargetProps::Impl {
    explicit Impl(vtkRenderer& target) : renderer(target) {
        boundsFill.actor->GetProperty()->SetOpacity(0.07);
        sheet.mapper->ScalarVisibilityOn();
        arrows.mapper->ScalarVisibilityOn();
        arrowEdges.width_px = 7.0F;
        arrows.width_px = 3.0F;
        join.width_px = 3.0F;
        lines.width_px = 1.5F;
        shadows.mapper->ScalarVisibilityOn();
        shadows.width_px = 2.5F;
    }

    vtkRenderer& renderer;
    std::vector<ScenePart> surfaces;
    ScenePart bounds, boundsFill;
    ScenePart sheet, lines;
    ScenePart shadows;
    ScenePart marks, join;
    ScenePart picked, arrowEdges, arrows;
    double lineScale = 1.0;
    bool boundsBefore = false;

    std::vector<ScenePart*> parts() {
        std::vector<ScenePart*> all{&bounds, &boundsFill, &sheet,      &lines,  &marks,
                                    &join,   &picked,     &arrowEdges, &arrows, &shadows};
        for (ScenePart& surface : surfaces)
            all.push_back(&surface);
        return all;
    }
};

TargetProps::TargetProps(vtkRenderer& renderer) : m(std::make_unique<Impl>(renderer)) {}

TargetProps::~TargetProps() = default;

void TargetProps::addActors() {
    for (ScenePart* part : m->parts()) {
        part->actor->GetProperty()->SetLineWidth(part->width_px * static_cast<float>(m->lineScale));
        m->renderer.AddActor(part->actor);
    }
}

void TargetProps::setSurfaces(const std::vector<Isosurface>& surfaces) {
    for (const ScenePart& part : m->surfaces)
        m->renderer.RemoveActor(part.actor);
    m->surfaces.clear();
    for (const Isosurface& surface : surfaces) {
        m->surfaces.push_back(surfacePart());
        fill(*m->surfaces.back().data, surface);
        m->renderer.AddActor(m->surfaces.back().actor);
    }
}

void TargetProps::setColours(const std::vector<QColor>& surfaces, const QColor& marks, const QColor& contours,
                             bool stale) {
    for (std::size_t i = 0; i < m->surfaces.size() && i < surfaces.size(); ++i) {
        m->surfaces[i].setColour(surfaces[i]);
        m->surfaces[i].actor->GetProperty()->SetOpacity(stale ? kStaleOpacity : kSurfaceOpacity);
    }
    for (ScenePart* part : {&m->marks, &m->join, &m->picked, &m->bounds, &m->boundsFill})
        part->setColour(marks);
    for (ScenePart* part : {&m->lines, &m->arrowEdges})
        part->setColour(contours);
}

void TargetProps::setLineScale(double scale) {
    m->lineScale = scale;
    for (ScenePart* part : m->parts())
        part->actor->GetProperty()->SetLineWidth(part->width_px * static_cast<float>(scale));
}

void TargetProps::setBounds(const std::vector<Eigen::Vector3d>& lines,
                            const std::vector<Eigen::Vector3d>& polygon, bool before) {
    m->boundsBefore = before;
    m->bounds.width_px = before ? 3.0F : 1.5F;
    setLines(*m->bounds.data, lines, {});
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    if (!polygon.empty())
        cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Eigen::Vector3d& corner : polygon)
        cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
    m->boundsFill.data->SetPoints(points);
    m->boundsFill.data->SetPolys(cells);
    m->boundsFill.data->Modified();
}

void TargetProps::setCut(const CutSheet& sheet, const std::function<QColor(double)>& colour) {
    vtkNew<vtkPolyData> valued;
    setSheet(*valued, sheet);
    vtkNew<vtkContourFilter> contours;
    contours->SetInputData(valued);
    for (std::size_t i = 0; i < sheet.lines.size(); ++i)
        contours->SetValue(static_cast<int>(i), sheet.lines[i]);
    contours->ComputeScalarsOff();
    if (!sheet.lines.empty() && valued->GetNumberOfCells() > 0) {
        contours->Update();
        m->lines.data->ShallowCopy(contours->GetOutput());
    } else {
        m->lines.data->Initialize();
    }
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(3);
    for (const double value : sheet.values) {
        const QColor rgb = colour(value);
        for (const int part : {rgb.red(), rgb.green(), rgb.blue()})
            colours->InsertNextValue(static_cast<unsigned char>(part));
    }
    valued->GetPointData()->SetScalars(colours);
    m->sheet.data->ShallowCopy(valued);
}

void TargetProps::setMarks(const std::vector<Eigen::Vector3d>& points, double radius) {
    setSpheres(*m->marks.data, points, radius);
    setLines(*m->join.data, points, {});
}

void TargetProps::setShadows(const std::vector<Eigen::Vector3d>& lines, const std::vector<QColor>& colours) {
    setLines(*m->shadows.data, lines, colours);
}

void TargetProps::setLift(const Eigen::Vector3d& lines, const Eigen::Vector3d& marks) {
    m->lines.actor->SetPosition(lines.x(), lines.y(), lines.z());
    for (ScenePart* part : {&m->marks, &m->join, &m->picked, &m->arrows})
        part->actor->SetPosition(marks.x(), marks.y(), marks.z());
    const Eigen::Vector3d behind = 0.95 * marks;
    const Eigen::Vector3d bounds = m->boundsBefore ? behind : Eigen::Vector3d::Zero();
    m->bounds.actor->SetPosition(bounds.x(), bounds.y(), bounds.z());
    for (ScenePart* part : {&m->arrowEdges, &m->shadows})
        part->actor->SetPosition(behind.x(), behind.y(), behind.z());
}

void TargetProps::setArrows(const PickedArrows* arrows, double radius, const std::vector<QColor>& colours) {
    if (arrows == nullptr) {
        m->picked.data->Initialize();
        m->arrows.data->Initialize();
        m->arrowEdges.data->Initialize();
        return;
    }
    setSpheres(*m->picked.data, arrows->from, radius);
    std::vector<Eigen::Vector3d> ends;
    std::vector<QColor> lineColours;
    for (std::size_t i = 0; i < arrows->directions.size(); ++i) {
        const Eigen::Vector3d& from = arrows->from[i];
        const Eigen::Vector3d& d = arrows->directions[i];
        const Eigen::Vector3d tip = from + arrows->length * d;
        const Eigen::Vector3d back = tip - 0.28 * arrows->length * d;
        // Two pairs of barbs: one alone may be seen edge on.
        const Eigen::Vector3d aside = 0.14 * arrows->length * d.unitOrthogonal();
        const Eigen::Vector3d across = d.cross(aside);
        ends.insert(ends.end(), {from, tip});
        for (const Eigen::Vector3d& barb : {aside, Eigen::Vector3d(-aside), across, Eigen::Vector3d(-across)})
            ends.insert(ends.end(), {tip, back + barb});
        lineColours.insert(lineColours.end(), 5, colours[i % colours.size()]);
    }
    setLines(*m->arrows.data, ends, lineColours);
    setLines(*m->arrowEdges.data, ends, {});
}

} // namespace bask
