#pragma once
// What an experiment knows of its camera and markers: calibrations and when they were made.

#include "engine/base/result.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"

#include <optional>
#include <string>
#include <vector>

namespace bask {

/// A marker on a part of the rig; side as measured on the print, with the black border.
struct MarkerSpec {
    Part part = Part::Source;
    int id = 0;
    double side_m = 0.05;
    Vector6d pose = Vector6d::Zero(); ///< coordinates of the marker in its part (S, E or R)
    bool operator==(const MarkerSpec&) const = default;
};

/// Dates are ISO 8601 in UTC, "2026-11-21T22:45:00Z"; empty: unknown.
struct VisionSpec {
    std::string dictionary = "4X4_50"; ///< known by name
    std::vector<MarkerSpec> markers;
    std::optional<CameraModel> camera; ///< as calibrated; its size is known
    std::string cameraDate;
    std::optional<Vector6d> cameraPose; ///< coordinates of X_RC, as calibrated
    std::string cameraPoseDate;
    std::string sourcePoseDate; ///< when source.pose was measured by the camera

    bool marks(Part part) const; ///< a marker sits on it
    /// Enough to follow the source: markers on it, a camera, and where it stands.
    bool followsSource() const;
    bool operator==(const VisionSpec&) const = default;
};

/// The rig's true camera, where the rig is simulated.
struct SimulatedCameraSpec {
    std::optional<CameraModel> model; ///< empty: the usual one of a simulated rig
    std::optional<Vector6d> pose;     ///< coordinates of X_RC; empty: the usual place
    double rate_Hz = 30.0;
    double noise_grey = 2.0; ///< standard deviation of a pixel, of 255
    double blur_px = 0.7;    ///< standard deviation of the lens's spot
    double lightFall = 0.3;  ///< how much darker the darker side is, 0..1
    double delay_s = 0.03;   ///< from the light caught to the picture handed out
    bool operator==(const SimulatedCameraSpec&) const = default;
};

MarkerLayout markerLayout(const VisionSpec& vision);

} // namespace bask
