#pragma once
// Sheets of paper with a calibration board or markers on them, to be printed at their size.

#include "engine/base/result.h"
#include "engine/calibration/board.h"

#include <QPageLayout>

#include <span>
#include <string>
#include <vector>

class QPainter;

namespace bask {

constexpr double kRuler_mm = 100.0; ///< on every sheet, to be measured on the print

/// A pattern on a page: its black squares, how far its upper left corner lies from the page's, and its
/// setting.
struct BoardSheet {
    struct Label {
        Eigen::Vector2d at_mm; ///< left end of the base line, from the pattern's corner
        std::string text;
    };
    std::vector<DarkSquare> squares;
    std::vector<Label> labels; ///< the markers' ids
    Eigen::Vector2d corner_mm = Eigen::Vector2d::Zero();
    QPageLayout page;    ///< without margins
    std::string setting; ///< that makes this page
};

/// "1-4, 11", each id once. Errors: MarkerUnreadable.
Result<std::vector<int>> parseIds(const std::string& text);

/// "1-4,11", for parseIds.
std::string idRanges(std::span<const int> ids);

/// The sheets of "chessboard:9x6:0.025", "charuco:5x7:0.04:0.02:6X6_250" (one each) or
/// "marker:6X6_250:1-4,11:0.05" (dictionary, ids, side in metres, border included; as many on a page as fit),
/// upright or across as it fits. Errors: those of parseBoard and parseIds; SheetTooSmall.
Result<std::vector<BoardSheet>> boardSheets(const std::string& setting, QPageSize::PageSizeId paper);

/// Paints the pattern, the setting above and below the ruler with a place for what is measured. Takes a
/// QGuiApplication for the letters.
void paintSheet(QPainter& painter, double dots_mm, const BoardSheet& sheet);

/// A PDF with a page for each; names its maker, kSheetCreator, two bytes a letter.
QByteArray sheetPdf(const std::vector<BoardSheet>& sheets);
inline const QString kSheetCreator = QStringLiteral("bask make-board");

} // namespace bask
