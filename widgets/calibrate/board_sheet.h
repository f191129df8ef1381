#pragma once
// Paper sheets with a calibration board or markers, to be printed at true size.

#include "engine/base/result.h"
#include "engine/calibration/board.h"

#include <QPageLayout>

#include <span>
#include <string>
#include <vector>

class QPainter;

namespace bask {

constexpr double kRuler_mm = 100.0; ///< ruler on every sheet, to be measured on the print

/// A pattern on a page: its black squares, the position of its upper left corner on the page, and its
/// setting.
struct BoardSheet {
    struct Label {
        Eigen::Vector2d at_mm; ///< left end of the base line, relative to the pattern's corner
        std::string text;
    };
    std::vector<DarkSquare> squares;
    std::vector<Label> labels; ///< labels with the markers' ids
    Eigen::Vector2d corner_mm = Eigen::Vector2d::Zero();
    QPageLayout page;    ///< page without margins
    std::string setting; ///< setting that makes this page
};

/// Parses "1-4, 11", each id once. Errors: MarkerUnreadable.
Result<std::vector<int>> parseIds(const std::string& text);

/// Returns "1-4,11", for parseIds.
std::string idRanges(std::span<const int> ids);

/// The sheets of "chessboard:9x6:0.025", "charuco:5x7:0.04:0.02:6X6_250" (one each) or
/// "marker:6X6_250:1-4,11:0.05" (dictionary, ids, side in metres, border included; as many on a page as fit),
/// upright or across as it fits. Errors: those of parseBoard and parseIds; SheetTooSmall.
Result<std::vector<BoardSheet>> boardSheets(const std::string& setting, QPageSize::PageSizeId paper);

/// Paints the pattern, the setting above it, and below it the ruler with a space for the measured length.
/// Needs a QGuiApplication for the letters.
void paintSheet(QPainter& painter, double dots_mm, const BoardSheet& sheet);

/// Returns a PDF with one page for each sheet; it names its creator, kSheetCreator, with two bytes per
/// letter.
QByteArray sheetPdf(const std::vector<BoardSheet>& sheets);
inline const QString kSheetCreator = QStringLiteral("bask make-board");

} // namespace bask
