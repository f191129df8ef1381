#pragma once
// Decides which pictures of a board become calibration views, and what they do not cover yet.

#include "engine/calibration/camera_calibration.h"

#include <array>
#include <deque>
#include <optional>
#include <span>

namespace bask {

/// How a view shows its board, computed without a camera model.
struct ViewPlace {
    /// Position of the box around the visible corners and one square around them: 0 at the left or upper edge
    /// of the picture, 1 at the other edge.
    double x = 0.0, y = 0.0;
    /// Square root of the fraction of the picture's area that all inner corners would cover, at the scale of
    /// the visible ones.
    double size = 0.0;
    /// Angle (rad) between board and picture from its foreshortening, towards the side of the picture that is
    /// farther away (x right, y down). Lens distortion looks like a tilt near the edges: 12 degrees for k1 =
    /// -0.1.
    Eigen::Vector2d tilt = Eigen::Vector2d::Zero();
};

/// Returns the place; empty if the corners do not determine it, for example if they are on one line.
std::optional<ViewPlace> placeOf(const BoardView& view, const Board& board, int width, int height);

/// How much of the required variety the views have, each 0..1; the value 1 is defined as in
/// camera_calibration of ROS, whose skew is the tilt here.
struct Coverage {
    static constexpr std::size_t kEnoughViews = 15;

    double x = 0.0, y = 0.0, size = 0.0, tilt = 0.0;
    std::size_t views = 0;
    /// What to do next: CoverageLeft to CoverageTiltUpDown, CoverageViews last. Empty if there is enough.
    std::vector<Message> missing;
};
Coverage coverageOf(std::span<const ViewPlace> places);

/// Number of corners of all views in each field of the picture, row by row.
struct HeatMap {
    static constexpr int kColumns = 16, kRows = 9;
    std::array<int, std::size_t{kColumns} * kRows> corners{};

    void add(const BoardView& view, int width, int height);
};

struct KeptView {
    CalibrationView view;
    ViewPlace place;
    bool isUsed = true; ///< false if a person left it out
};

/// Collects still views that differ from the ones it has, of one board in pictures of one size.
class ViewCollector {
public:
    /// Kept: it is view number views().size() - 1. Useless: too few corners, or they determine no place.
    enum class Look { Useless, Moving, Known, Kept };

    ViewCollector(Board board, int width, int height);

    /// Adds the board of the next picture. A board is still if it moved by less than 0.5 px between pictures
    /// (mean over the corners) for 0.3 s. It must move before the next view is taken.
    Look look(const BoardView& view, double time_s);
    /// Call if the board is not found in the next picture.
    void lookedInVain() { m_last.reset(); }
    /// Adds a view without checking that it is still or new; refuses a useless one.
    bool keep(const BoardView& view);
    /// Uses a view or leaves it out. A view that is left out is ignored here, and another one may replace it.
    void setUsed(std::size_t view, bool isUsed) { m_views.at(view).isUsed = isUsed; }

    const std::vector<KeptView>& views() const { return m_views; }
    std::vector<CalibrationView> used() const;
    Coverage coverage() const;
    HeatMap heatMap() const;
    const Board& board() const { return m_board; }
    int width() const { return m_width; }
    int height() const { return m_height; }

    /// Records the result of boardSeen for a picture.
    void saw(const Board& board);
    /// Returns the board that the last pictures show, if it is a different one.
    std::optional<Board> otherBoard() const;

private:
    void add(const BoardView& view, const ViewPlace& place);
    bool isKnown(const ViewPlace& place) const;

    struct LastLook {
        BoardView view;
        double still_s = 0.0; ///< start of the time at rest
        bool isTaken = false; ///< whether a view was taken since then
    };

    Board m_board;
    int m_width, m_height;
    std::optional<LastLook> m_last;
    std::vector<KeptView> m_views;
    std::deque<Board> m_seen;
};

} // namespace bask
