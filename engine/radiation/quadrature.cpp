#include "engine/radiation/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace bask {

namespace {

constexpr int kMaxGauss = 16;

struct GaussTable {
    std::vector<double> nodes, weights;
};

// Newton's method on the Legendre polynomial, from the usual cosine guess.
GaussTable makeGaussTable(int n) {
    GaussTable table{std::vector<double>(n), std::vector<double>(n)};
    for (int i = 0; i < n; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
        double slope = 1.0;
        for (int step = 0; step < 50; ++step) {
            double p = 1.0;
            double previous = 0.0;
            for (int k = 1; k <= n; ++k)
                previous = std::exchange(p, ((2 * k - 1) * x * p - (k - 1) * previous) / k);
            slope = n * (x * p - previous) / (x * x - 1.0);
            const double change = p / slope;
            x -= change;
            if (std::abs(change) < 1e-16)
                break;
        }
        table.nodes[i] = 0.5 * (1.0 - x);
        table.weights[i] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    return table;
}

// QUADPACK's table of the (7, 15) pair: abscissa on [-1, 1], Kronrod weight, Gauss weight.
constexpr double kKronrod[8][3] = {
    {0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0},
    {0.949107912342758524526189684047851, 0.063092092629978553290700663189204,
     0.129484966168869693270611432679082},
    {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
    {0.741531185599394439863864773280788, 0.140653259715525918745189590510238,
     0.279705391489276667901467771423780},
    {0.586087235467691130294144691693013, 0.169004726639267902826583426598550, 0.0},
    {0.405845151377397166906606412076961, 0.190350578064785409913256402421014,
     0.381830050505118944950369775488975},
    {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
    {0.0, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327},
};

} // namespace

LoopDifference difference(const LoopSums& a, const LoopSums& b, double length_m) {
    LoopDifference result{std::abs(a.circulation - b.circulation), 0.0};
    for (std::size_t i = 0; i < 6; ++i)
        result.moments =
            std::max(result.moments, (i < 3 ? length_m : 1.0) * std::abs(a.moments[i] - b.moments[i]));
    return result;
}

GaussRule gaussRule(int n) {
    static const auto tables = [] {
        std::array<GaussTable, kMaxGauss + 1> made;
        for (int k = 1; k <= kMaxGauss; ++k)
            made[static_cast<std::size_t>(k)] = makeGaussTable(k);
        return made;
    }();
    if (n < 1 || n > kMaxGauss)
        throw std::invalid_argument("gaussRule: between 1 and 16 points");
    const GaussTable& table = tables[static_cast<std::size_t>(n)];
    return {table.nodes, table.weights};
}

const std::array<KronrodPoint, 15>& kronrodPoints() {
    static const auto points = [] {
        std::array<KronrodPoint, 15> made{};
        for (std::size_t i = 0; i < 15; ++i) {
            const double* row = kKronrod[i < 8 ? i : 14 - i];
            made[i] = {0.5 + (i < 8 ? -0.5 : 0.5) * row[0], 0.5 * row[1], 0.5 * row[2]};
        }
        return made;
    }();
    return points;
}

int PanelList::worst() const {
    double circulation = 0.0;
    double moments = 0.0;
    double worstScore = -1.0;
    int worst = -1;
    bool allResolved = true;
    for (std::size_t i = 0; i < m_panels.size(); ++i) {
        const AdaptivePanel& panel = m_panels[i];
        circulation += panel.error.circulation;
        moments += panel.error.moments;
        allResolved = allResolved && panel.resolved;
        double score =
            std::max(panel.error.circulation / m_goal.circulation, panel.error.moments / m_goal.moments);
        if (!panel.resolved)
            score = std::max(score, 1.0) * 1e6;
        if (panel.to - panel.from > 1e-13 && score > worstScore) {
            worstScore = score;
            worst = static_cast<int>(i);
        }
    }
    return allResolved && circulation <= m_goal.circulation && moments <= m_goal.moments ? -1 : worst;
}

AdaptiveResult PanelList::total() const {
    AdaptiveResult result;
    for (const AdaptivePanel& panel : m_panels) {
        result.sums.add(panel.sums);
        result.error += panel.error.circulation;
        // Points ran out before the rule could see the source's edge: its own difference flatters.
        if (!panel.resolved)
            result.error += 9.0 * panel.error.circulation + 0.02 * std::abs(panel.sums.circulation);
    }
    return result;
}

} // namespace bask
