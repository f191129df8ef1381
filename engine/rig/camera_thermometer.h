#pragma once
// A thermal camera as the rig's thermometer: what it tells of each object, with the reflection of the source
// computed for the pose at which the frame was taken.

#include "engine/base/clock.h"
#include "engine/control/rig_geometry.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermal_camera.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/model/trace.h"
#include "engine/model/trace_sample.h"
#include "engine/rig/face_reflections.h"
#include "engine/thermography/face_thermometer.h"
#include "engine/thermography/thermal_view.h"

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// What the thermometer knows of the rig; emittances are those of the camera's band.
struct CameraThermometerSetup {
    CameraModel camera;
    std::optional<Pose> X_RC; ///< without it the camera shows pictures and reads nothing
    SightUncertainty sight;   ///< by that of X_RC
    std::vector<ObjectSpec> objects;
    std::vector<PlateSpec> fixtures, shields;
    Shape source;                                ///< at the geometry's X_RS, unless it is tracked
    std::shared_ptr<const RigGeometry> geometry; ///< of these objects
    ReflectingRig reflecting;                    ///< the same objects
    double environment_K = 298.15;
    /// The source is behind a shutter: with the heat off the objects see the room instead.
    bool hasShutter = false;
    /// The source is where setSource() says; before that what a face reflects of it is not known.
    bool isSourceTracked = false;
};

/// Frames before any heat, with a cold source, have to show the objects as cold as the room: the first zeroes
/// the camera on an object, the later ones make that better. Until then, while an object cannot be read,
/// while the last frame is old, and while the robot does not know its place, its reading is invalid and says
/// why. The pose at a frame's time is between those of two readings, on a line. Neighbours are as warm as the
/// camera read them last, or as their sensors say; where objects see one another, what a frame tells is put
/// in once more. That is enough: an error of a neighbour's temperature comes back times its emittance, its
/// view factor and (1 - eps) / eps of the face, less than a tenth in all where eps is 0.8 or more, and
/// between two frames temperatures change by a kelvin or two. Use it on the engine thread.
class CameraThermometer final : public Thermometer {
public:
    /// What is kept where the rig stays and the experiment changes.
    struct Memory {
        CameraModel camera; ///< with which it was zeroed
        std::optional<Pose> X_RC;
        std::map<std::string, CameraZero> zeros; ///< by the objects' names
        double hot_s = -1e300;                   ///< when the source was not cold last
        double board_s = -1e300;                 ///< when a board was shown last
    };

    /// The devices and `clock`, which is theirs, must outlive it.
    CameraThermometer(CameraThermometerSetup setup, ThermalCamera& camera, Robot& robot, HeatSource& source,
                      const Clock& clock);

    int channels() const override { return static_cast<int>(m_setup.objects.size()); }
    /// Errors: those of the camera.
    Result<std::vector<Reading>> read() override;

    /// Returns what the last frame told of an object besides its reading; NaN if it could not be read.
    const CameraSample& sample(std::size_t object) const { return m_seen.at(object).sample; }
    /// Returns the emittance with which the last frame tells `T_K` for an object; NaN if it could not be
    /// read, or no emittance does.
    double explainingEmittance(std::size_t object, double T_K) const;
    /// Returns the temperature of the black body as bright as what the object's face reflects, K; NaN if it
    /// could not be read.
    double reflected_K(std::size_t object) const;
    /// Returns when the camera's shutter was last seen to open, on the engine's clock; empty: never.
    std::optional<double> shutter_s() const { return m_frame ? m_frame->shutter_s : std::nullopt; }
    /// Returns the last frame, with the time when it was taken; without a picture before the first.
    TraceFrame frame() const;
    /// Reads a frame that is new, and returns what the window shows of it: as often as it wants pictures.
    std::shared_ptr<const ThermalView> view();
    /// Returns why an object could not be read; code None if it could.
    const Message& reason(std::size_t object) const { return m_seen.at(object).reading.reason; }

    /// While a calibration board is held before the camera, and for some seconds after, nothing is read: its
    /// pixels lie where the objects are.
    void setBoardShown(bool isShown);
    /// Sets where a tracked source is now; empty: nobody knows.
    void setSource(const std::optional<Pose>& X_RS) { m_X_RS = X_RS; }
    /// Sets what the sensors on the objects say now, one reading for each object.
    void setSensors(std::vector<Reading> readings) { m_sensors = std::move(readings); }
    /// Sets the temperature of the room, as other thermometers tell it while everything is cold.
    void setRoom(double environment_K);
    /// Whether frames may be used for zeroing: the source is cold, and has been for some minutes.
    bool isCold() const;

    Memory memory() const;
    /// Zeros of a camera elsewhere, or with another lens, are of other pixels, and the objects may have been
    /// warmed to find it: it is zeroed anew when all has been cold for some minutes.
    void use(const Memory& before);

    static constexpr double kOldFrame_s = 1.5; ///< a closed shutter, and the way of a frame, take less

private:
    /// What the rig's other devices told when the thermometer was read.
    struct Moment {
        double time_s;
        Vector6d q;
        bool isPlaceSure;
        std::optional<KnownTemperature> source; ///< what the objects see; empty: unknown
        std::optional<Pose> X_RS;               ///< empty: unknown
    };
    /// An object in the last frame.
    struct Seen {
        Reading reading;
        CameraSample sample;
        std::vector<int> pixels;
        bool isPartlyOutside = false;
        FaceSurroundings face; ///< as the camera sees it, if it could be read
        double apparent_K = 0.0;
    };
    /// What the camera told of an object, and when.
    struct Told {
        double time_s;
        KnownTemperature known;
    };
    std::optional<KnownTemperature> seenSource() const;
    KnownTemperature temperatureOf(std::size_t object) const;
    void noteMoment();
    void invalidate(const Message& reason);
    Vector6d placeAt(double time_s) const;
    std::optional<Pose> sourceAt(double time_s) const;
    const Moment& nearest(double time_s) const;
    std::vector<ReadObject> objectsAt(const Vector6d& q, const Moment& then);
    std::vector<PlacedPlate> screensAt(const Vector6d& q, const Moment& then) const;
    double sinceShutter_s() const;
    void readFrame();
    bool findZeros(const std::vector<ReadObject>& objects, const std::vector<Result<ObjectReading>>& read);
    void take(std::size_t object, const Moment& then, const ReadObject& known, Result<ObjectReading> reading);
    ThermalView viewOfFrame() const;

    CameraThermometerSetup m_setup;
    ThermalCamera& m_camera;
    Robot& m_robot;
    HeatSource& m_source;
    PixelRays m_rays;
    const Clock& m_clock;
    std::shared_ptr<const BandRadiance> m_band; ///< of the camera
    FaceReflections m_reflections;
    std::optional<Pose> m_X_RS; ///< of the source now
    std::vector<Reading> m_sensors;
    std::vector<std::optional<Told>> m_told; ///< last, of each object
    std::deque<Moment> m_moments;
    std::shared_ptr<const ThermalCameraFrame> m_frame; ///< the last one; null before the first
    bool m_isSourceCold = false;                       ///< known to be
    double m_hot_s = -1e300;                           ///< when the source was not cold last
    bool m_isBoardShown = false;
    double m_board_s = -1e300; ///< when it was shown last
    std::vector<std::optional<CameraZero>> m_zeros;
    std::vector<int> m_zeroFrames; ///< that went into a zero
    std::vector<Seen> m_seen;
    std::optional<ThermalView> m_view; ///< of the last frame, once it was asked for
};

} // namespace bask
