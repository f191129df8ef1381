#include "engine/shape/marker.h"

#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>
// Before 4.7 markers are in the contributed module, with functions; since then in objdetect, with a class.
#define BASK_ARUCO_IN_OBJDETECT (CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7))
#if BASK_ARUCO_IN_OBJDETECT
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace bask {
namespace {

const std::map<std::string, int>& dictionaries() {
    static const std::map<std::string, int> kNames{{"4X4_50", cv::aruco::DICT_4X4_50},
                                                   {"4X4_100", cv::aruco::DICT_4X4_100},
                                                   {"4X4_250", cv::aruco::DICT_4X4_250},
                                                   {"4X4_1000", cv::aruco::DICT_4X4_1000},
                                                   {"5X5_50", cv::aruco::DICT_5X5_50},
                                                   {"5X5_100", cv::aruco::DICT_5X5_100},
                                                   {"5X5_250", cv::aruco::DICT_5X5_250},
                                                   {"5X5_1000", cv::aruco::DICT_5X5_1000},
                                                   {"6X6_50", cv::aruco::DICT_6X6_50},
                                                   {"6X6_100", cv::aruco::DICT_6X6_100},
                                                   {"6X6_250", cv::aruco::DICT_6X6_250},
                                                   {"6X6_1000", cv::aruco::DICT_6X6_1000},
                                                   {"7X7_50", cv::aruco::DICT_7X7_50},
                                                   {"7X7_100", cv::aruco::DICT_7X7_100},
                                                   {"7X7_250", cv::aruco::DICT_7X7_250},
                                                   {"7X7_1000", cv::aruco::DICT_7X7_1000},
                                                   {"ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL}};
    return kNames;
}

std::string plainName(std::string name) {
    for (char& c : name)
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    return name.starts_with("DICT_") ? name.substr(5) : name;
}

using Quads = std::vector<std::vector<cv::Point2f>>;

cv::aruco::Dictionary known(const std::string& name) {
    const int number = dictionaries().at(plainName(name));
#if BASK_ARUCO_IN_OBJDETECT
    return cv::aruco::getPredefinedDictionary(number);
#else
    return *cv::aruco::getPredefinedDictionary(number);
#endif
}

cv::aruco::Dictionary library(const MarkerDictionary& dictionary) {
    if (dictionary.side_bits == 0)
        return known(dictionary.name);
    cv::Mat bytes;
    for (const std::string& text : dictionary.bits) {
        cv::Mat1b bits(dictionary.side_bits, dictionary.side_bits);
        std::ranges::transform(text, bits.begin(),
                               [](char c) { return static_cast<std::uint8_t>(c == '1'); });
        bytes.push_back(cv::aruco::Dictionary::getByteListFromBits(bits));
    }
    return {bytes, dictionary.side_bits, dictionary.correctableBits};
}

void detect(const cv::Mat1b& image, const cv::aruco::Dictionary& dictionary, Quads& quads,
            std::vector<int>& ids) {
#if BASK_ARUCO_IN_OBJDETECT
    cv::aruco::ArucoDetector(dictionary).detectMarkers(image, quads, ids);
#else
    cv::aruco::detectMarkers(image, cv::makePtr<cv::aruco::Dictionary>(dictionary), quads, ids);
#endif
}

double brightnessAt(const cv::Mat1b& image, const Eigen::Vector2d& p) {
    const int x = static_cast<int>(std::floor(p.x())), y = static_cast<int>(std::floor(p.y()));
    const double u = p.x() - x, v = p.y() - y;
    return (1 - v) * ((1 - u) * image(y, x) + u * image(y, x + 1)) +
           v * ((1 - u) * image(y + 1, x) + u * image(y + 1, x + 1));
}

/// A line n . p = offset.
struct Line {
    Eigen::Vector2d normal = Eigen::Vector2d::Zero();
    double offset = 0.0;
};

// Where the brightness along `across` (unit, from black to white) passes halfway from its least to its most,
// in pixels from `middle`; nothing at the picture's border and where there is no such place.
std::optional<double> halfway(const cv::Mat1b& image, const Eigen::Vector2d& middle,
                              const Eigen::Vector2d& across, double reach) {
    constexpr double kStep_px = 0.25, kMinContrast = 20.0;
    const Eigen::Vector2d ends[] = {middle - reach * across, middle + reach * across};
    for (const Eigen::Vector2d& p : ends)
        if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() < image.cols - 1 && p.y() < image.rows - 1))
            return std::nullopt;
    const double black = brightnessAt(image, ends[0]), white = brightnessAt(image, ends[1]);
    if (white - black < kMinContrast)
        return std::nullopt;
    const double half = 0.5 * (black + white);
    double before = black;
    for (double t = -reach + kStep_px; t <= reach; t += kStep_px) {
        const double now = brightnessAt(image, middle + t * across);
        if (now >= half)
            return t - kStep_px * (now - half) / (now - before);
        before = now;
    }
    return std::nullopt;
}

// Least-squares line through the edge between two corners as they were found; the side's ends are left out,
// where the corner rounds the edge, and a tenth of the places that lie farthest off.
std::optional<Line> edgeLine(const cv::Mat1b& image, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const double length = (to - from).norm();
    const Eigen::Vector2d along = (to - from) / length;
    const Eigen::Vector2d across(along.y(), -along.x());      // outwards of a clockwise square, y down
    const double reach = std::clamp(0.06 * length, 1.5, 4.0); // a third of the black border's width or less
    std::vector<Eigen::Vector2d> places;                      // along, across
    for (double s = 0.08 * length; s <= 0.92 * length; s += 0.5)
        if (const auto t = halfway(image, from + s * along, across, reach))
            places.emplace_back(s, *t);
    double slope = 0.0, at = 0.0;
    for (int pass = 0; pass < 2; ++pass) {
        if (places.size() < 8)
            return std::nullopt;
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const Eigen::Vector2d& p : places)
            mean += p / static_cast<double>(places.size());
        double ss = 0.0, st = 0.0;
        for (const Eigen::Vector2d& p : places) {
            ss += (p.x() - mean.x()) * (p.x() - mean.x());
            st += (p.x() - mean.x()) * (p.y() - mean.y());
        }
        slope = st / ss;
        at = mean.y() - slope * mean.x();
        std::ranges::sort(places, {},
                          [&](const Eigen::Vector2d& p) { return std::abs(p.y() - at - slope * p.x()); });
        places.resize(places.size() - places.size() / 10);
    }
    Line line;
    line.normal = (across - slope * along).normalized();
    line.offset = line.normal.dot(from + at * across);
    return line;
}

std::array<Eigen::Vector2d, 4> refined(const cv::Mat1b& image, const std::array<Eigen::Vector2d, 4>& found) {
    std::array<Line, 4> lines;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto line = edgeLine(image, found[k], found[(k + 1) % 4]);
        if (!line)
            return found;
        lines[k] = *line;
    }
    std::array<Eigen::Vector2d, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) {
        const Line &a = lines[(k + 3) % 4], &b = lines[k];
        const double d = a.normal.x() * b.normal.y() - a.normal.y() * b.normal.x();
        corners[k] = Eigen::Vector2d(a.offset * b.normal.y() - b.offset * a.normal.y(),
                                     b.offset * a.normal.x() - a.offset * b.normal.x()) /
                     d;
        constexpr double kMaxMove_px = 4.0;
        if (!((corners[k] - found[k]).norm() < kMaxMove_px))
            return found;
    }
    return corners;
}

// The corners refined, but no farther from where they were detected than the detection of so small a marker
// may be off: on a side of few pixels a neighbour or a shadow draws the line away.
std::array<Eigen::Vector2d, 4> nearDetected(const FoundMarker& detected,
                                            std::array<Eigen::Vector2d, 4> corners) {
    const double max_px = std::max(0.9, 0.02 * detected.side_px());
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector2d move = corners[k] - detected.corners_px[k];
        if (move.norm() > max_px)
            corners[k] = detected.corners_px[k] + max_px * move.normalized();
    }
    return corners;
}

cv::Mat1b imageOf(const GreyPicture& picture) {
    return {picture.height, picture.width, const_cast<std::uint8_t*>(picture.values.data())};
}

// Whether a picture changes from nearly each pixel to the next, as a chessboard of two pixels a square does.
bool isTooFine(const cv::Mat1b& image) {
    constexpr double kStep = 40.0, kMaxShare = 0.25;
    cv::Mat1b steps;
    cv::absdiff(image.colRange(1, image.cols), image.colRange(0, image.cols - 1), steps);
    return cv::countNonZero(steps > kStep) > kMaxShare * static_cast<double>(image.total());
}

// Counts quadrangles that are as large as the detector takes, in a picture that is made small enough to be
// quick beside the detection.
bool hasManyQuads(const cv::Mat1b& image) {
    constexpr double kLooked_px = 1000.0, kMaxQuads = 1000.0;
    constexpr double kMinPerimeter = 0.02, kAccuracy = 0.05; // of the picture's length, of the perimeter
    constexpr int kWindow_px = 13, kDarker = 7;              // of the detector's middle threshold
    const double length = std::max(image.cols, image.rows), times = std::min(1.0, kLooked_px / length);
    if (std::min(image.cols, image.rows) * times < kWindow_px)
        return false; // there is no place for so many, and OpenCV throws on pictures of no pixel
    cv::Mat1b small = image, dark;
    if (times < 1.0)
        cv::resize(image, small, {}, times, times, cv::INTER_AREA);
    cv::adaptiveThreshold(small, dark, 255.0, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV, kWindow_px,
                          kDarker);
    std::vector<std::vector<cv::Point>> outlines;
    cv::findContours(dark, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
    if (static_cast<double>(outlines.size()) <= kMaxQuads)
        return false;
    const auto isQuad = [&](const std::vector<cv::Point>& outline) {
        if (static_cast<double>(outline.size()) < kMinPerimeter * length * times)
            return false;
        std::vector<cv::Point> corners;
        cv::approxPolyDP(outline, corners, kAccuracy * static_cast<double>(outline.size()), true);
        return corners.size() == 4 && cv::isContourConvex(corners);
    };
    return static_cast<double>(std::ranges::count_if(outlines, isQuad)) > kMaxQuads;
}

// The markers in the picture at so many times its size, in its own pixels. OpenCV's memory goes with what
// looks like a quadrangle: pictures are made smaller rather than take gigabytes.
std::vector<FoundMarker> found(const cv::Mat1b& image, const cv::aruco::Dictionary& dictionary,
                               double times) {
    constexpr double kMaxPixels = 16e6;
    std::vector<FoundMarker> markers;
    if (std::min(image.cols, image.rows) < dictionary.markerSize + 4) // OpenCV throws on such
        return markers;
    times = std::min(times, std::sqrt(kMaxPixels / static_cast<double>(image.total())));
    cv::Mat1b looked = image;
    const auto resize = [&] {
        cv::resize(image, looked, {}, times, times, times > 1.0 ? cv::INTER_CUBIC : cv::INTER_AREA);
    };
    if (times != 1.0)
        resize();
    while (isTooFine(looked) && std::min(looked.cols, looked.rows) / 2 >= dictionary.markerSize + 4) {
        times *= 0.5;
        resize();
    }
    Quads quads;
    std::vector<int> ids;
    detect(looked, dictionary, quads, ids);
    for (std::size_t k = 0; k < quads.size(); ++k) {
        FoundMarker marker{ids[k], {}};
        for (std::size_t c = 0; c < 4; ++c) {
            const Eigen::Vector2d corner(quads[k].at(c).x, quads[k].at(c).y);
            marker.corners_px[c] = ((corner.array() + 0.5) / times - 0.5).matrix();
        }
        marker.corners_px = nearDetected(marker, refined(image, refined(image, marker.corners_px)));
        markers.push_back(marker);
    }
    std::ranges::sort(markers, std::greater{}, &FoundMarker::side_px);
    return markers;
}

bool overlap(const FoundMarker& a, const FoundMarker& b) {
    const auto middle = [](const FoundMarker& m) {
        return Eigen::Vector2d(0.25 *
                               (m.corners_px[0] + m.corners_px[1] + m.corners_px[2] + m.corners_px[3]));
    };
    return (middle(a) - middle(b)).norm() < 0.5 * std::max(a.side_px(), b.side_px());
}

} // namespace

double FoundMarker::side_px() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
        sum += (corners_px[(k + 1) % 4] - corners_px[k]).norm();
    return 0.25 * sum;
}

bool isMarkerDictionary(const std::string& name) {
    return dictionaries().contains(plainName(name));
}

const std::string& markerDictionaries() {
    static const std::string kNames = [] {
        std::string names;
        for (const auto& [name, number] : dictionaries())
            names += (names.empty() ? "" : ", ") + name;
        return names;
    }();
    return kNames;
}

int markerCount(const MarkerDictionary& dictionary) {
    return dictionary.side_bits == 0 ? known(dictionary.name).bytesList.rows
                                     : static_cast<int>(dictionary.bits.size());
}

std::vector<std::string> markerCells(const MarkerDictionary& dictionary, int id) {
    const cv::aruco::Dictionary from = library(dictionary);
    const int side = from.markerSize + 2;
    cv::Mat1b cells;
#if BASK_ARUCO_IN_OBJDETECT
    from.generateImageMarker(id, side, cells);
#else
    from.drawMarker(id, side, cells);
#endif
    std::vector<std::string> rows(static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            rows[static_cast<std::size_t>(y)] += cells(y, x) > 127 ? '1' : '0';
    return rows;
}

bool isCrowded(const GreyPicture& picture) {
    const cv::Mat1b image = imageOf(picture);
    return std::min(image.cols, image.rows) > 1 && (isTooFine(image) || hasManyQuads(image));
}

std::vector<FoundMarker> findMarkers(const GreyPicture& picture, const MarkerDictionary& dictionary) {
    const cv::Mat1b image = imageOf(picture);
    if (hasManyQuads(image))
        return {};
    return found(image, library(dictionary), 1);
}

std::vector<FoundMarker> findSmallMarkersToo(const GreyPicture& picture, const MarkerDictionary& dictionary,
                                             const ShareDone& done) {
    constexpr int kMaxPixels = 4'000'000;
    constexpr double kLooked = 0.1, kOnce = 0.25; // of both searches, roughly
    const cv::Mat1b image = imageOf(picture);
    if (hasManyQuads(image))
        return {};
    tellShare(done, kLooked);
    const cv::aruco::Dictionary from = library(dictionary);
    std::vector<FoundMarker> markers = found(image, from, 1);
    tellShare(done, kOnce);
    if (picture.width > kMaxPixels / std::max(picture.height, 1))
        return markers;
    const auto isNew = [&, known = markers.size()](const FoundMarker& marker) {
        return std::ranges::none_of(markers.begin(), markers.begin() + static_cast<std::ptrdiff_t>(known),
                                    [&](const FoundMarker& other) { return overlap(marker, other); });
    };
    for (const FoundMarker& marker : found(image, from, 2))
        if (isNew(marker))
            markers.push_back(marker);
    std::ranges::sort(markers, std::greater{}, &FoundMarker::side_px);
    return markers;
}

} // namespace bask
