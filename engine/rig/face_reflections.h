#pragma once
// What the faces of the held objects reflect in a thermal camera's band: the source as it radiates, one
// another, and the room.

#include "engine/radiation/mounted_objects.h"
#include "engine/thermal/source_emission.h"
#include "engine/thermography/face_thermometer.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// What is believed of a rig's faces. Both faces of an object have its emittance.
struct ReflectingRig {
    MountedObjects objects;                     ///< with the screens, which are as cold as the room
    std::vector<double> emittances;             ///< in the camera's band
    std::vector<double> emittanceUncertainties; ///< standard
    /// What radiates of the source, in S; of an even one its outline.
    std::vector<SourceTerm> sourceTerms;
    SourceEmission emission; ///< one term for each of `sourceTerms`, also of an even source
    double sourceEmittanceUncertainty = 0.0;
};

/// A temperature with its standard uncertainty, K.
struct KnownTemperature {
    double T_K = 0.0;
    double uncertainty_K = 0.0;
};

/// What is known at one time.
struct ReflectionMoment {
    Pose X_RE = Pose::Identity(), X_RS = Pose::Identity();
    KnownTemperature source, room;
    std::vector<KnownTemperature> objects;
};

/// The view factors of the moment are with shade. An uneven source is given as one surface as hot as its
/// hottest part, under the view factor with which that would be as bright: then no part is forgotten, and no
/// view factor above one. A neighbour is given as the black body of its radiosity, so that it also reflects
/// the source, the room and the others, the face itself included. Not thread-safe.
class FaceReflections {
public:
    /// Throws std::invalid_argument unless there is one emittance with its uncertainty for each object, and
    /// one term of emission for each of the source.
    FaceReflections(ReflectingRig rig, std::shared_ptr<const BandRadiance> band);

    /// Returns whether any face sees one of another object: then temperatures of objects matter.
    bool exchange() const { return m_F.size() > 0; }
    /// Returns the faces of all objects, the fronts and then the backs; those that are not `wanted` may be
    /// without surfaces. Of a front the source is the first surface, also where it is not seen; of a back
    /// only where it is seen.
    std::vector<KnownFace> at(const ReflectionMoment& moment, const std::vector<bool>& wanted);
    /// Returns whether a face of the last at() has the source among its surfaces.
    bool seesSource(std::size_t face) const { return m_seesSource.at(face); }

private:
    /// The source at one temperature.
    struct Glow {
        RadiatingSource source; ///< view factors of the surface as hot as the hottest part
        /// The same for a source that is 1 K hotter, in units of the first: for the uncertainty.
        std::optional<RadiatingSource> hotter;
        ReflectedSurface surface;
        bool isSeen = true; ///< whether it is brighter than the room
    };
    Glow glowAt(const ReflectionMoment& moment);
    std::vector<double> brightness(double source_K) const;
    void addSource(const Glow& glow, std::size_t face, const Pose& X_SE, const KnownTemperature& source,
                   KnownFace& out) const;
    void addNeighbours(const ReflectionMoment& moment, std::vector<KnownFace>& faces) const;

    ReflectingRig m_rig;
    std::shared_ptr<const BandRadiance> m_band;
    MountedObjects m_backs;
    Eigen::MatrixXd m_F; ///< between the faces; empty: none sees another
    std::vector<bool> m_seesSource;
};

} // namespace bask
