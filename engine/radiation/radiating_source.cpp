#include "engine/radiation/radiating_source.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

namespace bask {
namespace {

/// Calls take(factor, term, X_PO, blockers in P) with each term that counts.
template <class Take>
void forTerms(const RadiatingSource& source, const Pose& X_SO, std::span<const Blocker> blockers,
              const Take& take) {
    for (std::size_t k = 0; k < source.terms().size(); ++k) {
        const SourceTerm& term = source.terms()[k];
        const double factor = source.factors()[k];
        if (factor == 0.0)
            continue;
        if (term.X_SP.matrix().isIdentity(0.0)) {
            take(factor, term, X_SO, blockers);
            continue;
        }
        const Pose X_PS = term.X_SP.inverse();
        std::vector<Blocker> moved(blockers.begin(), blockers.end());
        for (Blocker& blocker : moved)
            blocker.X_S = X_PS * blocker.X_S;
        take(factor, term, X_PS * X_SO, std::span<const Blocker>(moved));
    }
}

/// A gradient in the term's axes, turned into those of S.
Vector6d inSource(const SourceTerm& term, const Vector6d& gradient) {
    Vector6d turned;
    turned << term.X_SP.linear() * gradient.head<3>(), term.X_SP.linear() * gradient.tail<3>();
    return turned;
}

/// What all terms have, or partial.
class SumOfVisibilities {
public:
    void add(Visibility visibility) {
        m_sum = !m_sum || *m_sum == visibility ? visibility : Visibility::Partial;
    }
    Visibility sum() const { return m_sum.value_or(Visibility::Hidden); }

private:
    std::optional<Visibility> m_sum;
};

double tolerancePerTerm(const RadiatingSource& source, double tolerance) {
    return tolerance / std::max(source.size(), 1.0);
}

} // namespace

RadiatingSource::RadiatingSource(RadiatingContour contour) : m_factors{1.0} {
    m_terms.push_back({std::move(contour)});
}

RadiatingSource::RadiatingSource(std::vector<SourceTerm> terms, std::vector<double> factors)
    : m_terms(std::move(terms)), m_factors(std::move(factors)), m_size(0.0) {
    if (m_terms.empty() || m_factors.size() != m_terms.size())
        throw std::invalid_argument("RadiatingSource: one factor for each of at least one term");
    for (const double factor : m_factors) {
        if (!std::isfinite(factor))
            throw std::invalid_argument("RadiatingSource: a factor is not finite");
        m_size += std::abs(factor);
    }
    m_isEven =
        m_terms.size() == 1 && m_factors.front() == 1.0 && m_terms.front().X_SP.matrix().isIdentity(0.0);
}

RadiatingSource RadiatingSource::withFactors(std::vector<double> factors) const {
    return {m_terms, std::move(factors)};
}

ViewFactor viewFactor(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                      const ViewFactorOptions& options) {
    if (source.isEven())
        return viewFactor(source.terms().front().contour, object, X_SO, options);
    ViewFactorOptions perTerm = options;
    perTerm.tolerance = tolerancePerTerm(source, options.tolerance);
    ViewFactor sum;
    SumOfVisibilities seen;
    forTerms(source, X_SO, {},
             [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker>) {
                 const ViewFactor one = viewFactor(term.contour, object, X_PO, perTerm);
                 sum.value += factor * one.value;
                 sum.gradient += factor * inSource(term, one.gradient);
                 sum.errorEstimate += std::abs(factor) * one.errorEstimate;
                 seen.add(one.visibility);
             });
    sum.value = std::max(sum.value, 0.0);
    sum.visibility = seen.sum();
    return sum;
}

double viewFactorValue(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                       double tolerance, double* errorEstimate) {
    if (source.isEven())
        return viewFactorValue(source.terms().front().contour, object, X_SO, tolerance, errorEstimate);
    double sum = 0.0, error = 0.0;
    forTerms(source, X_SO, {},
             [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker>) {
                 double own = 0.0;
                 sum += factor * viewFactorValue(term.contour, object, X_PO,
                                                 tolerancePerTerm(source, tolerance), &own);
                 error += std::abs(factor) * own;
             });
    if (errorEstimate)
        *errorEstimate = error;
    return std::max(sum, 0.0);
}

ShadedViewFactor shadedViewFactor(const RadiatingSource& source, const RadiatingContour& object,
                                  const Pose& X_SO, std::span<const Blocker> blockers,
                                  const ShadeOptions& options) {
    if (source.isEven())
        return shadedViewFactor(source.terms().front().contour, object, X_SO, blockers, options);
    ShadeOptions perTerm = options;
    perTerm.tolerance = tolerancePerTerm(source, options.tolerance);
    perTerm.unshaded.tolerance = tolerancePerTerm(source, options.unshaded.tolerance);
    ShadedViewFactor sum;
    SumOfVisibilities seen;
    forTerms(source, X_SO, blockers,
             [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker> inP) {
                 const ShadedViewFactor one = shadedViewFactor(term.contour, object, X_PO, inP, perTerm);
                 sum.value += factor * one.value;
                 sum.unshaded += factor * one.unshaded;
                 sum.gradient += factor * inSource(term, one.gradient);
                 sum.gradientRigid += factor * inSource(term, one.gradientRigid);
                 sum.errorEstimate += std::abs(factor) * one.errorEstimate;
                 seen.add(one.visibility);
             });
    sum.unshaded = std::max(sum.unshaded, 0.0);
    sum.value = std::clamp(sum.value, 0.0, sum.unshaded);
    sum.visibility = seen.sum();
    return sum;
}

RigidViewFactor roughShadedViewFactor(const RadiatingSource& source, const RadiatingContour& object,
                                      const Pose& X_SO, std::span<const Blocker> blockers, double tolerance) {
    if (source.isEven())
        return roughShadedViewFactor(source.terms().front().contour, object, X_SO, blockers, tolerance);
    RigidViewFactor sum;
    forTerms(source, X_SO, blockers,
             [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker> inP) {
                 const RigidViewFactor one = roughShadedViewFactor(term.contour, object, X_PO, inP,
                                                                   tolerancePerTerm(source, tolerance));
                 sum.value += factor * one.value;
                 sum.gradient += factor * inSource(term, one.gradient);
             });
    sum.value = std::max(sum.value, 0.0);
    return sum;
}

double roughShade(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                  std::span<const Blocker> blockers) {
    if (source.isEven())
        return roughShade(source.terms().front().contour, object, X_SO, blockers);
    double sum = 0.0;
    forTerms(source, X_SO, blockers,
             [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker> inP) {
                 sum += factor * roughShade(term.contour, object, X_PO, inP);
             });
    return std::max(sum, 0.0);
}

} // namespace bask
