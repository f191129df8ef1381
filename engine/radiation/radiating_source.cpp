#include "engine/radiation/radiating_source.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <variant>

namespace bask {
namespace {

/// A term and its factor in a sum.
struct Summand {
    const SourceTerm* term;
    double factor;
};

std::vector<Summand> allOf(const RadiatingSource& source) {
    std::vector<Summand> summands;
    for (std::size_t k = 0; k < source.terms().size(); ++k)
        if (source.factors()[k] != 0.0)
            summands.push_back({&source.terms()[k], source.factors()[k]});
    return summands;
}

constexpr std::size_t kShadeRings = 8, kRoughRings = 4;

/// What shade is found with: of more whole disks one in the other than `rings` that many, the others being
/// between two of them, linear in the square of the radius. Shade costs a hundred times as much as what it is
/// taken from.
struct ShadeSum {
    std::vector<Summand> summands;
    /// Of each summand and the one before it: the factors of the disks between them, each times its larger
    /// share. What is taken from a disk grows with it, so this times the growth from the one to the other
    /// bounds the error.
    std::vector<double> between;
};

/// The first disk, the last one, and those that cut the factors between them into equal sums.
std::vector<std::size_t> keptRings(const std::vector<Summand>& sorted, std::size_t rings) {
    double total = 0.0;
    for (std::size_t k = 1; k + 1 < sorted.size(); ++k)
        total += std::abs(sorted[k].factor);
    std::vector<std::size_t> kept{0};
    double sum = 0.0;
    for (std::size_t k = 1; k + 1 < sorted.size() && kept.size() + 1 < rings; ++k) {
        sum += std::abs(sorted[k].factor);
        if (sum * static_cast<double>(rings - 1) >= total * static_cast<double>(kept.size()))
            kept.push_back(k);
    }
    kept.push_back(sorted.size() - 1);
    return kept;
}

ShadeSum forShade(const RadiatingSource& source, std::size_t rings) {
    std::vector<Summand> all = allOf(source);
    const auto radius_m = [](const Summand& s) { return std::get<Disk>(s.term->contour.shape()).radius_m; };
    const bool areRings = std::ranges::all_of(all, [](const Summand& s) {
        return std::holds_alternative<Disk>(s.term->contour.shape()) && s.term->X_SP.matrix().isIdentity(0.0);
    });
    if (!areRings || all.size() <= rings)
        return {all, std::vector<double>(all.size(), 0.0)};
    std::ranges::sort(all, {}, radius_m);
    std::vector<Summand> kept;
    for (const std::size_t k : keptRings(all, rings))
        kept.push_back({all[k].term, 0.0});
    std::vector<double> between(kept.size(), 0.0);
    std::size_t above = 1;
    for (const Summand& ring : all) {
        while (above + 1 < kept.size() && radius_m(kept[above]) < radius_m(ring))
            ++above;
        const double from = std::pow(radius_m(kept[above - 1]), 2), to = std::pow(radius_m(kept[above]), 2);
        const double share = (std::pow(radius_m(ring), 2) - from) / (to - from);
        kept[above - 1].factor += (1.0 - share) * ring.factor;
        kept[above].factor += share * ring.factor;
        if (share > 0.0 && share < 1.0)
            between[above] += std::abs(ring.factor) * std::max(share, 1.0 - share);
    }
    return {kept, between};
}

/// Calls take(factor, term, X_PO, blockers in P) with each summand.
template <class Take>
void forSummands(const std::vector<Summand>& summands, const Pose& X_SO, std::span<const Blocker> blockers,
                 const Take& take) {
    for (const auto& [term, factor] : summands) {
        if (term->X_SP.matrix().isIdentity(0.0)) {
            take(factor, *term, X_SO, blockers);
            continue;
        }
        const Pose X_PS = term->X_SP.inverse();
        std::vector<Blocker> moved(blockers.begin(), blockers.end());
        for (Blocker& blocker : moved)
            blocker.X_S = X_PS * blocker.X_S;
        take(factor, *term, X_PS * X_SO, std::span<const Blocker>(moved));
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

RadiatingSource::RadiatingSource(const RadiatingContour& contour) : m_terms{{contour}}, m_factors{1.0} {}

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
    forSummands(allOf(source), X_SO, {},
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
    forSummands(allOf(source), X_SO, {},
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
    const ViewFactor unshaded = viewFactor(source, object, X_SO, options.unshaded);
    ShadeOptions perTerm = options;
    perTerm.tolerance = tolerancePerTerm(source, options.tolerance);
    perTerm.unshaded.tolerance = tolerancePerTerm(source, options.unshaded.tolerance);
    ShadedViewFactor sum;
    sum.unshaded = unshaded.value;
    sum.visibility = unshaded.visibility;
    sum.gradient = sum.gradientRigid = unshaded.gradient;
    sum.errorEstimate = unshaded.errorEstimate;
    double taken = 0.0, takenBefore = 0.0;
    const ShadeSum shade = forShade(source, kShadeRings);
    std::size_t k = 0;
    forSummands(shade.summands, X_SO, blockers,
                [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker> inP) {
                    const ShadedViewFactor one = shadedViewFactor(term.contour, object, X_PO, inP, perTerm);
                    const double takenHere = one.unshaded - one.value;
                    sum.errorEstimate += shade.between[k++] * std::max(takenHere - takenBefore, 0.0);
                    takenBefore = takenHere;
                    if (takenHere == 0.0)
                        return;
                    const Vector6d alone = viewFactor(term.contour, object, X_PO, perTerm.unshaded).gradient;
                    taken += factor * takenHere;
                    sum.gradient += factor * inSource(term, one.gradient - alone);
                    sum.gradientRigid += factor * inSource(term, one.gradientRigid - alone);
                    sum.errorEstimate += std::abs(factor) * one.errorEstimate;
                });
    sum.value = std::clamp(sum.unshaded - taken, 0.0, sum.unshaded);
    return sum;
}

RigidViewFactor roughShadedViewFactor(const RadiatingSource& source, const RadiatingContour& object,
                                      const Pose& X_SO, std::span<const Blocker> blockers, double tolerance) {
    if (source.isEven())
        return roughShadedViewFactor(source.terms().front().contour, object, X_SO, blockers, tolerance);
    const ViewFactorOptions perTerm{.tolerance = tolerancePerTerm(source, tolerance)};
    const ViewFactor unshaded = viewFactor(source, object, X_SO, {.tolerance = tolerance});
    RigidViewFactor sum{unshaded.value, unshaded.gradient};
    forSummands(forShade(source, kRoughRings).summands, X_SO, blockers,
                [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker> inP) {
                    const RigidViewFactor one =
                        roughShadedViewFactor(term.contour, object, X_PO, inP, perTerm.tolerance);
                    const ViewFactor alone = viewFactor(term.contour, object, X_PO, perTerm);
                    sum.value += factor * (one.value - alone.value);
                    sum.gradient += factor * inSource(term, one.gradient - alone.gradient);
                });
    sum.value = std::clamp(sum.value, 0.0, unshaded.value);
    return sum;
}

double roughShade(const RadiatingSource& source, const RadiatingContour& object, const Pose& X_SO,
                  std::span<const Blocker> blockers) {
    if (source.isEven())
        return roughShade(source.terms().front().contour, object, X_SO, blockers);
    double sum = 0.0;
    forSummands(forShade(source, kRoughRings).summands, X_SO, blockers,
                [&](double factor, const SourceTerm& term, const Pose& X_PO, std::span<const Blocker> inP) {
                    sum += factor * roughShade(term.contour, object, X_PO, inP);
                });
    return std::max(sum, 0.0);
}

} // namespace bask
