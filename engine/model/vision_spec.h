#pragma once
// The camera and markers of an experiment: calibrations and their dates.

#include "engine/base/result.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// A marker on a part of the rig; its side is measured on the print, with the black border.
struct MarkerSpec {
    Part part = Part::Source;
    int id = 0;
    double side_m = 0.05;
    Vector6d pose = Vector6d::Zero(); ///< coordinates of the marker in its part (S, E or R)
    bool operator==(const MarkerSpec&) const = default;
};

/// Dates are ISO 8601 in UTC, "2026-11-21T22:45:00Z"; empty: unknown.
struct VisionSpec {
    std::string dictionary = "4X4_50"; ///< name of a known dictionary
    std::vector<MarkerSpec> markers;
    std::optional<CameraModel> camera; ///< the calibrated camera; its size is known
    std::string cameraDate;
    std::optional<Vector6d> cameraPose; ///< calibrated coordinates of X_RC
    std::string cameraPoseDate;
    std::string sourcePoseDate; ///< date of the last measurement of source.pose by the camera

    bool marks(Part part) const; ///< whether this part has a marker
    /// Returns whether the source can be tracked: it has markers, and there is a camera with a known pose.
    bool followsSource() const;
    bool operator==(const VisionSpec&) const = default;
};

/// The true camera of a simulated rig.
struct SimulatedCameraSpec {
    std::optional<CameraModel> model; ///< if empty, the default camera of a simulated rig
    std::optional<Vector6d> pose;     ///< coordinates of X_RC; if empty, the default pose
    double rate_Hz = 30.0;
    double noise_grey = 2.0; ///< standard deviation of a pixel, of 255
    double blur_px = 0.7;    ///< standard deviation of the lens's spot
    double lightFall = 0.3;  ///< how much darker the darker side of the picture is, 0..1
    double delay_s = 0.03;   ///< from the exposure to the delivered picture
    bool operator==(const SimulatedCameraSpec&) const = default;
};

MarkerLayout markerLayout(const VisionSpec& vision);

} // namespace bask
