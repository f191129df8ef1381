#include "engine/radiation/interaction_matrix.h"

#include <algorithm>

namespace bask {

namespace {

/// `factorOf(i)` gives value and gradient of object i for a motion of the end-effector, about O's origin.
template <class FactorOf>
InteractionMatrix matrixOf(const MountedObjects& objects, const Pose& X_SE, const FreedomMask& free,
                           const Eigen::Matrix3d& R_RS, const FactorOf& factorOf,
                           const std::vector<bool>& wanted = {}) {
    const auto rows = static_cast<Eigen::Index>(objects.size());
    InteractionMatrix result{Eigen::VectorXd::Zero(rows),
                             Eigen::MatrixXd::Zero(rows, std::ranges::count(free, true))};
    for (Eigen::Index i = 0; i < rows; ++i) {
        const auto number = static_cast<std::size_t>(i);
        if (!wanted.empty() && !wanted[number])
            continue;
        const auto [value, gradient] = factorOf(number);
        const Eigen::Vector3d p_SO = (X_SE * objects[number].X_EO).translation();
        const Vector6d inS = gradientAbout(gradient, p_SO, X_SE.translation());
        Vector6d inR;
        inR << R_RS * inS.head<3>(), R_RS * inS.tail<3>();
        result.F[i] = value;
        Eigen::Index column = 0;
        for (std::size_t k = 0; k < 6; ++k)
            if (free[k])
                result.J(i, column++) = inR[static_cast<Eigen::Index>(k)];
    }
    return result;
}

} // namespace

InteractionMatrix interactionMatrix(const RadiatingSource& source, const MountedObjects& objects,
                                    const Pose& X_SE, const FreedomMask& free, const Eigen::Matrix3d& R_RS,
                                    const ViewFactorOptions& options) {
    return matrixOf(objects, X_SE, free, R_RS, [&](std::size_t i) {
        const ViewFactor factor = objects.viewFactor(source, i, X_SE, options);
        return RigidViewFactor{factor.value, factor.gradient};
    });
}

InteractionMatrix roughInteractionMatrix(const RadiatingSource& source, const MountedObjects& objects,
                                         const Pose& X_SE, const Eigen::Matrix3d& R_RS, double tolerance,
                                         const std::vector<bool>& wanted) {
    return matrixOf(
        objects, X_SE, kAllFree, R_RS,
        [&](std::size_t i) { return objects.roughViewFactor(source, i, X_SE, tolerance); }, wanted);
}

} // namespace bask
