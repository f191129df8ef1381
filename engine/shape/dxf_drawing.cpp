#include "engine/shape/dxf_drawing.h"

#include "engine/base/units.h"
#include "engine/shape/dxf_groups.h"

#include <dl_creationadapter.h>
#include <dl_dxf.h>

#include <cmath>
#include <mutex>
#include <numbers>
#include <optional>
#include <sstream>

namespace bask {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

// Sweep of an arc that runs counter-clockwise; one that ends where it begins is a whole turn.
double sweepOf(double begin, double end) {
    if (std::abs(end - begin) >= kTurn * (1.0 - 1e-9))
        return kTurn;
    const double sweep = std::fmod(end - begin, kTurn);
    return sweep > 0.0 ? sweep : sweep + kTurn;
}

class Collector : public DL_CreationAdapter {
public:
    DxfDrawing take() {
        finishPolyline();
        return std::move(m_drawing);
    }

    void setVariableInt(const std::string&, int value, int) override { m_drawing.unit_code = value; }

    void addLayer(const DL_LayerData& layer) override {
        constexpr int kFrozen = 1;
        if ((layer.flags & kFrozen) || attributes.getColor() < 0) // off: a negative colour
            m_drawing.hidden_layers.insert(layer.name);
    }

    void addBlock(const DL_BlockData& block) override {
        m_block = &m_drawing.blocks[block.name];
        *m_block = {{block.bpx, block.bpy}, {}};
    }
    void endBlock() override {
        finishPolyline();
        m_block = nullptr;
    }

    void addLine(const DL_LineData& d) override { add(DxfPolyline{{{{d.x1, d.y1}}, {{d.x2, d.y2}}}, false}); }
    void addArc(const DL_ArcData& d) override {
        const double begin = radFromDeg(d.angle1);
        addCircular("ARC", {d.cx, d.cy}, d.radius, begin, sweepOf(begin, radFromDeg(d.angle2)));
    }
    void addCircle(const DL_CircleData& d) override {
        addCircular("CIRCLE", {d.cx, d.cy}, std::abs(d.radius), 0.0, kTurn);
    }

    // In world coordinates: the extrusion only says on which side of the long axis the ellipse starts.
    void addEllipse(const DL_EllipseData& d) override {
        const double side = facing();
        if (side == 0.0)
            return leaveOut("ELLIPSE");
        const Eigen::Vector2d u(d.mx, d.my);
        add(EllipseArc{{d.cx, d.cy},
                       u,
                       side * d.ratio * Eigen::Vector2d(-u.y(), u.x()),
                       d.angle1,
                       sweepOf(d.angle1, d.angle2)});
    }

    void addPolyline(const DL_PolylineData& d) override {
        constexpr int kClosed = 1, kInSpace = 8;
        finishPolyline();
        const double side = (d.flags & kInSpace) ? 1.0 : facing();
        if (side == 0.0)
            return leaveOut("POLYLINE");
        m_polyline = DxfPolyline{{}, (d.flags & kClosed) != 0};
        m_polyline_side = side;
        m_polyline_attributes = attributes;
    }
    void addVertex(const DL_VertexData& d) override {
        if (m_polyline)
            m_polyline->vertices.push_back({{m_polyline_side * d.x, d.y}, m_polyline_side * d.bulge});
    }

    void addSpline(const DL_SplineData& d) override {
        m_spline = DxfSpline{};
        m_spline->curve.degree = static_cast<int>(d.degree);
        m_spline->closed = (d.flags & 3) != 0; // closed or periodic
        m_fit_points.clear();
        m_start_direction = {d.tangentStartX, d.tangentStartY};
        m_end_direction = {d.tangentEndX, d.tangentEndY};
    }
    void addControlPoint(const DL_ControlPointData& d) override {
        m_spline->curve.control.emplace_back(d.x, d.y);
        m_spline->curve.weights.push_back(d.w);
    }
    void addFitPoint(const DL_FitPointData& d) override { m_fit_points.emplace_back(d.x, d.y); }
    void addKnot(const DL_KnotData& d) override { m_spline->curve.knots.push_back(d.k); }

    // Of a polyline or a spline.
    void endEntity() override {
        finishPolyline();
        if (!m_spline)
            return;
        if (m_spline->curve.control.empty())
            m_spline->curve =
                splineThrough(m_fit_points, m_spline->closed, m_start_direction, m_end_direction);
        add(*m_spline);
        m_spline.reset();
    }

    void addInsert(const DL_InsertData& d) override {
        const double side = facing();
        if (side == 0.0)
            return leaveOut("INSERT");
        DxfInsert insert;
        insert.block = d.name;
        insert.turn = Eigen::Vector2d(side, 1.0).asDiagonal() *
                      Eigen::Rotation2Dd(radFromDeg(d.angle)).toRotationMatrix();
        insert.placement = Eigen::Translation2d(side * d.ipx, d.ipy) * Eigen::Affine2d(insert.turn) *
                           Eigen::Scaling(d.sx, d.sy);
        insert.columns = d.cols;
        insert.rows = d.rows;
        insert.spacing = {d.colSp, d.rowSp};
        add(insert);
    }

private:
    // 1: seen from above; -1: from below, x to the left; 0: tilted.
    double facing() const {
        constexpr double kTilt = 1e-6;
        const double* n = extrusion->getDirection();
        const double flat = std::hypot(n[0], n[1]);
        if (flat == 0.0 && n[2] == 0.0)
            return 1.0;
        return flat > kTilt * std::abs(n[2]) ? 0.0 : n[2] < 0.0 ? -1.0 : 1.0;
    }

    void addCircular(const char* kind, const Eigen::Vector2d& centre, double radius, double begin,
                     double sweep) {
        const double side = facing();
        if (side == 0.0)
            return leaveOut(kind);
        add(EllipseArc{{side * centre.x(), centre.y()}, {side * radius, 0.0}, {0.0, radius}, begin, sweep});
    }

    void finishPolyline() {
        if (!m_polyline)
            return;
        const DL_Attributes now = attributes;
        attributes = m_polyline_attributes;
        add(*m_polyline);
        attributes = now;
        m_polyline.reset();
    }

    template <class Shape> void add(Shape shape) {
        if (attributes.isInPaperSpace()) {
            m_drawing.invisible += m_block == nullptr;
            return;
        }
        (m_block ? m_block->entities : m_drawing.entities)
            .push_back({attributes.getLayer(), std::move(shape)});
    }

    void leaveOut(const char* kind) {
        if (!m_block)
            ++m_drawing.left_out[kind];
    }

    DxfDrawing m_drawing;
    DxfBlock* m_block = nullptr; // being read
    std::optional<DxfPolyline> m_polyline;
    double m_polyline_side = 1.0;
    DL_Attributes m_polyline_attributes;
    std::optional<DxfSpline> m_spline;
    std::vector<Eigen::Vector2d> m_fit_points;
    Eigen::Vector2d m_start_direction, m_end_direction;
};

} // namespace

Result<DxfDrawing> readDxfDrawing(const std::string& bytes, const std::string& where) {
    auto clean = cleanDxf(bytes, where);
    if (!clean)
        return clean.error();
    Collector collector;
    {
        // dxflib counts lines in a variable of all its readers. It reads numbers by the global C++ locale,
        // which nothing here changes (setlocale does not).
        static std::mutex oneAtATime;
        const std::lock_guard lock(oneAtATime);
        std::istringstream text(clean->text);
        DL_Dxf().in(text, &collector);
    }
    DxfDrawing drawing = collector.take();
    for (const auto& [kind, count] : clean->left_out)
        drawing.left_out[kind] += count;
    drawing.invisible += clean->invisible;
    return drawing;
}

} // namespace bask
