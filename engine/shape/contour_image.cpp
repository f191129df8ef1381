#include "engine/shape/contour_import.h"

#include "engine/shape/contour_file.h"
#include "engine/shape/image_header.h"
#include "engine/shape/silhouette.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace bask {
namespace {

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
