#include "engine/shape/contour_import.h"

#include "engine/shape/contour_file.h"
#include "engine/shape/image_header.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace bask {
namespace {

/// Field over the pixels, positive inside of the silhouettes and negative on the ground; `contrast` is the
/// step between the two.
struct SignedField {
    cv::Mat1f values;
    float contrast = 1.0F;
};

/// A traced ring: zero line of the field in pixels, x right and y down, pixel centres at whole numbers.
struct TracedRing {
    std::vector<Eigen::Vector2d> points_px;
    double sharpness =
        0.0; ///< share of the points where the field takes the whole step from one pixel to the next
};

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

/// Outer zero line of the largest 4-connected region where the field is positive (marching squares).
/// Errors: NoSilhouette (none, tiny, or less than half of all that is positive), SilhouetteAtBorder.
Result<TracedRing> traceLargest(const SignedField& field, const std::string& where) {
    const auto region = largestRegion(field.values, where);
    if (!region)
        return region.error();
    return CrackWalk(field, *region).run();
}

constexpr std::uintmax_t kLargestFile = std::uintmax_t{256} << 20;
constexpr std::uint64_t kMostPixels = 64'000'000;
constexpr int kLevels = 256;

Result<void> checkPixels(std::uint64_t pixels, const std::string& path) {
    const auto megapixels = [](std::uint64_t n) {
        return formatNumber(static_cast<double>(n) / 1e6) + " megapixels";
    };
    if (pixels > kMostPixels)
        return Error{MessageCode::FileTooLarge, path, {megapixels(pixels), megapixels(kMostPixels)}};
    return {};
}

Result<cv::Mat> decoded(const std::string& bytes, const std::string& path) {
    if (const auto pixels = announcedPixels(bytes))
        if (const auto checked = checkPixels(*pixels, path); !checked)
            return checked.error();
    if (isJpeg(bytes) && !isCompleteJpeg(bytes))
        return Error{MessageCode::ImageUnreadable, path};
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    // Only the first way turns a photograph as its EXIF says, only the second keeps an alpha channel.
    const int how = isJpeg(bytes) ? cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH : cv::IMREAD_UNCHANGED;
    cv::Mat image = cv::imdecode(raw, how);
    if (image.empty() || (image.depth() != CV_8U && image.depth() != CV_16U))
        return Error{MessageCode::ImageUnreadable, path};
    if (const auto checked = checkPixels(image.total(), path); !checked)
        return checked.error();
    return image;
}

// Channel `k` as floats in [0, 1].
cv::Mat1f channel(const cv::Mat& image, int k) {
    cv::Mat one;
    cv::extractChannel(image, one, k);
    cv::Mat1f scaled;
    one.convertTo(scaled, CV_32F, image.depth() == CV_16U ? 1.0 / 65535.0 : 1.0 / 255.0);
    return scaled;
}

cv::Mat1f brightness(const cv::Mat& image) {
    if (image.channels() < 3)
        return channel(image, 0);
    cv::Mat grey;
    cv::cvtColor(image, grey, image.channels() == 4 ? cv::COLOR_BGRA2GRAY : cv::COLOR_BGR2GRAY);
    return channel(grey, 0);
}

// Opacity, when the picture has some and it tells a silhouette from a ground.
std::optional<SignedField> opacityField(const cv::Mat& image) {
    if (image.channels() != 2 && image.channels() != 4)
        return std::nullopt;
    SignedField field;
    field.values = channel(image, image.channels() - 1) - 0.5F;
    const int opaque = cv::countNonZero(field.values > 0.0F);
    if (opaque == 0 || opaque == static_cast<int>(field.values.total()))
        return std::nullopt;
    return field;
}

// Histogram between the least and the largest value, so that dim 16-bit pictures keep their levels.
struct Histogram {
    double least = 0.0;
    double width = 0.0; // of one level
    std::vector<double> counts = std::vector<double>(kLevels, 0.0);

    explicit Histogram(const cv::Mat1f& values) {
        double most = 0.0;
        cv::minMaxLoc(values, &least, &most);
        width = (most - least) / (kLevels - 1);
        if (width <= 0.0)
            return;
        for (const float value : values)
            counts[static_cast<std::size_t>(std::lround((value - least) / width))] += 1.0;
    }

    double valueOf(double level) const { return least + width * level; }

    double median(std::size_t from, std::size_t to) const {
        const double half = 0.5 * std::accumulate(counts.begin() + static_cast<std::ptrdiff_t>(from),
                                                  counts.begin() + static_cast<std::ptrdiff_t>(to), 0.0);
        double sum = 0.0;
        for (std::size_t k = from; k < to; ++k)
            if ((sum += counts[k]) >= half)
                return valueOf(static_cast<double>(k));
        return valueOf(static_cast<double>(to));
    }
};

struct TwoLevels {
    double dark = 0.0;
    double light = 0.0;
};

// Otsu's split; refused when the two classes explain too little of the picture's variance to be an object and
// a ground (noise gives 0.64, a clean silhouette above 0.95).
std::optional<TwoLevels> twoLevels(const cv::Mat1f& values) {
    constexpr double kLeastExplained = 0.7, kLeastContrast = 0.02;
    const Histogram histogram(values);
    if (histogram.width <= 0.0)
        return std::nullopt;
    const double total = static_cast<double>(values.total());
    double sum = 0.0, sum2 = 0.0;
    for (std::size_t k = 0; k < kLevels; ++k) {
        sum += histogram.counts[k] * static_cast<double>(k);
        sum2 += histogram.counts[k] * static_cast<double>(k * k);
    }
    const double variance = sum2 / total - (sum / total) * (sum / total);
    double below = 0.0, sumBelow = 0.0, best = 0.0;
    std::size_t split = 0;
    for (std::size_t k = 0; k + 1 < kLevels; ++k) {
        below += histogram.counts[k];
        sumBelow += histogram.counts[k] * static_cast<double>(k);
        if (below == 0.0 || below == total)
            continue;
        const double difference = sumBelow / below - (sum - sumBelow) / (total - below);
        const double between = below * (total - below) / (total * total) * difference * difference;
        if (between > best) {
            best = between;
            split = k + 1;
        }
    }
    if (best < kLeastExplained * variance)
        return std::nullopt;
    const TwoLevels levels{histogram.median(0, split), histogram.median(split, kLevels)};
    return levels.light - levels.dark < kLeastContrast ? std::nullopt : std::optional(levels);
}

// Is most of the picture's frame of positive value?
bool frameIsPositive(const cv::Mat1f& values) {
    int positive = 0, all = 0;
    const auto count = [&](const cv::Mat& line) {
        positive += cv::countNonZero(line > 0.0F);
        all += static_cast<int>(line.total());
    };
    count(values.row(0));
    count(values.row(values.rows - 1));
    count(values.col(0));
    count(values.col(values.cols - 1));
    return 2 * positive > all;
}

// Brightness cut halfway between ground and object, where the true edge of an anti-aliased outline runs.
std::optional<SignedField> brightnessField(const cv::Mat& image) {
    SignedField field;
    field.values = brightness(image);
    const auto levels = twoLevels(field.values);
    if (!levels)
        return std::nullopt;
    field.values -= static_cast<float>(0.5 * (levels->dark + levels->light));
    field.contrast = static_cast<float>(levels->light - levels->dark);
    if (frameIsPositive(field.values))
        field.values *= -1.0F;
    return field;
}

Result<Contour> outlineOf(SignedField field, double scale_px_per_mm, const std::string& path) {
    // 0.1 px is what anti-aliased edges tell; where the picture is black and white only, its outline is a
    // stair that is known to half a pixel: smoothed first, then straightened by that much.
    constexpr double kThinning_px = 0.1, kThinning_mm = 0.01, kStairThinning_px = 0.6, kStairBlur_px = 1.0;
    auto ring = traceLargest(field, path);
    if (!ring)
        return ring.error();
    double thinning_px = std::max(kThinning_px, kThinning_mm * scale_px_per_mm);
    if (ring->sharpness > 0.5) {
        cv::GaussianBlur(field.values, field.values, cv::Size(), kStairBlur_px, kStairBlur_px,
                         cv::BORDER_REPLICATE);
        if (auto smooth = traceLargest(field, path))
            ring = std::move(smooth);
        thinning_px = std::max(thinning_px, kStairThinning_px);
    }
    const double metresPerPixel = 1e-3 / scale_px_per_mm;
    std::vector<Eigen::Vector2d> points_m;
    points_m.reserve(ring->points_px.size());
    for (const Eigen::Vector2d& p : ring->points_px)
        points_m.emplace_back((p.x() + 0.5) * metresPerPixel,
                              (field.values.rows - p.y() - 0.5) * metresPerPixel);
    const auto contour = makeContour(std::move(points_m), path);
    if (!contour)
        return contour.error();
    return simplified(*contour, thinning_px * metresPerPixel);
}

} // namespace

Result<Contour> readContourImage(const std::string& path, double scale_px_per_mm) {
    if (!(scale_px_per_mm > 0.0) || !std::isfinite(scale_px_per_mm))
        return Error{MessageCode::ScaleNotPositive, path, {formatNumber(scale_px_per_mm)}};
    const auto bytes = readFileBytes(path, kLargestFile);
    if (!bytes)
        return bytes.error();
    try {
        const auto image = decoded(*bytes, path);
        if (!image)
            return image.error();
        const auto opacity = opacityField(*image);
        // A ground that is opaque (only its corners rounded, say) leaves the silhouette to the brightness.
        const bool grounded = opacity && !frameIsPositive(opacity->values);
        auto field = grounded ? opacity : brightnessField(*image);
        if (!field)
            field = opacity;
        if (!field)
            return Error{MessageCode::NoSilhouette, path};
        return outlineOf(std::move(*field), scale_px_per_mm, path);
    } catch (const std::exception&) { // cv::Exception and what allocation throws
        return Error{MessageCode::ImageUnreadable, path};
    }
}

} // namespace bask
