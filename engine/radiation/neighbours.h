#pragma once
// Radiation that objects on one end-effector exchange with one another, by the net-radiation method.

#include "engine/radiation/mounted_objects.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// What a face does with radiation.
struct FaceMaterial {
    double emittance = 0.9;   ///< for radiation of the objects
    double absorptance = 0.9; ///< for the source's radiation
};

/// Returns the view factors from each face (rows) to each other, the fronts of the N objects, then their
/// backs, with the shade of the other objects and of fixtures, to 1e-5; empty if none sees another. Objects
/// that pass through one another do not.
Eigen::MatrixXd faceViewFactors(const MountedObjects& objects);

/// What N objects on one end-effector receive from one another, beyond what the room would send from there.
/// They move as one, so it does not depend on the pose. Faces are gray and diffuse; backs are adiabatic: they
/// give back what falls on them. The source sends back nothing of what they radiate. Objects that do not see
/// one another, as in one plane, exchange nothing: every function then returns its argument, or zero.
/// Fixtures stand between objects as the room would; shields, which do not move with them, are left out.
/// Immutable; thread-safe.
class Neighbours {
public:
    Neighbours() = default;
    /// The view factors between the faces, with the shade of the other objects and of fixtures, are found to
    /// 1e-5. Objects that pass through one another exchange nothing; nobody can build them. Throws
    /// std::invalid_argument unless there is one material for each object.
    Neighbours(const MountedObjects& objects, const std::vector<FaceMaterial>& fronts);

    /// Returns whether any object sees another.
    bool exchange() const { return m_reflected.size() > 0; }
    /// Returns the view factors (N) to the source, or their derivatives (N x k), with the source's radiation
    /// that the neighbours reflect: what an object absorbs of it is in proportion to this.
    Eigen::MatrixXd withReflections(const Eigen::MatrixXd& F) const;
    /// Returns by how much the neighbours raise the fourth power of the room's temperature for each object,
    /// K4: its heat rate is lambda2 times that higher. `excess_K4`: by how much each object's T^4 is above
    /// that at which it rests in the room (N).
    Eigen::VectorXd gains_K4(const Eigen::VectorXd& excess_K4) const;

private:
    Eigen::MatrixXd m_reflected; ///< irradiation of the fronts by that from the source; empty: no exchange
    Eigen::MatrixXd m_received;  ///< irradiation of the fronts by the excess of sigma T^4 of the fronts
};

} // namespace bask
