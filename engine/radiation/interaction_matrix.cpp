#include "engine/radiation/interaction_matrix.h"

#include <algorithm>

namespace bask {

InteractionMatrix interactionMatrix(const RadiatingContour& source, std::span<const MountedContour> objects,
                                    const Pose& X_SE, const FreedomMask& free, const Eigen::Matrix3d& R_RS,
                                    const ViewFactorOptions& options) {
    const auto rows = static_cast<Eigen::Index>(objects.size());
    InteractionMatrix result{Eigen::VectorXd(rows), Eigen::MatrixXd(rows, std::ranges::count(free, true))};
    for (Eigen::Index i = 0; i < rows; ++i) {
        const MountedContour& object = objects[static_cast<std::size_t>(i)];
        const Pose X_SO = X_SE * object.X_EO;
        const ViewFactor factor = viewFactor(source, object.contour, X_SO, options);
        const Vector6d inS = gradientAbout(factor.gradient, X_SO.translation(), X_SE.translation());
        Vector6d inR;
        inR << R_RS * inS.head<3>(), R_RS * inS.tail<3>();
        result.F[i] = factor.value;
        Eigen::Index column = 0;
        for (std::size_t k = 0; k < 6; ++k)
            if (free[k])
                result.J(i, column++) = inR[static_cast<Eigen::Index>(k)];
    }
    return result;
}

} // namespace bask
