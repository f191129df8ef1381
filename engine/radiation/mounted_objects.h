#pragma once
// Objects on one end-effector: the view factor of each, with the shade of the others and of screens.

#include "engine/radiation/radiating_source.h"

#include <algorithm>
#include <vector>

namespace bask {

/// An object and its mounting on the end-effector.
struct MountedContour {
    RadiatingContour contour;
    Pose X_EO = Pose::Identity();
};

/// A plate that stands in the robot's base R.
struct StandingContour {
    RadiatingContour contour;
    Pose X_RB = Pose::Identity();
};

/// What shades the objects besides themselves: thin opaque plates, black and at the room's temperature, so
/// that they take light and exchange nothing else.
struct Screens {
    std::vector<MountedContour> fixtures; ///< held, on the end-effector
    std::vector<StandingContour> shields; ///< fixed in the room

    bool empty() const { return fixtures.empty() && shields.empty(); }
};

/// Returns the height (m) of the highest point of any shield over the plane of a source at X_RS, at least 0;
/// 0 without shields.
double shieldTop_m(const Screens& screens, const Pose& X_RS);

/// Error to which the shade is found, absolute, where less is not asked for.
inline constexpr double kShadeTolerance = 1e-5;

/// Shares below this are not worth a sentence.
inline constexpr double kMinToldShare = 0.005;

/// What one object, fixture or shield takes of the light of an object.
struct TakenLight {
    std::size_t object = 0;
    std::size_t taker = 0; ///< the objects come first, then the fixtures, then the shields
    double share = 0.0;    ///< of the object's view factor without shade, in (0, 1]
};

/// Knows which held plates may shade which object: where nothing of the others and of the fixtures lies in
/// front of an object's face, as with objects in one plane, and there are no shields, its view factor is
/// viewFactor's own, bit for bit. Shields are asked at every pose. Held plates that pass through one another
/// do not shade one another; nobody can build them. Thread-safe while the source stays.
class MountedObjects {
public:
    MountedObjects() = default;
    /// `X_RS`: the source's pose, on which depends where shields stand before it.
    explicit MountedObjects(std::vector<MountedContour> objects, Screens screens = {},
                            const Pose& X_RS = Pose::Identity());

    /// Moves the source: the shields stay where they are in R.
    void setSourceAt(const Pose& X_RS);

    /// Returns the same objects with their backs as heated faces, among the same screens.
    MountedObjects turnedOver(const Pose& X_RS) const;

    std::size_t size() const { return m_objects.size(); }
    bool empty() const { return m_objects.empty(); }
    const MountedContour& operator[](std::size_t i) const { return m_objects[i]; }
    const Screens& screens() const { return m_screens; }
    /// Returns the held plates of which a part lies in front of the face of object i: objects and, counted
    /// on from them, fixtures.
    const std::vector<std::size_t>& inFrontOf(std::size_t i) const { return m_inFront[i]; }

    /// Returns whether object i may be shaded at some pose.
    bool mayBeShaded(std::size_t i) const { return !m_inFront[i].empty() || !m_shields.empty(); }
    /// Returns whether any object may be.
    bool mayShade() const {
        return !m_shields.empty() || !std::ranges::all_of(m_inFront, &std::vector<std::size_t>::empty);
    }

    /// Returns the view factor of object i at the end-effector's pose X_SE, and its gradient for a motion of
    /// the end-effector, about O's origin. The shade is found to max(options.tolerance, kShadeTolerance).
    /// Throws as viewFactor does.
    ViewFactor viewFactor(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                          const ViewFactorOptions& options = {}) const;
    /// Returns only the value, to an absolute tolerance.
    double viewFactorValue(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                           double tolerance) const;

    /// The same with rough shade: see roughShadedViewFactor.
    RigidViewFactor roughViewFactor(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                                    double tolerance) const;
    /// Returns the share that the others leave, in [0, 1], of the view factor `unshaded`; 1 if that is zero.
    double roughShare(const RadiatingSource& source, std::size_t i, const Pose& X_SE, double unshaded) const;

    /// Returns what each object, fixture and shield takes of the light of each (other) object at the
    /// end-effector's pose X_SE, to about 0.001: the share of that object's view factor without shade that it
    /// would lose if these two were alone. Where shadows of several objects meet, each is charged with what
    /// lies in its own shadow, so the shares of one object may add up to more than what is lost. Shares below
    /// `min` are left out, and so are objects without a view factor. In the order of the objects, then of the
    /// takers. Throws as viewFactor does.
    std::vector<TakenLight> takenLight(const RadiatingSource& source, const Pose& X_SE,
                                       double min = kMinToldShare) const;

private:
    Blocker held(std::size_t plate, const Pose& X_SE) const;
    std::vector<Blocker> blockersOf(std::size_t i, const Pose& X_SE) const;
    ShadedViewFactor shaded(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                            const ViewFactorOptions& options) const;

    std::vector<MountedContour> m_objects;
    Screens m_screens;
    std::vector<Blocker> m_shields; ///< at their poses in S
    std::vector<std::vector<std::size_t>> m_inFront;
};

} // namespace bask
