#include "engine/exchange/field_file.h"

#include "engine/base/message_code.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkErrorCode.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMark = "Name=\"made_by\"";
constexpr std::size_t kMarkWithin = 4096; // bytes from the start

void addWords(vtkDataSet* data, const char* name, const std::vector<std::string>& words) {
    vtkNew<vtkStringArray> array;
    array->SetName(name);
    for (const std::string& word : words)
        array->InsertNextValue(word);
    data->GetFieldData()->AddArray(array);
}

void addNumbers(vtkDataSet* data, const char* name, const std::vector<double>& numbers) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    for (const double number : numbers)
        array->InsertNextValue(number);
    data->GetFieldData()->AddArray(array);
}

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
    addWords(data, "axis_names", names);
    addWords(data, "axis_units", units);
    addNumbers(data, "axis_first", first);
    addNumbers(data, "axis_step", step);
    addNumbers(data, "axis_count", count);
}

void describeHeld(vtkDataSet* data, const Field& field) {
    std::vector<std::string> names;
    std::vector<std::string> units;
    std::vector<double> values;
    for (int i = 0; i < 6; ++i) {
        const auto coordinate = static_cast<Coordinate>(i);
        if (std::ranges::find(field.axes, coordinate, &FieldAxis::coordinate) != field.axes.end())
            continue;
        names.emplace_back(kCoordinateNames[coordinate]);
        units.emplace_back(coordinateUnit(coordinate));
        values.push_back(field.held[i]);
    }
    addWords(data, "held_names", names);
    addWords(data, "held_units", units);
    addNumbers(data, "held_values", values);
}

/// What the numbers are and how they came about.
void explain(vtkDataSet* data, const Field& field, const std::string& title) {
    addWords(data, "made_by", {"Bask " BASK_VERSION});
    addWords(data, "title", {title});
    describeAxes(data, field);
    describeHeld(data, field);
    addNumbers(data, "tolerance", {field.tolerance});
    addNumbers(data, "undefined_samples", {static_cast<double>(field.undefinedSamples)});
    addNumbers(data, "samples_above_tolerance", {static_cast<double>(field.unreachedSamples)});
    addNumbers(data, "largest_error_estimate", {field.largestErrorEstimate});
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

/// Nothing, or why it could not be written.
std::string writeData(vtkXMLWriter* writer, vtkDataSet* data, const std::string& path) {
    vtkNew<vtkCallbackCommand> silent; // with an observer VTK prints nothing of its own
    silent->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    writer->AddObserver(vtkCommand::ErrorEvent, silent);
    writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, silent);
    writer->SetFileName(path.c_str());
    writer->SetInputData(data);
    writer->SetHeaderTypeToUInt64();
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone(); // it would take longer than the sampling
    const bool done = writer->Write() == 1;
    if (writer->GetErrorCode() != vtkErrorCode::NoError)
        return vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
    return done ? "" : "VTK does not say why";
}

/// Through a temporary beside it, where a link leads.
Result<void> writeWhole(vtkXMLWriter* writer, vtkDataSet* data, const std::string& path) {
    std::error_code failed;
    const fs::path target = fs::exists(path, failed) ? fs::canonical(path, failed) : fs::path(path);
    const std::string temporary = target.string() + '.' + std::to_string(::getpid()) + ".part";
    std::string reason = writeData(writer, data, temporary);
    if (reason.empty()) {
        fs::rename(temporary, target, failed);
        if (failed)
            reason = failed.message();
    }
    if (reason.empty())
        return {};
    fs::remove(temporary, failed);
    return Error(MessageCode::FileUnwritable, path, {reason});
}

/// Refuses a file that is there, not empty and not of Bask's own of VTK's type; `kind` is that in words.
Result<void> checkOwn(const std::string& path, const std::string& type, const char* kind) {
    std::error_code failed;
    if (!fs::exists(path, failed) || (fs::file_size(path, failed) == 0 && !failed))
        return {};
    std::ifstream file(path, std::ios::binary);
    std::string start(kMarkWithin, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (!start.starts_with("<VTKFile type=\"" + type + '"') || start.find(kMark) == std::string::npos)
        return Error(MessageCode::OutputForeign, path, {kind});
    return {};
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
    if (axes.size() == 4 && axes[3].count > kMostFourthAxisSamples)
        return Error(MessageCode::FieldTooLarge,
                     std::string("fourth axis, ") + kCoordinateNames[axes[3].coordinate],
                     {std::to_string(axes[3].count), std::to_string(kMostFourthAxisSamples)});
    return checkOwn(path, "ImageData", "a field written by Bask");
}

Result<void> writeField(const Field& field, const std::string& path, const std::string& title) {
    if (auto place = checkFieldFile(path, field.axes); !place)
        return place;
    vtkNew<vtkImageData> image;
    layOut(image, field, title);
    putSamples(image, field);
    vtkNew<vtkXMLImageDataWriter> writer;
    return writeWhole(writer, image, path);
}

Result<void> checkSurfaceFile(const std::string& path) {
    return checkOwn(path, "PolyData", "a surface file written by Bask");
}

Result<void> writeSurfaces(const Field& field, const SurfaceSet& set, const std::string& path) {
    if (auto place = checkSurfaceFile(path); !place)
        return place;
    vtkNew<vtkPolyData> data;
    explain(data, field, set.title);
    std::vector<double> values;
    for (const Isosurface& surface : set.surfaces)
        values.push_back(surface.value);
    addNumbers(data, "values", values);
    putSurfaces(data, set);
    vtkNew<vtkXMLPolyDataWriter> writer;
    return writeWhole(writer, data, path);
}

} // namespace bask
