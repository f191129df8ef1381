#pragma once
// The interaction matrix of objects on one end-effector: how their view factors change with its twist.

#include "engine/radiation/mounted_objects.h"

#include <array>

namespace bask {

/// The components of the twist [v; w] in which the robot can move.
using FreedomMask = std::array<bool, 6>;
inline constexpr FreedomMask kAllFree{true, true, true, true, true, true};

/// N view factors and their N x n matrix dF/dt = J u, where u are the n free components of the end-effector's
/// twist: translation (1/m) and rotation about E's origin (1/rad).
struct InteractionMatrix {
    Eigen::VectorXd F;
    Eigen::MatrixXd J;
};

/// Returns the matrix, with the shade of the objects on one another, at the pose X_SE, for a twist in the
/// axes of R: R_RS turns the source's axes into them (identity: the twist is in source axes). The matrix of
/// the paper is lambda1_i times row i. Throws as viewFactor does.
InteractionMatrix interactionMatrix(const RadiatingSource& source, const MountedObjects& objects,
                                    const Pose& X_SE, const FreedomMask& free = kAllFree,
                                    const Eigen::Matrix3d& R_RS = Eigen::Matrix3d::Identity(),
                                    const ViewFactorOptions& options = {});

/// The same for all six components, with rough shade: see roughShadedViewFactor. Rows of objects that are not
/// wanted are zero; empty: all are.
InteractionMatrix roughInteractionMatrix(const RadiatingSource& source, const MountedObjects& objects,
                                         const Pose& X_SE, const Eigen::Matrix3d& R_RS, double tolerance,
                                         const std::vector<bool>& wanted = {});

} // namespace bask
