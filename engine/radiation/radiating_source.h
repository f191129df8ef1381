#pragma once
// A source that radiates evenly or not: a sum of outlines with factors.

#include "engine/radiation/shade.h"

#include <span>
#include <vector>

namespace bask {

/// An outline of an uneven source. It radiates along +z of its frame P.
struct SourceTerm {
    RadiatingContour contour;
    Pose X_SP = Pose::Identity();
};

/// The view factor to the source is F = sum over the terms of factor * F_term. The terms are parts, whose
/// factors are by how much they radiate more or less than the source at its own temperature; or whole disks
/// one in the other, whose factors are by how much the radiation falls at their rims: rings. What is between
/// terms does not radiate. Terms do not shade one another. An even source is one outline with the factor 1:
/// its view factors are those of that outline, bit for bit. Immutable but for assignment; thread-safe.
class RadiatingSource {
public:
    /// Makes an even source.
    RadiatingSource(
        const RadiatingContour& contour); // NOLINT(google-explicit-constructor): an outline is a source
    /// Makes an uneven one. Throws std::invalid_argument without terms, or unless there is one finite factor
    /// for each.
    RadiatingSource(std::vector<SourceTerm> terms, std::vector<double> factors);

    bool isEven() const { return m_isEven; }
    const std::vector<SourceTerm>& terms() const { return m_terms; }
    const std::vector<double>& factors() const { return m_factors; }
    /// Returns the same terms with other factors. Shares the outlines. Throws as the constructor does.
    RadiatingSource withFactors(std::vector<double> factors) const;
    /// Returns the sum of the factors' sizes: an error of that over this in each term is the error of F.
    double size() const { return m_size; }

private:
    std::vector<SourceTerm> m_terms;
    std::vector<double> m_factors;
    double m_size = 1.0;
    bool m_isEven = true;
};

// As for a single outline (view_factor.h, shade.h): X_SO and the blockers' poses are in S, gradients in its
// axes, tolerances and errors those of the sum; what many rings take of shade is found with a few of them, to
// about a thousandth of it, which is in the error estimate. `visibility` is full or hidden if that of all
// terms is. The value of a sum is not negative, and may be above 1 where parts radiate more than the source
// itself.
ViewFactor viewFactor(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options = {});
double viewFactorValue(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance = 1e-9, double* errorEstimate = nullptr);
ShadedViewFactor shadedViewFactor(const RadiatingSource& source, const RadiatingContour& object,
                                  const Pose& X_SO, std::span<const Blocker> blockers,
                                  const ShadeOptions& options = {});
RigidViewFactor roughShadedViewFactor(const RadiatingSource& source, const RadiatingContour& object,
                                      const Pose& X_SO, std::span<const Blocker> blockers, double tolerance);
double roughShade(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                  std::span<const Blocker> blockers);

} // namespace bask
