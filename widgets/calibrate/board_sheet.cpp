#include "widgets/calibrate/board_sheet.h"

#include "engine/base/message_code.h"

#include <QBuffer>
#include <QPainter>
#include <QPainterPath>
#include <QPdfWriter>

#include <algorithm>

namespace bask {
namespace {

constexpr double kSide_mm = 10.0, kTop_mm = 14.0, kBottom_mm = 20.0; // margins of the pattern
constexpr double kLetters_mm = 3.5;
constexpr int kDotsPerInch = 1200;
constexpr int kMaxIds = 10'000; // more than any dictionary has

struct Pattern {
    std::vector<DarkSquare> squares;
    std::vector<BoardSheet::Label> labels;
    double width_mm = 0.0, height_mm = 0.0;
};

struct Markers {
    std::string dictionary;
    std::vector<int> ids;
    double side_m = 0.0;
};

// The parts of "marker:DICTIONARY:IDS:SIZE".
Result<Markers> parseMarkers(const QString& setting) {
    const QStringList parts = setting.split(':');
    const Error unreadable{MessageCode::MarkerUnreadable, "", {setting.toStdString()}};
    if (parts.size() != 4)
        return unreadable;
    bool isSize = false;
    const auto ids = parseIds(parts[2].toStdString());
    const Markers markers{parts[1].toStdString(), ids ? *ids : std::vector<int>(),
                          parts[3].toDouble(&isSize)};
    if (markers.ids.empty() || !isSize)
        return unreadable;
    if (!isMarkerDictionary(markers.dictionary))
        return Error{
            MessageCode::ValueUnknown, setting.toStdString(), {markers.dictionary, markerDictionaries()}};
    const int count = markerCount({markers.dictionary}), highest = std::ranges::max(markers.ids);
    if (highest >= count)
        return Error{MessageCode::ValueOutOfRange,
                     setting.toStdString(),
                     {std::to_string(highest), "0", std::to_string(count - 1), ""}};
    if (!(markers.side_m >= 1e-3 && markers.side_m <= 1.0))
        return Error{MessageCode::ValueOutOfRange,
                     setting.toStdString(),
                     {formatNumber(markers.side_m), "0.001", "1", "m"}};
    return markers;
}

// Between markers: a light margin, and room for the id.
double gap_mm(double side_mm) {
    return std::max(10.0, 0.25 * side_mm);
}

// Row by row; each with its id below, since a cut-out marker does not tell which it is.
Pattern markerPattern(const Markers& markers, std::span<const int> ids, int columns) {
    const double side_mm = 1e3 * markers.side_m, step_mm = side_mm + gap_mm(side_mm);
    Pattern pattern;
    for (std::size_t k = 0; k < ids.size(); ++k) {
        const Eigen::Vector2d corner_mm =
            step_mm * Eigen::Vector2d(static_cast<int>(k) % columns, static_cast<int>(k) / columns);
        for (DarkSquare square : darkSquares({markers.dictionary}, ids[k], markers.side_m)) {
            square.corner_m += 1e-3 * corner_mm;
            pattern.squares.push_back(square);
        }
        pattern.labels.push_back(
            {corner_mm + Eigen::Vector2d(0.0, side_mm + 1.5 * kLetters_mm), std::to_string(ids[k])});
        pattern.width_mm = std::max(pattern.width_mm, corner_mm.x() + side_mm);
        pattern.height_mm = corner_mm.y() + side_mm;
    }
    return pattern;
}

std::string sheetSizeText(double width_mm, double height_mm) {
    return formatNumber(width_mm) + " x " + formatNumber(height_mm);
}

QPageLayout pageOf(QPageSize::PageSizeId paper, bool isWide) {
    return {QPageSize(paper), isWide ? QPageLayout::Landscape : QPageLayout::Portrait, QMarginsF(0, 0, 0, 0),
            QPageLayout::Millimeter};
}

QSizeF roomOn(const QPageLayout& page) {
    const QSizeF size_mm = page.fullRect().size();
    return {size_mm.width() - 2.0 * kSide_mm, size_mm.height() - kTop_mm - kBottom_mm};
}

Result<BoardSheet> sheetOf(const std::string& setting, Pattern pattern, QPageSize::PageSizeId paper) {
    BoardSheet sheet;
    sheet.setting = setting;
    sheet.squares = std::move(pattern.squares);
    sheet.labels = std::move(pattern.labels);
    sheet.page = pageOf(paper, pattern.width_mm > pattern.height_mm);
    const QSizeF room_mm = roomOn(sheet.page);
    if (pattern.width_mm > room_mm.width() || pattern.height_mm > room_mm.height())
        return Error{MessageCode::SheetTooSmall,
                     setting,
                     {sheetSizeText(pattern.width_mm, pattern.height_mm),
                      QPageSize::name(paper).section(' ', 0, 0).toStdString(),
                      sheetSizeText(room_mm.width(), room_mm.height())}};
    sheet.corner_mm = {kSide_mm + 0.5 * (room_mm.width() - pattern.width_mm),
                       kTop_mm + 0.5 * (room_mm.height() - pattern.height_mm)};
    return sheet;
}

Result<std::vector<BoardSheet>> markerSheets(const std::string& setting, QPageSize::PageSizeId paper) {
    const auto markers = parseMarkers(QString::fromStdString(setting));
    if (!markers)
        return markers.error();
    const double side_mm = 1e3 * markers->side_m, gap = gap_mm(side_mm);
    const QSizeF room_mm = roomOn(pageOf(paper, false));
    const auto fitting = [&](double room) {
        return std::max(1, static_cast<int>((room + gap) / (side_mm + gap)));
    };
    const int columns = fitting(room_mm.width());
    const auto onPage = static_cast<std::size_t>(columns * fitting(room_mm.height()));
    std::vector<BoardSheet> sheets;
    for (std::span<const int> left(markers->ids); !left.empty();) {
        const auto ids = left.first(std::min(onPage, left.size()));
        left = left.subspan(ids.size());
        Pattern pattern = markerPattern(*markers, ids, columns);
        pattern.width_mm = std::min(pattern.width_mm, room_mm.width());
        auto sheet = sheetOf("marker:" + markers->dictionary + ":" + idRanges(ids) + ":" +
                                 formatNumber(markers->side_m, 6),
                             std::move(pattern), paper);
        if (!sheet)
            return sheet.error();
        sheets.push_back(std::move(*sheet));
    }
    return sheets;
}

} // namespace

Result<std::vector<int>> parseIds(const std::string& text) {
    const Error unreadable{MessageCode::MarkerUnreadable, "", {text}};
    std::vector<int> ids;
    for (const QString& part : QString::fromStdString(text).split(',')) {
        const QStringList ends = part.split('-');
        bool isFirst = false, isLast = false;
        const int first = ends.front().trimmed().toInt(&isFirst), last = ends.back().trimmed().toInt(&isLast);
        if (ends.size() > 2 || !isFirst || !isLast || first < 0 || last < first || last >= kMaxIds)
            return unreadable;
        for (int id = first; id <= last; ++id)
            if (std::ranges::find(ids, id) == ids.end())
                ids.push_back(id);
    }
    return ids;
}

std::string idRanges(std::span<const int> ids) {
    std::string text;
    for (std::size_t k = 0; k < ids.size();) {
        std::size_t last = k;
        while (last + 1 < ids.size() && ids[last + 1] == ids[last] + 1)
            ++last;
        text += (k > 0 ? "," : "") + std::to_string(ids[k]);
        if (last > k)
            text += "-" + std::to_string(ids[last]);
        k = last + 1;
    }
    return text;
}

Result<std::vector<BoardSheet>> boardSheets(const std::string& setting, QPageSize::PageSizeId paper) {
    if (setting.starts_with("marker:"))
        return markerSheets(setting, paper);
    const auto board = parseBoard(setting);
    if (!board)
        return board.error();
    auto sheet = sheetOf(setting,
                         {darkSquares(*board),
                          {},
                          1e3 * squareColumns(*board) * board->square_m,
                          1e3 * squareRows(*board) * board->square_m},
                         paper);
    if (!sheet)
        return sheet.error();
    return std::vector{std::move(*sheet)};
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
    font.setPixelSize(std::max(1, static_cast<int>(kLetters_mm * dots_mm)));
    painter.setFont(font);
    painter.setPen(QPen(Qt::black, 0.2 * dots_mm));
    const double left = kSide_mm * dots_mm, baseline = page.height() - 7.0 * dots_mm;
    painter.drawText(QPointF(left, 9.0 * dots_mm),
                     QString::fromStdString(sheet.setting) + "   print at 100 % (actual size)");
    for (const BoardSheet::Label& label : sheet.labels) {
        const Eigen::Vector2d at = dots_mm * (sheet.corner_mm + label.at_mm);
        painter.drawText(QPointF(at.x(), at.y()), QString::fromStdString(label.text));
    }
    painter.drawLine(QPointF(left, baseline), QPointF(left + kRuler_mm * dots_mm, baseline));
    for (int tick_mm = 0; tick_mm <= static_cast<int>(kRuler_mm); tick_mm += 10) {
        const double x = left + tick_mm * dots_mm;
        const double height = (tick_mm % 100 == 0 ? 4.0 : 2.0) * dots_mm;
        painter.drawLine(QPointF(x, baseline), QPointF(x, baseline - height));
    }
    painter.drawText(QPointF(left + (kRuler_mm + 4.0) * dots_mm, baseline),
                     "measure: 100 mm   measured: ________ mm");
}

QByteArray sheetPdf(const std::vector<BoardSheet>& sheets) {
    QBuffer bytes;
    bytes.open(QIODevice::WriteOnly);
    QPdfWriter writer(&bytes);
    writer.setCreator(kSheetCreator);
    writer.setResolution(kDotsPerInch);
    writer.setPageLayout(sheets.front().page);
    QPainter painter(&writer);
    for (const BoardSheet& sheet : sheets) {
        if (&sheet != &sheets.front()) {
            writer.setPageLayout(sheet.page);
            writer.newPage();
        }
        paintSheet(painter, kDotsPerInch / 25.4, sheet);
    }
    painter.end();
    return bytes.data();
}

} // namespace bask
