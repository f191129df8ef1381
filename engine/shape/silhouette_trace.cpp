#include "engine/shape/silhouette_trace.h"

#include "engine/base/message_code.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

constexpr int kMinPixels = 64;   // a smaller region says nothing of its outline
constexpr int kDustShare = 1000; // nor does one so many times smaller than the largest
constexpr int kMaxSilhouettes = 100;

struct Labels {
    cv::Mat1i of;  // of every pixel
    cv::Mat stats; // a row each; row 0 is what is not labelled
    int count = 0;

    Labels(const cv::Mat& mask, int connectivity) {
        cv::Mat centroids;
        count = cv::connectedComponentsWithStats(mask, of, stats, centroids, connectivity, CV_32S);
    }
    int area(int label) const { return stats.at<int>(label, cv::CC_STAT_AREA); }
    bool atBorder(int label) const {
        const int* row = stats.ptr<int>(label);
        return row[cv::CC_STAT_LEFT] == 0 || row[cv::CC_STAT_TOP] == 0 ||
               row[cv::CC_STAT_LEFT] + row[cv::CC_STAT_WIDTH] == of.cols ||
               row[cv::CC_STAT_TOP] + row[cv::CC_STAT_HEIGHT] == of.rows;
    }
    // Leftmost pixel of the region's top row: its upper side lies on the region's outer boundary.
    cv::Point first(int label) const {
        cv::Point p(stats.at<int>(label, cv::CC_STAT_LEFT), stats.at<int>(label, cv::CC_STAT_TOP));
        while (of(p) != label)
            ++p.x;
        return p;
    }
};

// Walks the cracks between pixels of a region and others with the region on the right hand. Where two of
// its pixels touch by a corner only, the walk keeps to the near one, as in the 4-connected labelling.
class CrackWalk {
public:
    CrackWalk(const cv::Mat1f& values, float contrast, const cv::Mat1i& labels)
        : m_values(values), m_contrast(contrast), m_labels(labels) {}

    /// From the side of a pixel that is on the boundary: 0 up, 1 right, 2 down, 3 left.
    std::vector<Eigen::Vector2d> ring(const cv::Point& start, int side) {
        std::vector<Eigen::Vector2d> points;
        const int label = m_labels(start);
        const auto holds = [&](const cv::Point& p) { return m_labels(p) == label; };
        cv::Point inside = start;
        int heading = side;
        do {
            points.push_back(zeroBetween(inside, inside + kSteps[heading]));
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
        } while (inside != start || heading != side);
        m_all += points.size();
        return points;
    }

    /// Do most points lie where the field takes the whole step from one pixel to the next?
    bool isStair() const { return 2 * m_sharp > m_all; }

private:
    const std::array<cv::Point, 4> kSteps{cv::Point(0, -1), cv::Point(1, 0), cv::Point(0, 1),
                                          cv::Point(-1, 0)};

    Eigen::Vector2d zeroBetween(const cv::Point& inside, const cv::Point& outside) {
        constexpr double kMargin = 1e-3; // keeps points of different cracks apart
        const double in = m_values(inside), out = -std::abs(m_values(outside));
        if (in - out > 0.9 * m_contrast)
            ++m_sharp;
        const double t = std::clamp(in / (in - out), kMargin, 1.0 - kMargin);
        return {inside.x + t * (outside.x - inside.x), inside.y + t * (outside.y - inside.y)};
    }

    const cv::Mat1f& m_values;
    float m_contrast;
    const cv::Mat1i& m_labels;
    std::size_t m_sharp = 0, m_all = 0;
};

struct Chosen {
    std::vector<int> labels; // of the silhouettes
    int minPixels = kMinPixels;
    int atBorder = 0;
};

Result<Chosen> choose(const Labels& inside, bool leaveOutBorder, const std::string& where) {
    int largest = 0;
    std::int64_t all = 0, kept = 0;
    for (int k = 1; k < inside.count; ++k) {
        all += inside.area(k);
        if (largest == 0 || inside.area(k) > inside.area(largest))
            largest = k;
    }
    if (largest == 0 || inside.area(largest) < kMinPixels)
        return Error{MessageCode::NoSilhouette, where};
    Chosen chosen;
    chosen.minPixels = std::max(kMinPixels, inside.area(largest) / kDustShare);
    for (int k = 1; k < inside.count; ++k) {
        if (inside.area(k) < chosen.minPixels)
            continue;
        kept += inside.area(k);
        if (inside.atBorder(k))
            ++chosen.atBorder;
        else
            chosen.labels.push_back(k);
    }
    if (2 * kept < all || chosen.labels.size() > kMaxSilhouettes)
        return Error{MessageCode::NoSilhouette, where};
    if (leaveOutBorder ? chosen.labels.empty() : inside.atBorder(largest))
        return Error{MessageCode::SilhouetteAtBorder, where};
    return chosen;
}

struct Traced {
    Silhouettes silhouettes;
    bool isStair = false;
};

Result<Traced> trace(const cv::Mat1f& values, float contrast, bool leaveOutBorder, const std::string& where) {
    const Labels inside(values > 0.0F, 4);
    const auto chosen = choose(inside, leaveOutBorder, where);
    if (!chosen)
        return chosen.error();
    Traced traced;
    traced.silhouettes.atBorder = chosen->atBorder;
    CrackWalk walk(values, contrast, inside.of);
    for (const int label : chosen->labels)
        traced.silhouettes.rings_px.push_back(walk.ring(inside.first(label), 0));
    const Labels outside(values <= 0.0F, 8);
    for (int k = 1; k < outside.count; ++k) {
        if (outside.area(k) < chosen->minPixels || outside.atBorder(k))
            continue;
        const cv::Point above = outside.first(k) + cv::Point(0, -1);
        if (std::ranges::binary_search(chosen->labels, inside.of(above)))
            traced.silhouettes.rings_px.push_back(walk.ring(above, 2));
    }
    traced.isStair = walk.isStair();
    return traced;
}

} // namespace

Result<Silhouettes> traceSilhouettes(const SignedField& field, bool leaveOutBorder,
                                     const std::string& where) {
    // 0.1 px is what anti-aliased edges tell; stairs are smoothed first, then straightened by what they hide.
    constexpr double kUncertainty_px = 0.1, kStairUncertainty_px = 0.6, kStairBlur_px = 1.0;
    const cv::Mat1f values(field.height, field.width, const_cast<float*>(field.values.data()));
    auto traced = trace(values, field.contrast, leaveOutBorder, where);
    if (!traced)
        return traced.error();
    traced->silhouettes.uncertainty_px = kUncertainty_px;
    if (traced->isStair) {
        cv::Mat1f blurred;
        cv::GaussianBlur(values, blurred, cv::Size(), kStairBlur_px, kStairBlur_px, cv::BORDER_REPLICATE);
        if (auto smooth = trace(blurred, field.contrast, leaveOutBorder, where))
            traced = std::move(smooth);
        traced->silhouettes.uncertainty_px = kStairUncertainty_px;
    }
    return std::move(traced->silhouettes);
}

} // namespace bask
