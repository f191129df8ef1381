#pragma once
// Which looks at a board become views of a calibration, and what they do not cover yet.

#include "engine/calibration/camera_calibration.h"

#include <array>
#include <deque>
#include <optional>
#include <span>

namespace bask {

/// How a view shows its board, without a camera being known.
struct ViewPlace {
    /// Of the box of the seen corners and a square around them: 0 at the left or upper edge of the picture,
    /// 1 at the other.
    double x = 0.0, y = 0.0;
    /// Square root of what all inner corners would take of the picture's area, seen as near as those are.
    double size = 0.0;
    /// Angle (rad) between board and picture by its foreshortening, towards the side of the picture that is
    /// farther away (x right, y down). A lens's distortion looks like a tilt near the edges: 12 degrees for
    /// k1 = -0.1.
    Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
};

/// Nothing for corners that tell no place, such as those in one line.
std::optional<ViewPlace> placeOf(const BoardView& view, const Board& board, int width, int height);

/// How much of what a calibration needs its views have, each 0..1; what 1 is follows camera_calibration of
/// ROS, whose skew is the tilt here.
struct Coverage {
    static constexpr std::size_t kEnoughViews = 15;

    double x = 0.0, y = 0.0, size = 0.0, tilt = 0.0;
    std::size_t views = 0;
    /// What to do: CoverageLeft to CoverageTiltUpDown, CoverageViews last. Empty: it is enough.
    std::vector<Message> missing;
};
Coverage coverageOf(std::span<const ViewPlace> places);

/// Corners of all views, counted in fields of the picture, row by row.
struct HeatMap {
    static constexpr int kColumns = 16, kRows = 9;
    std::array<int, std::size_t{kColumns} * kRows> corners{};

    void add(const BoardView& view, int width, int height);
};

struct KeptView {
    CalibrationView view;
    ViewPlace place;
    bool isUsed = true; ///< not left out by somebody
};

/// Takes still views that differ from those there are. Of one board in pictures of one size.
class ViewCollector {
public:
    /// Kept: as view number views().size() - 1. Useless: too few of its corners, or they tell no place.
    enum class Look { Useless, Moving, Known, Kept };

    ViewCollector(Board board, int width, int height);

    /// The board in the next picture. Still is: moved by less than 0.5 px from look to look (mean over the
    /// corners), for 0.3 s. Before the next view it has to move.
    Look look(const BoardView& view, double time_s);
    /// The next picture does not show it.
    void lookedInVain() { m_last.reset(); }
    /// Takes a view still or not, new or not; not a useless one.
    bool keep(const BoardView& view);
    /// One that is left out counts for nothing here, and another may be taken in its place.
    void setUsed(std::size_t view, bool isUsed) { m_views.at(view).isUsed = isUsed; }

    const std::vector<KeptView>& views() const { return m_views; }
    std::vector<CalibrationView> used() const;
    Coverage coverage() const;
    HeatMap heatMap() const;
    const Board& board() const { return m_board; }
    int width() const { return m_width; }
    int height() const { return m_height; }

    /// boardSeen's answer for a picture.
    void saw(const Board& board);
    /// The board that the last pictures show, when that is another.
    std::optional<Board> otherBoard() const;

private:
    void add(const BoardView& view, const ViewPlace& place);
    bool isKnown(const ViewPlace& place) const;

    struct LastLook {
        BoardView view;
        double still_s = 0.0; ///< since when
        bool isTaken = false; ///< since then
    };

    Board m_board;
    int m_width, m_height;
    std::optional<LastLook> m_last;
    std::vector<KeptView> m_views;
    std::deque<Board> m_seen;
};

} // namespace bask
