#pragma once
// The content of a DXF drawing as dxflib reads it: curves and copies of blocks, still in the file's unit.

#include "engine/base/result.h"
#include "engine/shape/flattening.h"

#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace bask {

/// Straight edges and arcs. A vertex's bulge belongs to the edge that starts at it.
struct DxfPolyline {
    struct Vertex {
        Eigen::Vector2d point;
        double bulge = 0.0;
    };
    std::vector<Vertex> vertices;
    bool closed = false;
};

struct DxfSpline {
    Spline curve;
    bool closed = false; ///< flagged as closed: its ends are joined
};

/// Copies of a block in columns and rows. Their spacing is applied before the rotation and is not scaled.
struct DxfInsert {
    std::string block;
    Eigen::Affine2d placement; ///< from the block's base point
    Eigen::Matrix2d turn;      ///< of columns and rows
    int columns = 1, rows = 1;
    Eigen::Vector2d spacing = Eigen::Vector2d::Zero();
};

struct DxfEntity {
    std::string layer;
    std::variant<DxfPolyline, EllipseArc, DxfSpline, DxfInsert> shape;
};

struct DxfBlock {
    Eigen::Vector2d base = Eigen::Vector2d::Zero();
    std::vector<DxfEntity> entities;
};

struct DxfDrawing {
    std::vector<DxfEntity> entities;
    std::map<std::string, DxfBlock> blocks;
    std::set<std::string> hidden_layers; ///< layers that are off or frozen
    int unit_code = 0;                   ///< $INSUNITS
    std::map<std::string, int> left_out; ///< number of entities, by kind, that draw no curve in the plane
    int invisible = 0;                   ///< number of entities that are marked invisible, or in paper space
};

/// Reads a drawing; has the errors of cleanDxf. Extrusion (0, 0, -1) mirrors an entity. Entities tilted out
/// of the plane are left out; z is ignored. Names are in capitals.
Result<DxfDrawing> readDxfDrawing(const std::string& bytes, const std::string& where);

} // namespace bask
