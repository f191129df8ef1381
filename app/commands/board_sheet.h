#pragma once
// Sheets of paper with a calibration board or a marker on it, to be printed at their size.

#include "engine/base/result.h"
#include "engine/calibration/board.h"

#include <QPageLayout>

#include <string>
#include <vector>

class QPainter;

namespace bask {

/// A pattern on a page: its black squares, how far its upper left corner lies from the page's, and its
/// setting.
struct BoardSheet {
    std::vector<DarkSquare> squares;
    Eigen::Vector2d corner_mm = Eigen::Vector2d::Zero();
    QPageLayout page; ///< without margins
    std::string setting;
};

/// The sheet of "chessboard:9x6:0.025", "charuco:5x7:0.04:0.02:6X6_250" or "marker:6X6_250:23:0.05"
/// (dictionary, id, side in metres, border included), upright or across as it fits. Errors: those of
/// parseBoard; SheetTooSmall.
Result<BoardSheet> boardSheet(const std::string& setting, QPageSize::PageSizeId paper);

/// Paints the pattern, the setting above and below a ruler of 100 mm with a place for what is measured. Takes
/// a QGuiApplication for the letters.
void paintSheet(QPainter& painter, double dots_mm, const BoardSheet& sheet);

} // namespace bask
