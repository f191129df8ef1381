#include "engine/exchange/surface_gap.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticCellLocator.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>

namespace bask {
namespace {

/// Linear between the samples; NaN beside one that is.
double valueAt(const Field& field, const Eigen::Vector3d& point) {
    std::array<std::size_t, 3> cell{};
    std::array<double, 3> share{};
    for (std::size_t a = 0; a < 3; ++a) {
        const FieldAxis& axis = field.axes[a];
        const double at = (point[static_cast<int>(a)] - axis.first) / axis.step;
        const int below = std::clamp(static_cast<int>(at), 0, axis.count - 2);
        cell[a] = static_cast<std::size_t>(below);
        share[a] = std::clamp(at - below, 0.0, 1.0);
    }
    const auto columns = static_cast<std::size_t>(field.axes[0].count);
    const auto rows = static_cast<std::size_t>(field.axes[1].count);
    double sum = 0.0;
    for (std::size_t corner = 0; corner < 8; ++corner) {
        double weight = 1.0;
        std::array<std::size_t, 3> index = cell;
        for (std::size_t a = 0; a < 3; ++a) {
            const bool above = (corner >> a & 1U) != 0;
            weight *= above ? share[a] : 1.0 - share[a];
            index[a] += above ? 1 : 0;
        }
        sum += weight * field.values[index[0] + columns * (index[1] + rows * index[2])];
    }
    return sum;
}

/// Whether a triangle of the surface has corners on both sides of the other one.
bool meet(const Isosurface& surface, const Field& other, double otherValue) {
    std::vector<double> over;
    over.reserve(surface.points.size());
    for (const Eigen::Vector3d& point : surface.points)
        over.push_back(valueAt(other, point) - otherValue);
    return std::ranges::any_of(surface.triangles, [&over](const std::array<int, 3>& triangle) {
        const auto at = [&](std::size_t k) { return over[static_cast<std::size_t>(triangle[k])]; };
        return std::min({at(0), at(1), at(2)}) <= 0.0 && std::max({at(0), at(1), at(2)}) >= 0.0;
    });
}

/// From the first one's corners to the second one's triangles.
SurfaceGap gapBetween(const Isosurface& first, const Isosurface& second) {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Eigen::Vector3d& point : second.points)
        points->InsertNextPoint(point.data());
    vtkNew<vtkCellArray> triangles;
    for (const auto& [a, b, c] : second.triangles)
        triangles->InsertNextCell({a, b, c});
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(triangles);
    vtkNew<vtkStaticCellLocator> locator;
    locator->SetDataSet(data);
    locator->BuildLocator();
    vtkNew<vtkGenericCell> cell;
    SurfaceGap gap;
    double nearest = std::numeric_limits<double>::infinity(); // squared
    for (const Eigen::Vector3d& point : first.points) {
        Eigen::Vector3d closest;
        vtkIdType id = 0;
        int sub = 0, inside = 0;
        double squared = 0.0;
        const double reach = nearest < 1e6 ? std::sqrt(nearest) : 1e3; // farther ones are not looked for
        if (locator->FindClosestPointWithinRadius(const_cast<double*>(point.data()), reach, closest.data(),
                                                  cell, id, sub, squared, inside) == 0 ||
            squared >= nearest)
            continue;
        nearest = squared;
        gap.from = point;
        gap.to = closest;
    }
    return gap;
}

} // namespace

std::optional<SurfaceGap> widestGap(std::span<const std::shared_ptr<const Field>> fields,
                                    std::span<const Isosurface> surfaces) {
    if (fields.size() != surfaces.size())
        throw std::invalid_argument("widestGap: one field a surface is needed");
    std::optional<SurfaceGap> widest;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        for (std::size_t j = i + 1; j < surfaces.size(); ++j) {
            if (surfaces[i].empty() || surfaces[j].empty() ||
                meet(surfaces[i], *fields[j], surfaces[j].value) ||
                meet(surfaces[j], *fields[i], surfaces[i].value))
                continue;
            SurfaceGap gap = gapBetween(surfaces[i], surfaces[j]);
            gap.first = i;
            gap.second = j;
            if (!widest || gap.distance() > widest->distance())
                widest = gap;
        }
    return widest;
}

} // namespace bask
