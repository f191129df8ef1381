#pragma once
// A part's markers in a picture, sought near where they should be or everywhere.

#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"
#include "engine/calibration/pose_covariance.h"

#include <optional>
#include <vector>

namespace bask {

/// Of pixels.
struct PictureRegion {
    int x = 0, y = 0, width = 0, height = 0;
};

/// Where a part's markers should be.
struct ExpectedMarkers {
    int count = 0;
    /// One about each marker, those that overlap as one, so that none is found twice.
    std::vector<PictureRegion> regions;
};

/// For a part at `X_CP`, as sure as `covariance`; with each marker its light margin and three deviations.
ExpectedMarkers expectedMarkers(const MarkerLayout& layout, Part part, const CameraModel& camera,
                                const Pose& X_CP, const Matrix6d& covariance);

/// All of the dictionary that are whole in one of the regions. Those of a picture that is empty or not as
/// large as it says: none.
std::vector<FoundMarker> findMarkersIn(const GreyPicture& picture, const std::vector<PictureRegion>& regions,
                                       const MarkerDictionary& dictionary);

/// The whole picture as a region.
PictureRegion wholeOf(const GreyPicture& picture);
double pixelsIn(const std::vector<PictureRegion>& regions);

/// When to look at the whole picture, which takes several times as long as looking near the last place: at
/// once when nothing is known, then from time to time.
class SearchSchedule {
public:
    static constexpr double kLost_s = 0.1;  ///< between looks at the whole while nothing is seen
    static constexpr double kFewer_s = 1.0; ///< and while fewer than expected are
    static constexpr int kFewerFrames = 5;  ///< that showed fewer, before the first such look

    /// What a search near the last place found at `time_s`; whether to look at the whole picture now.
    bool wantsAll(double time_s, int expected, int seen);

private:
    double m_last_s = -1e300;
    int m_fewer = 0;
};

} // namespace bask
