#include "engine/exchange/isosurface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

void checkAxes(const Field& field) {
    if (field.axes.size() != 3 ||
        std::ranges::any_of(field.axes, [](const FieldAxis& axis) { return axis.count < 2; }))
        throw std::invalid_argument("isosurfaces: three axes of at least two samples are needed");
}

/// The field as VTK's image; its samples are not copied, VTK only reads them.
void layOut(vtkImageData* image, const Field& field) {
    image->SetDimensions(field.axes[0].count, field.axes[1].count, field.axes[2].count);
    image->SetOrigin(field.axes[0].first, field.axes[1].first, field.axes[2].first);
    image->SetSpacing(field.axes[0].step, field.axes[1].step, field.axes[2].step);
    vtkNew<vtkDoubleArray> values;
    values->SetArray(const_cast<double*>(field.values.data()), static_cast<vtkIdType>(field.values.size()),
                     1);
    image->GetPointData()->SetScalars(values);
}

Eigen::Vector3d pointOf(const double* xyz) {
    return {xyz[0], xyz[1], xyz[2]};
}

Isosurface taken(vtkPolyData* found, double value) {
    Isosurface surface;
    surface.value = value;
    // A corner that is NaN spoils the points and normals near it.
    std::vector<int> index(static_cast<std::size_t>(found->GetNumberOfPoints()), -1);
    vtkDataArray* normals = found->GetPointData()->GetNormals();
    for (vtkIdType i = 0; i < found->GetNumberOfPoints(); ++i) {
        const Eigen::Vector3d point = pointOf(found->GetPoint(i));
        if (!point.allFinite())
            continue;
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        if (normals != nullptr)
            normal = pointOf(normals->GetTuple3(i)).normalized();
        index[static_cast<std::size_t>(i)] = static_cast<int>(surface.points.size());
        surface.points.push_back(point);
        surface.normals.push_back(normal.allFinite() ? normal : Eigen::Vector3d::Zero());
    }
    const auto cells = vtk::TakeSmartPointer(found->GetPolys()->NewIterator());
    for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* corners = nullptr;
        cells->GetCurrentCell(count, corners);
        std::array<int, 3> triangle{};
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = index[static_cast<std::size_t>(corners[k])];
        if (std::ranges::min(triangle) >= 0)
            surface.triangles.push_back(triangle);
    }
    return surface;
}

} // namespace

std::vector<Isosurface> isosurfaces(const Field& field, const std::vector<double>& values) {
    checkAxes(field);
    vtkNew<vtkImageData> image;
    layOut(image, field);
    std::vector<Isosurface> surfaces;
    for (const double value : values) {
        vtkNew<vtkFlyingEdges3D> edges;
        edges->SetInputData(image);
        edges->SetValue(0, value);
        edges->ComputeNormalsOn();
        edges->ComputeGradientsOff();
        edges->ComputeScalarsOff();
        edges->Update();
        surfaces.push_back(taken(edges->GetOutput(), value));
    }
    return surfaces;
}

} // namespace bask
