#pragma once
// A figure for a report: translucent surfaces and lines in boxes with axes, seen from above. Drawn
// by QPainter, so that it needs a QApplication but neither a display nor OpenGL.

#include <Eigen/Core>

#include <QByteArray>
#include <QColor>
#include <QList>
#include <QString>

#include <array>
#include <vector>

namespace bask {

struct FigureSurface {
    QString name; ///< name in the legend; surfaces with the same name and colour appear once
    QColor color;
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector3d> normals; ///< unit vectors, of either sign
    std::vector<std::array<int, 3>> triangles;
};

/// A line from blue at its start to red at its end, or of one colour.
struct FigureLine {
    std::vector<Eigen::Vector3d> points;
    QColor color; ///< if invalid: blue to red
};

/// One box. Points are in the units of its axes. The quarter of its surfaces nearest to the viewer, at larger
/// x and smaller y than the middle, is left out.
struct SurfacePanel {
    QString title;
    std::array<QString, 3> axes; ///< "x (cm)"
    Eigen::Vector3d lower = Eigen::Vector3d::Zero(), upper = Eigen::Vector3d::Ones();
    double tick = 10.0; ///< distance of the ticks
    QList<FigureSurface> surfaces;
    QList<FigureLine> lines;
};

struct SurfacesFigure {
    QString title, note;
    QList<SurfacePanel> panels;
    int columns = 2;
    int panelWidth_px = 900, panelHeight_px = 820;
};

QByteArray surfacesPng(const SurfacesFigure& figure, const QString& comment);

} // namespace bask
