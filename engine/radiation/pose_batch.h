#pragma once
// View factors at eight poses at once, for fields: a disk is seen whole from a smooth outline, at most poses
// of a grid.

#include "engine/radiation/kernels/kernels.h"
#include "engine/radiation/radiating_source.h"

#include <optional>
#include <span>
#include <vector>

namespace bask {

/// The same view factors as viewFactor() gives one by one, to rounding and the tolerance, at a fraction of
/// the time: the lanes of the processor are poses, and the rule on the outline is chosen once for all of
/// them. Immutable.
class PoseBatch {
public:
    static constexpr int kPoses = kernels::kPoses;

    /// Empty where the source is not one even disk, or the object not one smooth outline without holes.
    static std::optional<PoseBatch> of(const RadiatingSource& source, const RadiatingContour& object,
                                       double tolerance);

    /// Eight poses X_SO.
    struct Poses {
        double p[3][kPoses], R[3][3][kPoses];
        bool isOneRotation =
            true; ///< all have the rotation of the first; those of the others are not looked at

        Pose pose(std::size_t k) const;
        void copyRotation(std::size_t from, std::size_t to);
        void copy(std::size_t from, std::size_t to); ///< the rotation where they have one each
    };
    /// The results of those that were computed.
    struct Factors {
        unsigned computed =
            0; ///< bit k: pose k; the others are cut, hidden, near the source's outline or not there
        double values[kPoses];
        double gradients[6][kPoses]; ///< as ViewFactor::gradient, only if it was asked for
        double error = 0.0;          ///< estimate for all of them
    };
    /// The first `count` poses, the rest being any.
    void compute(const Poses& poses, int count, bool withGradient, Factors& factors) const;

private:
    PoseBatch(const RadiatingContour& source, const RadiatingContour& object, double tolerance);
    double leastHeight_m() const;
    unsigned seen(const Poses& poses, double (&overSource)[kPoses]) const;
    bool parallel(const Poses& poses, bool withGradient, Factors& factors) const;
    void tilted(const Poses& poses, const kernels::Outline& points, bool withGradient,
                Factors& factors) const;

    RadiatingContour m_source, m_object;
    double m_radius = 0.0;   ///< of the source, m
    double m_floor = 0.0;    ///< error of rounding
    double m_bound = 0.0;    ///< error of a rule: this times exp(-exponent)
    double m_allowed = 0.0;  ///< error of a rule
    double m_exponent = 0.0; ///< that is asked for
};

} // namespace bask
