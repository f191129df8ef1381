#include "widgets/calibrate/live_overlay.h"

#include "engine/calibration/projection.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/picture_painting.h"
#include "widgets/common/theme.h"

#include <QCoreApplication>
#include <QLocale>
#include <QPainter>

#include <algorithm>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::LivePicture)
};

constexpr bool kOnDark = true; // a picture is as it is in either theme; lines have a dark casing
const QColor kCasing(0, 0, 0, 170);

QPointF at(const OverlayPlace& place, const Eigen::Vector2d& p_px) {
    return place.map.map(QPointF(p_px.x(), p_px.y()));
}

void dot(QPainter& painter, const QPointF& middle, const QColor& colour, double radius) {
    painter.setPen(QPen(kCasing, 1.0));
    painter.setBrush(colour);
    painter.drawEllipse(middle, radius, radius);
    painter.setBrush(Qt::NoBrush);
}

// Within the picture.
void plate(QPainter& painter, const OverlayPlace& place, const QPointF& bottomLeft, const QString& text,
           const QColor& edge) {
    QRectF box(QPointF(), plateSize(painter.font(), text));
    box.moveBottomLeft(bottomLeft);
    box.moveLeft(std::clamp(box.left(), place.picture.left(),
                            std::max(place.picture.left(), place.picture.right() - box.width())));
    box.moveTop(std::max(box.top(), place.picture.top()));
    paintPlate(painter, box, text, edge);
}

// Behind the end of an axis.
void letter(QPainter& painter, const QLineF& axis, QChar text, const QColor& colour) {
    constexpr double kSide = 14.0;
    if (axis.length() < kSide)
        return;
    QRectF box(0.0, 0.0, kSide, kSide);
    box.moveCenter(axis.pointAt(1.0 + 0.6 * kSide / axis.length()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(kCasing);
    painter.drawEllipse(box);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(colour);
    painter.drawText(box.adjusted(0.0, -1.0, 0.0, -1.0), Qt::AlignCenter, QString(text));
}

QColor partColour(const std::optional<Part>& part) {
    return part ? seriesColor(static_cast<int>(*part), kOnDark) : QColor(0xd0, 0xd0, 0xd0);
}

QString markerText(const ViewedMarker& viewed) {
    QStringList words;
    if (viewed.part)
        words << partWord(*viewed.part);
    words << QString::number(viewed.marker.id);
    if (viewed.poses) {
        words << Words::tr("%1 px").arg(QLocale().toString(viewed.poses->best.rms_px, 'f', 2));
        if (viewed.poses->isAmbiguous)
            words << Words::tr("two poses");
    }
    return words.join(QStringLiteral("  "));
}

} // namespace

QString partWord(Part part) {
    switch (part) {
    case Part::Source:
        return Words::tr("source");
    case Part::EndEffector:
        return Words::tr("end-effector");
    case Part::Base:
        return Words::tr("base");
    }
    return {};
}

void paintHeatMap(QPainter& painter, const OverlayPlace& place, const HeatMap& map) {
    const int max = std::max(1, *std::ranges::max_element(map.corners));
    const double width = place.picture.width() / HeatMap::kColumns;
    const double height = place.picture.height() / HeatMap::kRows;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (int row = 0; row < HeatMap::kRows; ++row)
        for (int column = 0; column < HeatMap::kColumns; ++column) {
            const int count = map.corners[static_cast<std::size_t>(row * HeatMap::kColumns + column)];
            const QRectF field(place.picture.left() + column * width, place.picture.top() + row * height,
                               width, height);
            QColor colour = mapColour(static_cast<double>(count) / max, kOnDark);
            colour.setAlphaF(0.5F);
            if (count > 0)
                painter.fillRect(field, colour);
            painter.setPen(QColor(255, 255, 255, 50));
            painter.drawRect(field);
        }
    painter.restore();
}

void paintBoard(QPainter& painter, const OverlayPlace& place, const BoardView& board, int columns) {
    const int rows = board.corners.empty() ? 1 : *std::ranges::max_element(board.corners) / columns + 1;
    const auto colour = [&](std::size_t k) {
        return mapColour(0.4 + 0.6 * (board.corners[k] / columns) / std::max(1, rows - 1), kOnDark);
    };
    QPolygonF line; // corners in a row without a gap
    for (std::size_t k = 0; k < board.corners.size(); ++k) {
        line << at(place, board.corners_px[k]);
        const bool goesOn = k + 1 < board.corners.size() && board.corners[k + 1] == board.corners[k] + 1 &&
                            board.corners[k + 1] / columns == board.corners[k] / columns;
        if (!goesOn)
            paintCased(painter, std::exchange(line, {}), QPen(colour(k), 1.6));
    }
    for (std::size_t k = 0; k < board.corners.size(); ++k)
        dot(painter, at(place, board.corners_px[k]), colour(k), k == 0 ? 5.0 : 3.0);
}

void paintMarkers(QPainter& painter, const OverlayPlace& place, const std::vector<ViewedMarker>& markers,
                  const std::optional<CameraModel>& camera) {
    for (const ViewedMarker& viewed : markers) {
        const QColor colour = partColour(viewed.part);
        QPolygonF outline;
        for (const Eigen::Vector2d& corner : viewed.marker.corners_px)
            outline << at(place, corner);
        const QPointF first = outline.front();
        outline << first;
        paintCased(painter, outline, QPen(colour, 2.0));
        dot(painter, first, colour, 4.0);
        plate(painter, place, outline.boundingRect().topLeft() - QPointF(0.0, 6.0), markerText(viewed),
              colour);
    }
    for (const ViewedMarker& viewed : markers) // not hidden by the words
        if (viewed.poses && camera)
            paintAxes(painter, place, viewed.poses->best.X_CM(), 0.4 * viewed.side_m, *camera,
                      viewed.poses->isAmbiguous);
}

void paintAxes(QPainter& painter, const OverlayPlace& place, const Pose& X_CF, double length_m,
               const CameraModel& camera, bool isUncertain) {
    // Purple, green, blue: near the customary red, green, blue, without the alarms' red.
    static constexpr int kColours[] = {2, 1, 0};
    const Lens lens(camera);
    const Eigen::Vector3d origin = X_CF.translation();
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d end = X_CF * Eigen::Vector3d(length_m * Eigen::Vector3d::Unit(axis));
        if (origin.z() <= 0.0 || end.z() <= 0.0)
            continue;
        const QColor colour = seriesColor(kColours[axis], kOnDark);
        const QLineF line(at(place, shownAt(lens, origin)), at(place, shownAt(lens, end)));
        paintCased(painter, {line.p1(), line.p2()},
                   QPen(colour, 2.4, isUncertain ? Qt::DotLine : Qt::SolidLine));
        letter(painter, line, QChar('x' + axis), colour);
    }
}

} // namespace bask
