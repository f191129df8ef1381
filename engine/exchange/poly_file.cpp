#include "engine/exchange/poly_file.h"

#include "engine/base/message_code.h"
#include "engine/base/translated.h"
#include "engine/exchange/vtk_inside.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace bask {
namespace {

constexpr const char* kCollectionMark = "<!-- written by Bask -->";

void putArrays(vtkDataSetAttributes* where, const std::vector<PolyArray>& arrays, std::size_t count) {
    for (const PolyArray& each : arrays) {
        if (each.values.size() != count * static_cast<std::size_t>(each.components))
            throw std::invalid_argument("writePolyFile: " + each.name + " has another length");
        vtkNew<vtkDoubleArray> array;
        array->SetName(each.name.c_str());
        array->SetNumberOfComponents(each.components);
        array->SetNumberOfTuples(static_cast<vtkIdType>(count));
        for (std::size_t k = 0; k < each.values.size(); ++k)
            array->SetValue(static_cast<vtkIdType>(k), each.values[k]);
        where->AddArray(array);
    }
    if (!arrays.empty())
        where->SetActiveScalars(arrays.front().name.c_str());
}

} // namespace

Result<void> checkPolyFile(const std::string& path) {
    return vtkfile::checkOwn(path, "PolyData", QT_TRANSLATE_NOOP("Parameter", "lines written by Bask"));
}

Result<void> writePolyFile(const PolyLines& poly, const std::string& path) {
    if (auto place = checkPolyFile(path); !place)
        return place;
    vtkNew<vtkPolyData> data;
    vtkfile::addOrigin(data, poly.title);
    for (const auto& [name, words] : poly.words)
        vtkfile::addWords(data, name.c_str(), words);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Eigen::Vector3d& point : poly.points)
        points->InsertNextPoint(point.data());
    vtkNew<vtkCellArray> lines;
    for (const std::vector<int>& line : poly.lines) {
        lines->InsertNextCell(static_cast<int>(line.size()));
        for (const int point : line)
            lines->InsertCellPoint(point);
    }
    data->SetPoints(points);
    data->SetLines(lines);
    putArrays(data->GetPointData(), poly.pointData, poly.points.size());
    putArrays(data->GetCellData(), poly.lineData, poly.lines.size());
    vtkNew<vtkXMLPolyDataWriter> writer;
    return vtkfile::writeWhole(writer, data, path);
}

std::string collectionXml(const std::vector<TimedFile>& files) {
    std::string text =
        std::string("<?xml version=\"1.0\"?>\n") + kCollectionMark +
        "\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  <Collection>\n";
    for (const TimedFile& file : files)
        text += "    <DataSet timestep=\"" + formatNumber(file.time_s, 12) +
                "\" group=\"\" part=\"0\" file=\"" + file.name + "\"/>\n";
    return text + "  </Collection>\n</VTKFile>\n";
}

Result<void> checkCollectionFile(const std::string& path) {
    std::error_code failed;
    if (!std::filesystem::exists(path, failed) || (std::filesystem::file_size(path, failed) == 0 && !failed))
        return {};
    std::ifstream file(path, std::ios::binary);
    std::string start(256, '\0');
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (start.find(kCollectionMark) == std::string::npos)
        return Error(MessageCode::OutputForeign, path,
                     {QT_TRANSLATE_NOOP("Parameter", "a collection written by Bask")});
    return {};
}

} // namespace bask
