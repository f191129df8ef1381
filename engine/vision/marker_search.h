#pragma once
// Searches a part's markers in a picture, near their expected positions or everywhere.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"
#include "engine/calibration/pose_covariance.h"

#include <optional>
#include <vector>

namespace bask {

/// A rectangle in pixels.
struct PictureRegion {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Where a part's markers are expected.
struct ExpectedMarkers {
    int count = 0;
    /// One region around each marker; overlapping ones are merged, so that no marker is found twice.
    std::vector<PictureRegion> regions;
};

/// Returns the regions for a part at `X_CP` with uncertainty `covariance`; each includes the marker's light
/// margin and three standard deviations.
ExpectedMarkers expectedMarkers(const MarkerLayout& layout, Part part, const CameraModel& camera,
                                const Pose& X_CP, const Matrix6d& covariance);

/// Returns all markers of the dictionary that are completely inside one of the regions. None for a picture
/// that is empty or smaller than its stated size.
std::vector<FoundMarker> findMarkersIn(const GreyPicture& picture, const std::vector<PictureRegion>& regions,
                                       const MarkerDictionary& dictionary);

/// Returns the whole picture as a region.
PictureRegion wholeOf(const GreyPicture& picture);
double pixelsIn(const std::vector<PictureRegion>& regions);

/// Decides when to search the whole picture, which takes several times as long as a search near the last
/// place: at once if nothing is known, later from time to time.
class SearchSchedule {
public:
    static constexpr double kLost_s = 0.1;  ///< between searches of the whole picture while nothing is seen
    static constexpr double kFewer_s = 1.0; ///< and while fewer markers than expected are seen
    static constexpr int kFewerFrames = 5;  ///< number of such frames before the first full search

    /// Takes the result of a search near the last place at `time_s`; returns whether to search the whole
    /// picture now.
    bool wantsAll(double time_s, int expected, int seen);

private:
    double m_last_s = -1e300;
    int m_fewer = 0;
};

} // namespace bask
