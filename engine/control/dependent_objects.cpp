#include "engine/control/dependent_objects.h"

#include <Eigen/SVD>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace bask {
namespace {

constexpr int kPoses = 128;
constexpr double kDependent = 1e-3; ///< of the largest singular value
constexpr double kStill = 1e-5;     ///< 1/m: smaller values are errors of the view factors
constexpr double kAlike = 1e-6;     ///< difference of two view factors

/// Van der Corput's sequence: spreads over (0, 1), independently of that of another prime.
double spread(int index, int prime) {
    double out = 0.0;
    double digit = 1.0;
    for (; index > 0; index /= prime) {
        digit /= prime;
        out += digit * (index % prime);
    }
    return out;
}

Vector6d samplePose(const RigGeometry& rig, const Vector6d& fixed, int index) {
    static constexpr std::array<int, 6> kPrimes{2, 3, 5, 7, 11, 13};
    Vector6d q = fixed;
    for (const int k : rig.freeCoordinates()) {
        const double share = spread(index, kPrimes[static_cast<std::size_t>(k)]);
        q[k] = rig.limits().lower[k] + share * (rig.limits().upper[k] - rig.limits().lower[k]);
    }
    return q;
}

Eigen::MatrixXd freeColumns(const RigGeometry& rig, const ViewFactors& at) {
    Eigen::MatrixXd out(rig.objects(), rig.freeCoordinates().size());
    Eigen::Index column = 0;
    for (const int k : rig.freeCoordinates())
        out.col(column++) = at.dF.col(k) / (k < kThetaX ? 1.0 : kRotationLength_m);
    return out;
}

std::vector<int> membersOf(unsigned set) {
    std::vector<int> out;
    for (int i = 0; set >> i != 0; ++i)
        if ((set >> i & 1U) != 0)
            out.push_back(i);
    return out;
}

/// Relative to the whole matrix, since a single row has no scale of its own.
bool independent(const Eigen::MatrixXd& J, const std::vector<int>& rows) {
    if (std::cmp_greater(rows.size(), J.cols()))
        return false;
    const Eigen::MatrixXd part = J(rows, Eigen::all);
    return part.jacobiSvd().singularValues().minCoeff() > std::max(kStill, kDependent * J.norm());
}

struct Sample {
    std::vector<Eigen::VectorXd> F;
    std::vector<Eigen::MatrixXd> J;

    bool dependent(const std::vector<int>& objects) const {
        return std::ranges::none_of(J, [&](const Eigen::MatrixXd& at) { return independent(at, objects); });
    }
    bool equal(int a, int b) const {
        return std::ranges::all_of(
            F, [=](const Eigen::VectorXd& at) { return std::abs(at[a] - at[b]) < kAlike; });
    }
};

/// Empty if all objects are independent at some pose.
Sample dependentSample(const RigGeometry& rig, const Vector6d& fixed) {
    std::vector<int> all(static_cast<std::size_t>(rig.objects()));
    std::iota(all.begin(), all.end(), 0);
    Sample out;
    for (int index = 1; index <= kPoses; ++index) {
        const Vector6d q = samplePose(rig, fixed, index);
        if (!rig.allowed(q) || rig.lowestPoint_m(q) <= 0.0)
            continue;
        const ViewFactors at = rig.viewFactors(q);
        out.F.push_back(at.F);
        out.J.push_back(freeColumns(rig, at));
        if (independent(out.J.back(), all))
            return {};
    }
    return out;
}

} // namespace

std::vector<DependentObjects> dependentObjects(const RigGeometry& rig, const Vector6d& fixed) {
    std::vector<DependentObjects> out;
    if (rig.objects() == 0)
        return out;
    const Sample sample = dependentSample(rig, fixed);
    if (sample.J.empty())
        return out;
    std::vector<unsigned> found;
    for (int size = 1; size <= rig.objects(); ++size) {
        for (unsigned set = 1; set >> rig.objects() == 0; ++set) {
            const bool isMinimal = std::ranges::none_of(found, [=](unsigned f) { return (f & set) == f; });
            if (std::popcount(set) != size || !isMinimal)
                continue;
            const std::vector<int> objects = membersOf(set);
            if (!sample.dependent(objects))
                continue;
            found.push_back(set);
            out.push_back({objects, size == 2 && sample.equal(objects[0], objects[1])});
        }
    }
    return out;
}

} // namespace bask
