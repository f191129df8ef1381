#pragma once
// What the window shows of a thermal camera: a picture and what was read from it. Contains values, never the
// camera.

#include "engine/base/left_out_pictures.h"
#include "engine/base/message.h"
#include "engine/thermography/camera_profile.h"
#include "engine/thermography/thermal_picture.h"

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// One object in a picture.
struct ThermalObjectView {
    /// Its outline as the lens shows it, closed, px; partly outside of the picture or empty if it is not
    /// seen.
    std::vector<Eigen::Vector2d> outline_px;
    std::vector<int> pixels;    ///< those that were read, ascending, row by row
    std::optional<double> T_K;  ///< empty: it could not be read
    double uncertainty_K = 0.0; ///< standard uncertainty of T_K
    double spread_K = std::numeric_limits<double>::quiet_NaN(); ///< across its face; NaN: not known
    Message reason;               ///< why it could not be read; code None if it could
    bool isPartlyOutside = false; ///< of what was read: a part of it is not in the picture
};

/// Returns what stands in a profile's title before the first comma; without a title, its name.
inline std::string cameraName(const ThermalProfile& profile) {
    return profile.title.empty() ? profile.name : profile.title.substr(0, profile.title.find(','));
}

/// The result for one picture.
struct ThermalView {
    std::string cameraName;                        ///< as cameraName()
    std::shared_ptr<const ThermalPicture> picture; ///< null before the first
    double time_s = 0.0;                           ///< when it was taken, on the engine's clock
    double age_s = 0.0;                            ///< when the view was made
    Message problem;                               ///< such as CameraLost; code None if the camera answers
    LeftOutPictures leftOut;                       ///< so far
    std::optional<double> sinceShutter_s{};        ///< until the picture, if its shutter was seen
    double drift_K = 0.0;                   ///< standard uncertainty of every reading by the drift since
    std::vector<ThermalObjectView> objects; ///< in the experiment's order
};

} // namespace bask
