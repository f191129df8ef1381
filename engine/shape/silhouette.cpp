#include "engine/shape/silhouette.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr int kLeastPixels = 64; // a smaller region says nothing of its outline

struct Region {
    cv::Mat1i labels;
    int label = 0;
    cv::Rect box;
};

Result<Region> largestRegion(const cv::Mat1f& field, const std::string& where) {
    Region region;
    cv::Mat stats, centroids;
    const cv::Mat inside = field > 0.0F;
    const int count = cv::connectedComponentsWithStats(inside, region.labels, stats, centroids, 4, CV_32S);
    int largest = 0, all = 0;
    for (int k = 1; k < count; ++k) {
        const int area = stats.at<int>(k, cv::CC_STAT_AREA);
        all += area;
        if (area > largest) {
            largest = area;
            region.label = k;
        }
    }
    if (largest < kLeastPixels || 2 * static_cast<std::int64_t>(largest) < all)
        return Error{MessageCode::NoSilhouette, where};
    const int* row = stats.ptr<int>(region.label);
    region.box = {row[cv::CC_STAT_LEFT], row[cv::CC_STAT_TOP], row[cv::CC_STAT_WIDTH],
                  row[cv::CC_STAT_HEIGHT]};
    if (region.box.x == 0 || region.box.y == 0 || region.box.br().x == field.cols ||
        region.box.br().y == field.rows)
        return Error{MessageCode::SilhouetteAtBorder, where};
    return region;
}

// Walks the cracks between pixels of the region and others with the region on the right hand. Where two of
// its pixels touch by a corner only, the walk keeps to the near one, as in the 4-connected labelling.
class CrackWalk {
public:
    CrackWalk(const SignedField& field, const Region& region) : m_field(field), m_region(region) {}

    TracedRing run() {
        const cv::Point start = firstPixel();
        cv::Point inside = start;
        int heading = 0; // the inside pixel's free side: 0 up, 1 right, 2 down, 3 left
        TracedRing ring;
        int sharp = 0;
        do {
            ring.points_px.push_back(zeroBetween(inside, inside + kSteps[heading], sharp));
            const cv::Point ahead = inside + kSteps[(heading + 1) % 4];
            const cv::Point diagonal = ahead + kSteps[heading];
            if (!holds(ahead)) {
                heading = (heading + 1) % 4;
            } else if (!holds(diagonal)) {
                inside = ahead;
            } else {
                inside = diagonal;
                heading = (heading + 3) % 4;
            }
        } while (inside != start || heading != 0);
        ring.sharpness = static_cast<double>(sharp) / static_cast<double>(ring.points_px.size());
        return ring;
    }

private:
    static constexpr std::array<int, 4> kDx{0, 1, 0, -1}, kDy{-1, 0, 1, 0};
    const std::array<cv::Point, 4> kSteps{cv::Point(kDx[0], kDy[0]), cv::Point(kDx[1], kDy[1]),
                                          cv::Point(kDx[2], kDy[2]), cv::Point(kDx[3], kDy[3])};

    bool holds(const cv::Point& p) const { return m_region.labels(p) == m_region.label; }

    // Leftmost pixel of the region's top row: its upper side is free and lies on the outer boundary.
    cv::Point firstPixel() const {
        cv::Point p = m_region.box.tl();
        while (!holds(p))
            ++p.x;
        return p;
    }

    Eigen::Vector2d zeroBetween(const cv::Point& inside, const cv::Point& outside, int& sharp) const {
        constexpr double kMargin = 1e-3; // keeps points of different cracks apart
        const double in = m_field.values(inside), out = -std::abs(m_field.values(outside));
        if (in - out > 0.9 * m_field.contrast)
            ++sharp;
        const double t = std::clamp(in / (in - out), kMargin, 1.0 - kMargin);
        return {inside.x + t * (outside.x - inside.x), inside.y + t * (outside.y - inside.y)};
    }

    const SignedField& m_field;
    const Region& m_region;
};

} // namespace

Result<TracedRing> traceLargest(const SignedField& field, const std::string& where) {
    const auto region = largestRegion(field.values, where);
    if (!region)
        return region.error();
    return CrackWalk(field, *region).run();
}

} // namespace bask
