#include "engine/base/message_code.h"
#include "engine/media/media.h"
#include "engine/shape/contour_import.h"

#include "engine/shape/contour_file.h"
#include "engine/shape/image_header.h"
#include "engine/shape/marker.h"
#include "engine/shape/picture_plane.h"
#include "engine/shape/silhouette_trace.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace bask {
namespace {

constexpr std::uintmax_t kLargestPicture = std::uintmax_t{256} << 20;
constexpr std::uint64_t kMaxPixels = 64'000'000;
constexpr int kLevels = 256;

Result<void> checkPixels(std::uint64_t pixels, const std::string& path) {
    const auto megapixels = [](std::uint64_t n) {
        return formatNumber(static_cast<double>(n) / 1e6) + " megapixels";
    };
    if (pixels > kMaxPixels)
        return Error{MessageCode::FileTooLarge, path, {megapixels(pixels), megapixels(kMaxPixels)}};
    return {};
}

Result<cv::Mat> decoded(const std::string& bytes, const std::string& path) {
    const auto pixels = announcedPixels(bytes); // none: a format whose size is known only once it is unpacked
    if (!pixels || (isJpeg(bytes) && !isCompleteJpeg(bytes)))
        return Error{MessageCode::ImageUnreadable, path};
    if (const auto checked = checkPixels(*pixels, path); !checked)
        return checked.error();
    const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
    // Only the first way turns a photograph as its EXIF says, only the second keeps an alpha channel.
    const int how = isJpeg(bytes) ? cv::IMREAD_ANYCOLOR | cv::IMREAD_ANYDEPTH : cv::IMREAD_UNCHANGED;
    cv::Mat image = isJpeg(bytes) ? cv::Mat() : decodePlainPng(raw);
    if (image.empty())
        image = pictureCodecs().decode(raw, how);
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

GreyPicture greyPicture(const cv::Mat& image) {
    cv::Mat1b values;
    brightness(image).convertTo(values, CV_8U, 255.0);
    return {image.cols, image.rows, bytesOf(values)};
}

/// A field before it is traced.
struct Field {
    cv::Mat1f values;
    double contrast = 1.0;
};

bool hasAlpha(const cv::Mat& image) {
    return image.channels() == 2 || image.channels() == 4;
}

// Opacity, when the picture has some and it tells a silhouette from a ground.
std::optional<Field> opacityField(const cv::Mat& image) {
    if (!hasAlpha(image))
        return std::nullopt;
    Field field;
    field.values = channel(image, image.channels() - 1) - 0.5F;
    const int opaque = cv::countNonZero(field.values > 0.0F);
    if (opaque == 0 || opaque == static_cast<int>(field.values.total()))
        return std::nullopt;
    return field;
}

// Histogram between the least and the largest value, so that dim 16-bit pictures keep their levels.
struct Histogram {
    double min = 0.0;
    double width = 0.0; // of one level
    std::vector<double> counts = std::vector<double>(kLevels, 0.0);

    explicit Histogram(const cv::Mat1f& values) {
        double max = 0.0;
        cv::minMaxLoc(values, &min, &max);
        width = (max - min) / (kLevels - 1);
        if (width <= 0.0)
            return;
        const double begin = min - 0.5 * width; // of the first level: values are rounded to the nearest
        for (int y = 0; y < values.rows; ++y)
            for (const float value : std::span(values[y], static_cast<std::size_t>(values.cols)))
                counts[static_cast<std::size_t>((value - begin) / width)] += 1.0;
    }

    double valueOf(double level) const { return min + width * level; }

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
    constexpr double kMinExplained = 0.7, kMinContrast = 0.02;
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
    if (best < kMinExplained * variance)
        return std::nullopt;
    const TwoLevels levels{histogram.median(0, split), histogram.median(split, kLevels)};
    return levels.light - levels.dark < kMinContrast ? std::nullopt : std::optional(levels);
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
std::optional<Field> brightnessField(const cv::Mat& image) {
    Field field;
    field.values = brightness(image);
    const auto levels = twoLevels(field.values);
    if (!levels)
        return std::nullopt;
    field.values -= static_cast<float>(0.5 * (levels->dark + levels->light));
    field.contrast = levels->light - levels->dark;
    if (frameIsPositive(field.values))
        field.values *= -1.0F;
    return field;
}

// Distance of every pixel's colour from the one picked, in CIE Lab; what is transparent is far from any.
cv::Mat1f colourDistance(const cv::Mat& image, const std::array<std::uint8_t, 3>& rgb) {
    constexpr float kFar = 100.0F;
    cv::Mat3f picked(1, 1, cv::Vec3f(rgb[2], rgb[1], rgb[0]) / 255.0F);
    cv::cvtColor(picked, picked, cv::COLOR_BGR2Lab);
    const cv::Vec3f wanted = picked(0, 0);
    cv::Mat1f distance(image.size());
    const double scale = image.depth() == CV_16U ? 1.0 / 65535.0 : 1.0 / 255.0;
    for (int y = 0; y < image.rows; ++y) { // row by row: a large picture would take much as three floats
        cv::Mat row = image.row(y), alpha;
        if (hasAlpha(image))
            cv::extractChannel(row, alpha, image.channels() - 1);
        if (image.channels() < 3) {
            cv::extractChannel(row, row, 0);
            cv::cvtColor(row, row, cv::COLOR_GRAY2BGR);
        } else if (image.channels() == 4) {
            cv::cvtColor(row, row, cv::COLOR_BGRA2BGR);
        }
        cv::Mat3f lab;
        row.convertTo(lab, CV_32F, scale);
        cv::cvtColor(lab, lab, cv::COLOR_BGR2Lab);
        for (int x = 0; x < image.cols; ++x)
            distance(y, x) = static_cast<float>(cv::norm(lab(0, x) - wanted));
        if (!alpha.empty())
            distance.row(y).setTo(kFar, alpha < 0.5 / scale);
    }
    return distance;
}

// Near the colour picked: within its tolerance, else halfway between those near and those far by Otsu's
// split, if the near ones have that colour at all.
std::optional<Field> colourField(const cv::Mat& image, const PickedColour& colour) {
    constexpr double kMaxUnlike = 30.0;
    constexpr double kUsualTolerance = 20.0; // where the ground has too many colours for two levels
    const cv::Mat1f distance = colourDistance(image, colour.rgb);
    const auto levels = colour.tolerance ? std::nullopt : twoLevels(distance);
    if (!levels) {
        const double tolerance = colour.tolerance.value_or(kUsualTolerance);
        // Farther off counts the same: edges lie in the middle.
        return Field{cv::Mat1f(cv::max(tolerance - distance, -tolerance)), 2.0 * tolerance};
    }
    if (levels->dark > kMaxUnlike)
        return std::nullopt;
    return Field{cv::Mat1f(0.5 * (levels->dark + levels->light) - distance), levels->light - levels->dark};
}

std::optional<Field> fieldOf(const cv::Mat& image, const std::optional<PickedColour>& colour) {
    if (colour)
        return colourField(image, *colour);
    const auto opacity = opacityField(image);
    // A ground that is opaque (only its corners rounded, say) leaves the silhouette to the brightness.
    if (opacity && !frameIsPositive(opacity->values))
        return opacity;
    const auto field = brightnessField(image);
    return field ? field : opacity;
}

SignedField signedField(const cv::Mat1f& values, double contrast) {
    return {values.cols, values.rows, floatsOf(values), static_cast<float>(contrast)};
}

// The marker as its surroundings, so that it is neither a silhouette nor counts among the levels.
void paintOver(cv::Mat& image, const FoundMarker& marker) {
    constexpr double kGrowth = 1.08; // a quarter of a square of the marker more on every side
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& corner : marker.corners_px)
        middle += 0.25 * corner;
    std::vector<cv::Point> quad;
    for (const Eigen::Vector2d& corner : marker.corners_px) {
        const Eigen::Vector2d p = middle + kGrowth * (corner - middle);
        quad.emplace_back(static_cast<int>(std::lround(p.x())), static_cast<int>(std::lround(p.y())));
    }
    cv::Mat1b rim(image.size(), 0);
    cv::polylines(rim, quad, true, cv::Scalar(255));
    cv::fillConvexPoly(image, quad, cv::mean(image, rim));
}

Result<PicturePlane> planeOfMarker(cv::Mat& image, const ReferenceMarker& reference, const std::string& path,
                                   std::vector<Message>& warnings) {
    constexpr double kMinSide_px = 40.0;
    const Error notFound{MessageCode::MarkerNotFound, path, {reference.dictionary}};
    const GreyPicture grey = greyPicture(image);
    const std::vector<FoundMarker> markers = findMarkers(grey, {reference.dictionary});
    if (markers.empty())
        return isCrowded(grey) ? Error{MessageCode::MarkersCrowded, path} : notFound;
    const auto plane = PicturePlane::ofSquare(markers.front().corners_px, reference.side_m);
    if (!plane)
        return notFound;
    for (const FoundMarker& marker : markers)
        paintOver(image, marker);
    if (markers.size() > 1)
        warnings.push_back({MessageCode::MarkersSeveral,
                            {std::to_string(markers.size()), std::to_string(markers.front().id)}});
    if (const double side_px = markers.front().side_px(); side_px < kMinSide_px)
        warnings.push_back(
            {MessageCode::MarkerTooSmall, {formatNumber(side_px, 3), formatNumber(kMinSide_px)}});
    return *plane;
}

// The scale in pixels per mm that is typed, or told by a known length; nothing when a marker tells it.
Result<std::optional<double>> scaleOf(const ContourImportOptions& options, const std::string& path) {
    const int given = static_cast<int>(options.scale_px_per_mm.has_value()) +
                      static_cast<int>(options.knownLength.has_value()) +
                      static_cast<int>(options.marker.has_value());
    if (given != 1)
        return Error{given == 0 ? MessageCode::ScaleMissing : MessageCode::ScaleTwice, path};
    if (options.marker) {
        if (!isMarkerDictionary(options.marker->dictionary))
            return Error{MessageCode::ValueUnknown, path, {options.marker->dictionary, markerDictionaries()}};
        if (!(options.marker->side_m > 0.0) || !std::isfinite(options.marker->side_m))
            return Error{MessageCode::ValueNotPositive, path, {formatNumber(options.marker->side_m)}};
        return std::optional<double>();
    }
    double scale = options.scale_px_per_mm.value_or(0.0);
    if (const auto& known = options.knownLength)
        scale = (known->to_px - known->from_px).norm() / (known->length_m * 1e3);
    if (!(scale > 0.0) || !std::isfinite(scale))
        return Error{MessageCode::ScaleNotPositive, path, {formatNumber(scale)}};
    return std::optional(scale);
}

Result<FileOutline> outlineOf(const std::vector<Eigen::Vector2d>& ring_px, const PicturePlane& plane,
                              double uncertainty_px, const std::string& path) {
    constexpr double kThinning_m = 1e-5;
    // A perspective keeps lines straight, so points that the picture does not need are left out in it.
    const auto ring = makeContour(ring_px, path);
    if (!ring)
        return ring.error();
    FileOutline outline;
    for (const Eigen::Vector2d& p :
         simplified(*ring, std::max(uncertainty_px, kThinning_m / plane.pixel_m())).points_m) {
        const auto point_m = plane.toMetres(p);
        if (!point_m)
            return Error{MessageCode::BeyondHorizon, path};
        outline.points_m.push_back(*point_m);
    }
    std::ranges::reverse(outline.points_m); // y points up now
    return outline;
}

Result<OutlineFile> outlinesOf(cv::Mat& image, const std::optional<double>& scale,
                               const ContourImportOptions& options, const std::string& path) {
    OutlineFile file;
    file.unit = "px";
    const auto plane = scale ? Result<PicturePlane>(PicturePlane::scaled(*scale, image.rows))
                             : planeOfMarker(image, *options.marker, path, file.warnings);
    if (!plane)
        return plane.error();
    file.plane = *plane;
    auto field = fieldOf(image, options.colour);
    image.release();
    if (!field)
        return Error{options.colour ? MessageCode::ColourUnclear : MessageCode::NoSilhouette, path};
    const auto silhouettes =
        traceSilhouettes(signedField(field->values, field->contrast), options.leaveOutBorder, path);
    if (!silhouettes)
        return silhouettes.error();
    if (silhouettes->atBorder > 0)
        file.warnings.push_back({MessageCode::SilhouettesAtBorder, {std::to_string(silhouettes->atBorder)}});
    for (const auto& ring_px : silhouettes->rings_px) {
        auto outline = outlineOf(ring_px, *plane, silhouettes->uncertainty_px, path);
        if (!outline)
            return outline.error();
        file.outlines.push_back(std::move(*outline));
    }
    return file;
}

ColourPicture picture(const cv::Mat& image) {
    cv::Mat shown;
    image.convertTo(shown, CV_8U, image.depth() == CV_16U ? 255.0 / 65535.0 : 1.0);
    cv::Mat3b rgb;
    if (shown.channels() < 3) {
        cv::extractChannel(shown, shown, 0);
        cv::cvtColor(shown, rgb, cv::COLOR_GRAY2RGB);
    } else {
        cv::cvtColor(shown, rgb, shown.channels() == 4 ? cv::COLOR_BGRA2RGB : cv::COLOR_BGR2RGB);
    }
    if (hasAlpha(image)) {
        for (int y = 0; y < rgb.rows;
             ++y) { // row by row: opacity as floats would take four times the picture
            const cv::Mat1f opacity = channel(image.row(y), image.channels() - 1);
            for (int x = 0; x < rgb.cols; ++x)
                rgb(y, x) =
                    cv::Vec3f::all(255.0F * (1.0F - opacity(0, x))) + opacity(0, x) * cv::Vec3f(rgb(y, x));
        }
    }
    return {rgb.cols, rgb.rows, bytesOf(rgb.reshape(1))};
}

// What a picture gives, with what OpenCV and allocation throw as an Error.
template <class Value, class Use> Result<Value> ofPicture(const std::string& path, Use use) {
    const auto bytes = readFileBytes(path, kLargestPicture);
    if (!bytes)
        return bytes.error();
    try {
        auto image = decoded(*bytes, path);
        if (!image)
            return image.error();
        return use(*image);
    } catch (const std::exception&) {
        return Error{MessageCode::ImageUnreadable, path};
    }
}

} // namespace

Result<ColourPicture> readPicture(const std::string& path) {
    return ofPicture<ColourPicture>(path, [](const cv::Mat& image) { return picture(image); });
}

Result<GreyPicture> readGreyPicture(const std::string& path) {
    return ofPicture<GreyPicture>(path, [](const cv::Mat& image) { return greyPicture(image); });
}

Result<OutlineFile> readImageOutlines(const std::string& path, const ContourImportOptions& options) {
    const auto scale = scaleOf(options, path);
    if (!scale)
        return scale.error();
    return ofPicture<OutlineFile>(path,
                                  [&](cv::Mat& image) { return outlinesOf(image, *scale, options, path); });
}

} // namespace bask
