#include "app/commands/board_sheet.h"

#include "engine/base/message_code.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace bask {
namespace {

constexpr double kSide_mm = 10.0, kTop_mm = 14.0, kBottom_mm = 20.0; // margins of the pattern
constexpr double kRuler_mm = 100.0;

struct Pattern {
    std::vector<DarkSquare> squares;
    double width_mm = 0.0, height_mm = 0.0;
};

// The parts of "marker:DICTIONARY:ID:SIZE".
Result<Pattern> markerPattern(const QString& setting) {
    const QStringList parts = setting.split(':');
    const Error unreadable{MessageCode::MarkerUnreadable, "", {setting.toStdString()}};
    if (parts.size() != 4)
        return unreadable;
    const std::string dictionary = parts[1].toStdString();
    bool isId = false, isSize = false;
    const int id = parts[2].toInt(&isId);
    const double size_m = parts[3].toDouble(&isSize);
    if (!isId || !isSize)
        return unreadable;
    if (!isMarkerDictionary(dictionary))
        return Error{MessageCode::ValueUnknown, setting.toStdString(), {dictionary, markerDictionaries()}};
    if (const int count = markerCount({dictionary}); id < 0 || id >= count)
        return Error{MessageCode::ValueOutOfRange,
                     setting.toStdString(),
                     {std::to_string(id), "0", std::to_string(count - 1), ""}};
    if (!(size_m >= 1e-3 && size_m <= 1.0))
        return Error{
            MessageCode::ValueOutOfRange, setting.toStdString(), {formatNumber(size_m), "0.001", "1", "m"}};
    return Pattern{darkSquares({dictionary}, id, size_m), 1e3 * size_m, 1e3 * size_m};
}

Result<Pattern> patternOf(const std::string& setting) {
    if (setting.starts_with("marker:"))
        return markerPattern(QString::fromStdString(setting));
    const auto board = parseBoard(setting);
    if (!board)
        return board.error();
    return Pattern{darkSquares(*board), 1e3 * squareColumns(*board) * board->square_m,
                   1e3 * squareRows(*board) * board->square_m};
}

std::string sizeText(double width_mm, double height_mm) {
    return formatNumber(width_mm) + " x " + formatNumber(height_mm);
}

} // namespace

Result<BoardSheet> boardSheet(const std::string& setting, QPageSize::PageSizeId paper) {
    auto pattern = patternOf(setting);
    if (!pattern)
        return pattern.error();
    BoardSheet sheet;
    sheet.setting = setting;
    sheet.squares = std::move(pattern->squares);
    const bool isWide = pattern->width_mm > pattern->height_mm;
    sheet.page = QPageLayout(QPageSize(paper), isWide ? QPageLayout::Landscape : QPageLayout::Portrait,
                             QMarginsF(0, 0, 0, 0), QPageLayout::Millimeter);
    const QSizeF page_mm = sheet.page.fullRect().size();
    const double roomX_mm = page_mm.width() - 2.0 * kSide_mm,
                 roomY_mm = page_mm.height() - kTop_mm - kBottom_mm;
    if (pattern->width_mm > roomX_mm || pattern->height_mm > roomY_mm)
        return Error{MessageCode::SheetTooSmall,
                     setting,
                     {sizeText(pattern->width_mm, pattern->height_mm),
                      QPageSize::name(paper).section(' ', 0, 0).toStdString(), sizeText(roomX_mm, roomY_mm)}};
    sheet.corner_mm = {kSide_mm + 0.5 * (roomX_mm - pattern->width_mm),
                       kTop_mm + 0.5 * (roomY_mm - pattern->height_mm)};
    return sheet;
}

void paintSheet(QPainter& painter, double dots_mm, const BoardSheet& sheet) {
    painter.setRenderHint(QPainter::Antialiasing);
    const QSizeF page = sheet.page.fullRect().size() * dots_mm;
    // One outline of all: seams between cells that touch would show in print.
    QPainterPath pattern;
    for (const DarkSquare& square : sheet.squares) {
        const Eigen::Vector2d at = dots_mm * (sheet.corner_mm + 1e3 * square.corner_m);
        pattern.addRect(at.x(), at.y(), 1e3 * square.side_m * dots_mm, 1e3 * square.side_m * dots_mm);
    }
    painter.fillPath(pattern.simplified(), Qt::black);

    QFont font = painter.font();
    font.setPixelSize(static_cast<int>(3.5 * dots_mm));
    painter.setFont(font);
    painter.setPen(QPen(Qt::black, 0.2 * dots_mm));
    const double left = kSide_mm * dots_mm, baseline = page.height() - 7.0 * dots_mm;
    painter.drawText(QPointF(left, 9.0 * dots_mm),
                     QString::fromStdString(sheet.setting) + "   print at 100 % (actual size)");
    painter.drawLine(QPointF(left, baseline), QPointF(left + kRuler_mm * dots_mm, baseline));
    for (int tick_mm = 0; tick_mm <= static_cast<int>(kRuler_mm); tick_mm += 10) {
        const double x = left + tick_mm * dots_mm;
        const double height = (tick_mm % 100 == 0 ? 4.0 : 2.0) * dots_mm;
        painter.drawLine(QPointF(x, baseline), QPointF(x, baseline - height));
    }
    painter.drawText(QPointF(left + (kRuler_mm + 4.0) * dots_mm, baseline),
                     "measure: 100 mm   measured: ________ mm");
}

} // namespace bask
