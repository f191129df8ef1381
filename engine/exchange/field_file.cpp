#include "engine/exchange/field_file.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/exchange/vtk_inside.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

void describeAxes(vtkDataSet* data, const Field& field) {
    std::vector<std::string> names;
    std::vector<std::string> units;
    std::vector<double> first;
    std::vector<double> step;
    std::vector<double> count;
    for (const FieldAxis& axis : field.axes) {
        names.emplace_back(kCoordinateNames[axis.coordinate]);
        units.emplace_back(coordinateUnit(axis.coordinate));
        first.push_back(axis.first);
        step.push_back(axis.step);
        count.push_back(axis.count);
    }
    vtkfile::addWords(data, "axis_names", names);
    vtkfile::addWords(data, "axis_units", units);
    vtkfile::addNumbers(data, "axis_first", first);
    vtkfile::addNumbers(data, "axis_step", step);
    vtkfile::addNumbers(data, "axis_count", count);
}

void describeFixed(vtkDataSet* data, const Field& field) {
    std::vector<std::string> names;
    std::vector<std::string> units;
    std::vector<double> values;
    for (int i = 0; i < 6; ++i) {
        const auto coordinate = static_cast<Coordinate>(i);
        if (std::ranges::find(field.axes, coordinate, &FieldAxis::coordinate) != field.axes.end())
            continue;
        names.emplace_back(kCoordinateNames[coordinate]);
        units.emplace_back(coordinateUnit(coordinate));
        values.push_back(field.fixed[i]);
    }
    vtkfile::addWords(data, "held_names", names);
    vtkfile::addWords(data, "held_units", units);
    vtkfile::addNumbers(data, "held_values", values);
}

/// What the numbers are and how they came about.
void explain(vtkDataSet* data, const Field& field, const std::string& title) {
    vtkfile::addOrigin(data, title);
    describeAxes(data, field);
    describeFixed(data, field);
    vtkfile::addNumbers(data, "tolerance", {field.tolerance});
    if (field.isShadeRough)
        vtkfile::addNumbers(data, "rough_shade", {1.0});
    vtkfile::addNumbers(data, "undefined_samples", {static_cast<double>(field.undefinedSamples)});
    vtkfile::addNumbers(data, "samples_above_tolerance", {static_cast<double>(field.unreachedSamples)});
    vtkfile::addNumbers(data, "largest_error_estimate", {field.largestErrorEstimate});
}

/// Image without point data: the first three axes.
void layOut(vtkImageData* image, const Field& field, const std::string& title) {
    std::array<int, 3> counts{1, 1, 1};
    std::array<double, 3> origin{};
    std::array<double, 3> spacing{1.0, 1.0, 1.0};
    for (std::size_t a = 0; a < std::min<std::size_t>(3, field.axes.size()); ++a) {
        counts[a] = field.axes[a].count;
        origin[a] = field.axes[a].first;
        spacing[a] = field.axes[a].step;
    }
    image->SetDimensions(counts.data());
    image->SetOrigin(origin.data());
    image->SetSpacing(spacing.data());
    explain(image, field, title);
}

int fourthAxisCount(const Field& field) {
    return field.axes.size() < 4 ? 1 : field.axes[3].count;
}

/// " at theta_x=0.1 rad", or nothing without a fourth axis.
std::string fourthAxisPlace(const Field& field, int step) {
    if (field.axes.size() < 4)
        return "";
    const FieldAxis& axis = field.axes[3];
    const double grain = 1e-6 * axis.step; // 0, not 5.55e-17
    const double value = std::round(axis.at(step) / grain) * grain + 0.0;
    return std::string(" at ") + kCoordinateNames[axis.coordinate] + '=' + formatNumber(value, 12) + ' ' +
           coordinateUnit(axis.coordinate);
}

/// Wraps `tuples` tuples from `start` on; VTK only reads them.
vtkNew<vtkDoubleArray> wrapped(const std::string& name, const std::vector<double>& numbers, int components,
                               vtkIdType start, vtkIdType tuples) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfComponents(components);
    array->SetArray(const_cast<double*>(numbers.data()) + start * components, tuples * components, 1);
    return array;
}

/// Point data: one set, or one for each step of the fourth axis.
void putSamples(vtkImageData* image, const Field& field) {
    const vtkIdType tuples = image->GetNumberOfPoints();
    const std::string name = field.unit.empty() ? field.quantity : field.quantity + '_' + field.unit;
    for (int step = 0; step < fourthAxisCount(field); ++step) {
        const std::string place = fourthAxisPlace(field, step);
        const auto values = wrapped(name + place, field.values, 1, step * tuples, tuples);
        image->GetPointData()->AddArray(values);
        if (step == 0)
            image->GetPointData()->SetActiveScalars(values->GetName());
        if (field.gradient.empty())
            continue;
        const auto gradient =
            wrapped("view_factor_gradient" + place, field.gradient, 6, step * tuples, tuples);
        for (int i = 0; i < 6; ++i)
            gradient->SetComponentName(i, (std::string("by ") + kCoordinateNames[i]).c_str());
        image->GetPointData()->AddArray(gradient);
    }
}

vtkNew<vtkDoubleArray> emptyArray(const char* name, int components) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    return array;
}

/// All surfaces one after another, with their point data.
void putSurfaces(vtkPolyData* data, const SurfaceSet& set) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> triangles;
    const auto normals = emptyArray("Normals", 3);
    const auto factors = emptyArray("view_factor", 1);
    const auto temperatures = emptyArray("steady_temperature_K", 1);
    for (std::size_t s = 0; s < set.surfaces.size(); ++s) {
        const Isosurface& surface = set.surfaces[s];
        const vtkIdType first = points->GetNumberOfPoints();
        for (std::size_t i = 0; i < surface.points.size(); ++i) {
            points->InsertNextPoint(surface.points[i].data());
            normals->InsertNextTuple(surface.normals[i].data());
            factors->InsertNextValue(surface.value);
            if (!set.steadyTemperatures_K.empty())
                temperatures->InsertNextValue(set.steadyTemperatures_K.at(s));
        }
        for (const std::array<int, 3>& triangle : surface.triangles)
            triangles->InsertNextCell({first + triangle[0], first + triangle[1], first + triangle[2]});
    }
    data->SetPoints(points);
    data->SetPolys(triangles);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetScalars(factors);
    if (!set.steadyTemperatures_K.empty())
        data->GetPointData()->AddArray(temperatures);
}

} // namespace

Result<void> checkFieldFile(const std::string& path, const std::vector<FieldAxis>& axes) {
    if (axes.size() == 4 && axes[3].count > kMaxFourthAxisSamples)
        return Error(MessageCode::FieldTooLarge,
                     std::string("fourth axis, ") + kCoordinateNames[axes[3].coordinate],
                     {std::to_string(axes[3].count), std::to_string(kMaxFourthAxisSamples)});
    return vtkfile::checkOwn(path, "ImageData", QT_TRANSLATE_NOOP("Parameter", "a field written by Bask"));
}

Result<void> writeField(const Field& field, const std::string& path, const std::string& title) {
    if (auto place = checkFieldFile(path, field.axes); !place)
        return place;
    vtkNew<vtkImageData> image;
    layOut(image, field, title);
    putSamples(image, field);
    vtkNew<vtkXMLImageDataWriter> writer;
    return vtkfile::writeWhole(writer, image, path);
}

Result<void> checkSurfaceFile(const std::string& path) {
    return vtkfile::checkOwn(path, "PolyData",
                             QT_TRANSLATE_NOOP("Parameter", "a surface file written by Bask"));
}

Result<void> writeSurfaces(const Field& field, const SurfaceSet& set, const std::string& path) {
    if (auto place = checkSurfaceFile(path); !place)
        return place;
    vtkNew<vtkPolyData> data;
    explain(data, field, set.title);
    std::vector<double> values;
    for (const Isosurface& surface : set.surfaces)
        values.push_back(surface.value);
    vtkfile::addNumbers(data, "values", values);
    putSurfaces(data, set);
    vtkNew<vtkXMLPolyDataWriter> writer;
    return vtkfile::writeWhole(writer, data, path);
}

} // namespace bask
