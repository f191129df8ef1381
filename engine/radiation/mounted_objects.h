#pragma once
// Objects on one end-effector: the view factor of each, with the shade of the others.

#include "engine/radiation/radiating_source.h"

#include <algorithm>
#include <vector>

namespace bask {

/// An object and its mounting on the end-effector.
struct MountedContour {
    RadiatingContour contour;
    Pose X_EO = Pose::Identity();
};

/// Error to which the shade is found, absolute, where less is not asked for.
inline constexpr double kShadeTolerance = 1e-5;

/// Shares below this are not worth a sentence.
inline constexpr double kMinToldShare = 0.005;

/// What one object takes of the light of another.
struct TakenLight {
    std::size_t object = 0;
    std::size_t taker = 0;
    double share = 0.0; ///< of the object's view factor without shade, in (0, 1]
};

/// Knows which objects may shade which: where nothing of the others lies in front of an object's face, as
/// with objects in one plane, its view factor is viewFactor's own, bit for bit. Objects that pass through one
/// another do not shade one another; nobody can build them. Immutable; thread-safe.
class MountedObjects {
public:
    MountedObjects() = default;
    explicit MountedObjects(std::vector<MountedContour> objects);

    std::size_t size() const { return m_objects.size(); }
    bool empty() const { return m_objects.empty(); }
    const MountedContour& operator[](std::size_t i) const { return m_objects[i]; }
    /// Returns the objects of which a part lies in front of the face of object i.
    const std::vector<std::size_t>& inFrontOf(std::size_t i) const { return m_inFront[i]; }

    /// Returns whether an object may shade another at some pose.
    bool mayShade() const { return !std::ranges::all_of(m_inFront, &std::vector<std::size_t>::empty); }

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

    /// Returns what each object takes of the light of each other object at the end-effector's pose X_SE, to
    /// about 0.001: the share of the other's view factor without shade that it would lose if these two were
    /// alone. Where shadows of several objects meet, each is charged with what lies in its own shadow, so the
    /// shares of one object may add up to more than what is lost. Shares below `min` are left out, and so
    /// are objects without a view factor. In the order of the objects, then of the takers. Throws as
    /// viewFactor does.
    std::vector<TakenLight> takenLight(const RadiatingSource& source, const Pose& X_SE,
                                       double min = kMinToldShare) const;

private:
    Blocker blocker(std::size_t i, const Pose& X_SE) const;
    std::vector<Blocker> blockersOf(std::size_t i, const Pose& X_SE) const;
    ShadedViewFactor shaded(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                            const ViewFactorOptions& options) const;

    std::vector<MountedContour> m_objects;
    std::vector<std::vector<std::size_t>> m_inFront;
};

} // namespace bask
