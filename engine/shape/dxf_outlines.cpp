#include "engine/shape/dxf_outlines.h"

#include "engine/base/message_code.h"
#include "engine/shape/contour_file.h"
#include "engine/shape/dxf_drawing.h"
#include "engine/shape/outline_chains.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr std::uintmax_t kLargestDxf = std::uintmax_t{32} << 20;
constexpr std::size_t kMaxVertices = 500'000;
constexpr std::size_t kMaxPieces = 100'000;
constexpr std::size_t kMaxOutlines = 2'000;
constexpr std::size_t kDeepestBlocks = 32;
constexpr double kLargestScale = 1e15;
constexpr double kJoinedOfExtent = 1e-6;
constexpr double kJoinedMin_m = 1e-9;

struct Unit {
    int code; // of $INSUNITS
    const char* name;
    double metres;
};

// Autodesk, DXF Reference, HEADER section, $INSUNITS: those that somebody draws an object in.
constexpr std::array kUnits{
    Unit{1, "in", 0.0254},  Unit{2, "ft", 0.3048}, Unit{4, "mm", 1e-3},       Unit{5, "cm", 1e-2},
    Unit{6, "m", 1.0},      Unit{7, "km", 1e3},    Unit{8, "µin", 0.0254e-6}, Unit{9, "mil", 0.0254e-3},
    Unit{10, "yd", 0.9144}, Unit{12, "nm", 1e-9},  Unit{13, "µm", 1e-6},      Unit{14, "dm", 0.1},
};

Error tooMany(std::size_t count, const char* what, std::size_t max, const std::string& where) {
    return {MessageCode::FileTooLarge, where, {std::to_string(count) + " " + what, std::to_string(max)}};
}

// Draws the entities, and the blocks that they copy, as pieces in metres.
class Tracer {
public:
    Tracer(const DxfDrawing& drawing, const std::string& where, double tolerance_m)
        : m_drawing(drawing), m_where(where), m_tolerance_m(tolerance_m) {}

    Result<void> trace(const std::vector<DxfEntity>& entities, const Eigen::Affine2d& map_m) {
        for (const DxfEntity& entity : entities) {
            if (isHidden(entity)) {
                ++m_hidden;
                continue;
            }
            if (++m_drawn > kMaxPieces)
                return tooMany(m_drawn, "pieces", kMaxPieces, m_where);
            const auto done = std::visit([&](const auto& shape) { return draw(shape, map_m); }, entity.shape);
            if (!done)
                return done;
            if (m_points > kMaxVertices)
                return tooMany(m_points, "points", kMaxVertices, m_where);
        }
        return {};
    }

    std::vector<std::vector<Eigen::Vector2d>> takePieces() { return std::move(m_pieces); }
    int hidden() const { return m_hidden; }
    int missingBlocks() const { return m_missing_blocks; }

private:
    bool isHidden(const DxfEntity& entity) const {
        return m_drawing.hidden_layers.contains(entity.layer) && (m_blocks.empty() || entity.layer != "0");
    }

    Flattening flattening() const { return {m_tolerance_m, kMaxVertices - m_points}; }

    Result<void> keep(std::vector<Eigen::Vector2d> points) {
        if (!std::ranges::all_of(points, [](const Eigen::Vector2d& p) { return p.allFinite(); }))
            return Error{MessageCode::ContourNotFinite, m_where, {"a curve"}};
        m_points += points.size();
        m_pieces.push_back(std::move(points));
        return {};
    }

    Result<void> draw(const DxfPolyline& line, const Eigen::Affine2d& map_m) {
        constexpr double kStraight = 1e-9;
        const std::size_t count = line.vertices.size();
        if (count < 2)
            return {};
        std::vector<Eigen::Vector2d> points{map_m * line.vertices.front().point}, arc;
        for (std::size_t k = 0; k < (line.closed ? count : count - 1) && points.size() <= kMaxVertices; ++k) {
            const auto& [from, bulge] = line.vertices[k];
            const Eigen::Vector2d& to = line.vertices[(k + 1) % count].point;
            if (std::abs(bulge) > kStraight && from != to) {
                arc.clear();
                flatten(mapped(bulgeArc(from, to, bulge), map_m), flattening(), arc);
                points.insert(points.end(), arc.begin() + 1, arc.end() - 1);
            }
            points.push_back(map_m * to);
        }
        return keep(std::move(points));
    }

    Result<void> draw(const EllipseArc& arc, const Eigen::Affine2d& map_m) {
        std::vector<Eigen::Vector2d> points;
        flatten(mapped(arc, map_m), flattening(), points);
        return keep(std::move(points));
    }

    Result<void> draw(const DxfSpline& spline, const Eigen::Affine2d& map_m) {
        std::vector<Eigen::Vector2d> points;
        flatten(mapped(spline.curve, map_m), flattening(), points);
        if (spline.closed)
            points.push_back(points.front());
        return keep(std::move(points));
    }

    Result<void> draw(const DxfInsert& insert, const Eigen::Affine2d& map_m) {
        const auto block = m_drawing.blocks.find(insert.block);
        if (block == m_drawing.blocks.end()) {
            ++m_missing_blocks;
            return {};
        }
        if (std::ranges::find(m_blocks, &block->second) != m_blocks.end())
            return Error{MessageCode::DxfBlockInItself, m_where, {insert.block}};
        if (m_blocks.size() == kDeepestBlocks)
            return tooMany(kDeepestBlocks + 1, "levels of blocks", kDeepestBlocks, m_where);
        m_blocks.push_back(&block->second);
        for (int row = 0; row < std::max(1, insert.rows); ++row)
            for (int column = 0; column < std::max(1, insert.columns); ++column) {
                if (++m_drawn > kMaxPieces)
                    return tooMany(m_drawn, "pieces", kMaxPieces, m_where);
                const Eigen::Vector2d shift =
                    insert.turn * insert.spacing.cwiseProduct(Eigen::Vector2d(column, row));
                const Eigen::Affine2d copy_m = map_m * Eigen::Translation2d(shift) * insert.placement *
                                               Eigen::Translation2d(-block->second.base);
                if (!(copy_m.matrix().cwiseAbs().maxCoeff() <= kLargestScale))
                    return Error{MessageCode::ContourNotFinite, m_where, {"block " + insert.block}};
                if (const auto traced = trace(block->second.entities, copy_m); !traced)
                    return traced;
            }
        m_blocks.pop_back();
        return {};
    }

    const DxfDrawing& m_drawing;
    std::string m_where;
    double m_tolerance_m;
    std::vector<const DxfBlock*> m_blocks; // being drawn, the outermost first
    std::vector<std::vector<Eigen::Vector2d>> m_pieces;
    std::size_t m_points = 0, m_drawn = 0;
    int m_hidden = 0, m_missing_blocks = 0;
};

double joined_m(const std::vector<std::vector<Eigen::Vector2d>>& pieces) {
    Eigen::AlignedBox2d box;
    for (const auto& piece : pieces)
        for (const Eigen::Vector2d& p : piece)
            box.extend(p);
    return pieces.empty() ? kJoinedMin_m : std::max(kJoinedMin_m, kJoinedOfExtent * box.sizes().maxCoeff());
}

// "9 TEXT, 2 HATCH"
std::string listOf(const std::map<std::string, int>& counts) {
    std::string list;
    for (const auto& [kind, count] : counts)
        list += (list.empty() ? "" : ", ") + std::to_string(count) + " " + kind;
    return list;
}

} // namespace

Result<OutlineFile> dxfOutlines(const std::string& bytes, const std::string& where, double tolerance_m) {
    auto drawing = readDxfDrawing(bytes, where);
    if (!drawing)
        return drawing.error();
    OutlineFile file;
    const auto known = std::ranges::find(kUnits, drawing->unit_code, &Unit::code);
    const double unit_m = known == kUnits.end() ? 1e-3 : known->metres;
    file.unit = known == kUnits.end() ? "mm" : known->name;
    if (known == kUnits.end())
        file.warnings.push_back({MessageCode::DxfUnitless, {}});

    Tracer tracer(*drawing, where, tolerance_m);
    if (const auto traced = tracer.trace(drawing->entities, Eigen::Affine2d(Eigen::Scaling(unit_m, unit_m)));
        !traced)
        return traced.error();
    if (tracer.missingBlocks() > 0)
        drawing->left_out["INSERT"] += tracer.missingBlocks();
    if (!drawing->left_out.empty())
        file.warnings.push_back({MessageCode::ElementsUnread, {listOf(drawing->left_out)}});
    if (const int hidden = tracer.hidden() + drawing->invisible; hidden > 0)
        file.warnings.push_back({MessageCode::DxfHidden, {std::to_string(hidden)}});

    auto pieces = tracer.takePieces();
    const double join_m = joined_m(pieces);
    file.outlines = chained(std::move(pieces), join_m);
    if (file.outlines.empty())
        return Error{MessageCode::NoOutline, where};
    if (file.outlines.size() > kMaxOutlines)
        return tooMany(file.outlines.size(), "outlines", kMaxOutlines, where);
    file.arrange();
    return file;
}

Result<OutlineFile> readDxfOutlines(const std::string& path, double tolerance_m) {
    const auto bytes = readFileBytes(path, kLargestDxf);
    return bytes ? dxfOutlines(*bytes, path, tolerance_m) : bytes.error();
}

} // namespace bask
