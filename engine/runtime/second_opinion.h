#pragma once
// A thermal camera's second opinion about the sensors on the objects: whether they agree, and if not, why.

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace bask {

/// One object at one time, as both see it.
struct CameraOpinion {
    double contact_K = std::numeric_limits<double>::quiet_NaN(); ///< NaN: the sensor gives no value
    double contact_s = 0.0;                                      ///< time of its reading
    double camera_K = 0.0;
    double uncertainty_K = 0.0; ///< standard uncertainty of camera_K
    double reflected_K = 0.0;   ///< black body as bright as what the face reflects
    /// Of the face, with which the camera would tell contact_K; NaN: none.
    double emittance = std::numeric_limits<double>::quiet_NaN();
};

enum class OpinionVerdict {
    SensorOff,      ///< the sensor has come off its object, which is hotter
    NeverOn,        ///< it does not measure its object, which is hotter, nor did it before
    Swapped,        ///< it is on another object, whose sensor is on this one
    EmittanceOther, ///< both agree with another emittance
    CameraDiffers   ///< the camera sees something colder than the sensor says
};

struct OpinionFinding {
    OpinionVerdict verdict = OpinionVerdict::NeverOn;
    CameraOpinion seen;
    std::size_t other = 0; ///< object of the other swapped sensor
    CameraOpinion seenOther{};
    double agreedAgo_s = 0.0; ///< of SensorOff
};

/// Both are made equal while the object is as cold as what its face reflects. A sensor may lag behind its
/// object: it has to read what the camera saw of the object lately, within four
/// standard uncertainties. A wrong emittance makes an error in proportion to the distance from the
/// temperature of what the face reflects, so that one emittance explains all readings; no emittance explains
/// a sensor that comes off. Findings about a sensor stand until both agree again where a wrong one would not,
/// or a person confirms the sensor.
class SecondOpinion {
public:
    SecondOpinion(std::size_t objects, double period_s);

    /// Takes what is seen at a time; empty for an object that the camera cannot read.
    void add(double now_s, const std::vector<std::optional<CameraOpinion>>& seen);
    /// Returns what is found about an object; of two swapped sensors the first object has the finding.
    const std::optional<OpinionFinding>& finding(std::size_t object) const {
        return m_objects.at(object).finding;
    }
    /// A person says that the sensor is right: nothing is found until both have agreed again.
    void confirm(std::size_t object);
    /// The sensors were zeroed: what they differ by from the camera is found anew.
    void atRest();

private:
    struct Emittance {
        double value = 0.0;
        double tolerance = std::numeric_limits<double>::infinity();
    };
    struct Watch {
        std::deque<std::pair<double, double>> camera; ///< times and temperatures lately
        std::optional<CameraOpinion> seen;            ///< newest with both, the sensor made equal when cold
        double told_K = 0.0;                          ///< by the sensor itself
        double coldOffset_K = 0.0;                    ///< of the sensor, while both were cold
        int coldReadings = 0;
        double agreed_s = -std::numeric_limits<double>::infinity();
        double differs_s = 0.0; ///< since when
        int differing = 0;      ///< readings in a row
        bool isConfirmed = false;
        double seen_s = -std::numeric_limits<double>::infinity(); ///< when both told something last
        double contact_s = -std::numeric_limits<double>::infinity();
        Emittance before; ///< the best known of when they agreed
        Emittance now;
        /// Emittances that explain all readings since they differ.
        double minEmittance = 0.0, maxEmittance = 0.0;
        std::optional<OpinionFinding> finding{};
    };
    static Emittance emittanceOf(const CameraOpinion& seen);
    /// Whether a reading is what the camera saw of the object lately.
    static bool isWithin(const Watch& watch, double contact_K, double tolerance_K);
    static bool isAgreedWarm(const Watch& watch);
    static bool isExplained(const Watch& watch);
    void take(Watch& watch, double now_s, const CameraOpinion& seen) const;
    static CameraOpinion asTold(const Watch& watch);
    bool isStanding(const Watch& watch) const;
    bool isOtherOfSwapped(std::size_t object) const;
    void judge(std::size_t object, double now_s);
    std::optional<std::size_t> swappedWith(std::size_t object) const;

    std::vector<Watch> m_objects;
    double m_lately_s;
};

} // namespace bask
