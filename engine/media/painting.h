#pragma once
// What paints, loaded when it is first wanted: Qt's painter and its SVG bring 40 libraries of a display,
// which would cost every start of a command a sixth of its processor time.

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// A point of a painted path: where it begins or begins anew, the end of a line, or one of the three points
/// of a Bezier curve after its beginning.
struct PaintedPoint {
    enum class Kind : std::uint8_t { Move, Line, Curve };
    Kind kind;
    Eigen::Vector2d at_px;
};

/// Takes the shapes that a drawing paints, one after the other; of one that is filled and stroked one.
class PaintedShapes {
public:
    virtual ~PaintedShapes() = default;
    /// Whether a path of so many points is still wanted; asked of each before it is looked at.
    virtual bool wants(int points) = 0;
    /// `isClosed`: all its parts are, however they end.
    virtual void add(const std::vector<PaintedPoint>& path, bool isClosed) = 0;
};

/// Closed lines with their area (odd-even), or open ones without.
struct PictureLayer {
    std::vector<std::vector<Eigen::Vector2d>> lines_px; ///< y down
    bool isClosed = true;
    std::array<std::uint8_t, 3> ink{};
    double width_px = 1.0;
    std::optional<std::uint8_t> fillOpacity{}; ///< of the ink over the area, of 255; none: not filled
};

/// Any thread; needs no application and no display.
class Painting {
public:
    virtual ~Painting() = default;
    /// Paints an SVG on a page of 1,000 user units, without its size. Returns false if it is none.
    virtual bool svg(const std::string& xml, PaintedShapes& out) const = 0;
    /// Returns a square PNG on white, smooth, with a text "Software" near its beginning.
    virtual std::string png(int size_px, const std::string& software,
                            const std::vector<PictureLayer>& layers) const = 0;
};

/// Any thread. Errors: throws std::runtime_error where this part of the program cannot be loaded, which is
/// also said on standard error.
const Painting& painting();

} // namespace bask
