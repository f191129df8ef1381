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

void detect(const cv::Mat1b& image, int dictionary, Quads& quads, std::vector<int>& ids) {
#if BASK_ARUCO_IN_OBJDETECT
    const cv::aruco::ArucoDetector detector(cv::aruco::getPredefinedDictionary(dictionary));
    detector.detectMarkers(image, quads, ids);
#else
    cv::aruco::detectMarkers(image, cv::aruco::getPredefinedDictionary(dictionary), quads, ids);
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
    constexpr double kStep_px = 0.25, kLeastContrast = 20.0;
    const Eigen::Vector2d ends[] = {middle - reach * across, middle + reach * across};
    for (const Eigen::Vector2d& p : ends)
        if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() < image.cols - 1 && p.y() < image.rows - 1))
            return std::nullopt;
    const double black = brightnessAt(image, ends[0]), white = brightnessAt(image, ends[1]);
    if (white - black < kLeastContrast)
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
        constexpr double kMostMove_px = 4.0;
        if (!((corners[k] - found[k]).norm() < kMostMove_px))
            return found;
    }
    return corners;
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

std::vector<FoundMarker> findMarkers(const GreyPicture& picture, const std::string& dictionary) {
    const cv::Mat1b image(picture.height, picture.width, const_cast<std::uint8_t*>(picture.values.data()));
    Quads quads;
    std::vector<int> ids;
    detect(image, dictionaries().at(plainName(dictionary)), quads, ids);
    std::vector<FoundMarker> markers;
    for (std::size_t k = 0; k < quads.size(); ++k) {
        FoundMarker marker{ids[k], {}};
        for (std::size_t c = 0; c < 4; ++c)
            marker.corners_px[c] = {quads[k].at(c).x, quads[k].at(c).y};
        marker.corners_px = refined(image, refined(image, marker.corners_px));
        markers.push_back(marker);
    }
    std::ranges::sort(markers, std::greater{}, &FoundMarker::side_px);
    return markers;
}

} // namespace bask
