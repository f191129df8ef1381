#include "engine/radiation/gauss_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bask {

namespace {

struct Rule {
    std::vector<double> nodes, weights;
};

// Newton's method on the Legendre polynomial, from the usual cosine guess.
Rule makeRule(int n) {
    Rule rule{std::vector<double>(static_cast<std::size_t>(n)),
              std::vector<double>(static_cast<std::size_t>(n))};
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
        rule.nodes[static_cast<std::size_t>(i)] = 0.5 * (1.0 - x);
        rule.weights[static_cast<std::size_t>(i)] = 1.0 / ((1.0 - x * x) * slope * slope);
    }
    return rule;
}

} // namespace

GaussRule gaussRule(int n) {
    static const auto rules = [] {
        std::array<Rule, kMaxGaussPoints + 1> made;
        for (int k = 1; k <= kMaxGaussPoints; ++k)
            made[static_cast<std::size_t>(k)] = makeRule(k);
        return made;
    }();
    if (n < 1 || n > kMaxGaussPoints)
        throw std::invalid_argument("gaussRule: between 1 and 16 points");
    const Rule& rule = rules[static_cast<std::size_t>(n)];
    return {rule.nodes, rule.weights};
}

double ellipseExponent(double distance) {
    return distance > 1.0 ? std::acosh(distance) : 0.0;
}

int gaussOrder(double distance, double exponent) {
    const double each = 2.0 * ellipseExponent(distance);
    return each * kMaxGaussPoints <= exponent ? kMaxGaussPoints
                                              : std::max(1, static_cast<int>(std::ceil(exponent / each)));
}

double gaussDistance(int n, double exponent) {
    return std::cosh(exponent / (2.0 * n));
}

} // namespace bask
