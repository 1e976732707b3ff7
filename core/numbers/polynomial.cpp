// SPDX-License-Identifier: MIT
#include "core/numbers/polynomial.hpp"

namespace camopt {

namespace {

/// The root of a polynomial that is monotone on [a, b] with p(a) p(b) < 0: Newton's method with a bracket.
double bracketed_root(const Eigen::Ref<const Eigen::VectorXd>& coefficients, double a, double b) {
    const Eigen::VectorXd slope = differentiated(coefficients);
    const bool rising = evaluate_polynomial(coefficients, b) > 0.0;
    double t = 0.5 * (a + b);
    // Bisection alone ends within 60 halvings of double precision; Newton usually needs five steps.
    constexpr int most_steps = 120;
    for (int step = 0; step < most_steps; ++step) {
        const double value = evaluate_polynomial(coefficients, t);
        if (value == 0.0) return t;
        ((value > 0.0) == rising ? b : a) = t;
        const double newton = t - value / evaluate_polynomial(slope, t);
        const double next = newton > a && newton < b ? newton : 0.5 * (a + b);
        if (next == t || std::nextafter(a, b) >= b) return t;
        t = next;
    }
    return t;
}

/// Of bounded size: no allocation where a maximum is excluded.
using Bernstein = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 28, 1>;

/// b_j = Σ_{k<=j} C(j,k) / C(n,k) c_k.
Bernstein bernstein(const Eigen::Ref<const Eigen::VectorXd>& power) {
    const Eigen::Index n = power.size() - 1;
    Bernstein table = power;
    // By differences: scale to c_k / C(n,k), then sum up n times.
    double binomial = 1.0;
    for (Eigen::Index k = 0; k <= n; ++k) {
        table[k] /= binomial;
        binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    for (Eigen::Index i = 1; i <= n; ++i)
        for (Eigen::Index j = n; j >= i; --j) table[j] += table[j - 1];
    return table;
}

}  // namespace

double evaluate_polynomial(const Eigen::Ref<const Eigen::VectorXd>& coefficients, double t) {
    double value = 0.0;
    for (Eigen::Index m = coefficients.size() - 1; m >= 0; --m) value = value * t + coefficients[m];
    return value;
}

Eigen::VectorXd differentiated(const Eigen::Ref<const Eigen::VectorXd>& coefficients, int order) {
    Eigen::VectorXd derivative(std::max<Eigen::Index>(1, coefficients.size() - order));
    differentiate(coefficients, order, derivative);
    return derivative;
}

void differentiate(const Eigen::Ref<const Eigen::VectorXd>& coefficients, int order,
                   Eigen::Ref<Eigen::VectorXd> out) {
    out[0] = 0.0;
    for (Eigen::Index m = 0; m + order < coefficients.size(); ++m) {
        double value = coefficients[m + order];
        for (int r = 0; r < order; ++r) value *= static_cast<double>(m + order - r);
        out[m] = value;
    }
}

Eigen::VectorXd product(const Eigen::Ref<const Eigen::VectorXd>& left,
                        const Eigen::Ref<const Eigen::VectorXd>& right) {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(left.size() + right.size() - 1);
    for (Eigen::Index m = 0; m < left.size(); ++m) result.segment(m, right.size()) += left[m] * right;
    return result;
}

std::vector<double> sign_changes(const Eigen::Ref<const Eigen::VectorXd>& coefficients, double lower,
                                 double upper) {
    std::vector<double> changes;
    if (coefficients.size() <= 1) return changes;
    if (coefficients.size() == 2) {  // most calls return here
        const double a = evaluate_polynomial(coefficients, lower),
                     b = evaluate_polynomial(coefficients, upper);
        if (a * b < 0.0) changes.push_back(std::clamp(-coefficients[0] / coefficients[1], lower, upper));
        return changes;
    }
    std::vector<double> ends = sign_changes(differentiated(coefficients), lower, upper);
    ends.push_back(upper);
    double a = lower;
    double value_a = evaluate_polynomial(coefficients, a);
    for (const double b : ends) {
        const double value_b = evaluate_polynomial(coefficients, b);
        if (value_a * value_b < 0.0) changes.push_back(bracketed_root(coefficients, a, b));
        // An exact zero keeps the sign before it, so that a crossing through it is still found.
        if (value_b != 0.0) {
            a = b;
            value_a = value_b;
        }
    }
    return changes;
}

std::optional<Extremum> maximum_above(const Eigen::Ref<const Eigen::VectorXd>& coefficients, double floor) {
    const Bernstein range = bernstein(coefficients);
    if (!(range.maxCoeff() > floor)) return std::nullopt;
    Extremum best{coefficients[0], 0.0};
    const auto see = [&](double t) {
        const double value = evaluate_polynomial(coefficients, t);
        if (value > best.value) best = {value, t};
    };
    const auto is_sorted = [&](auto order) {
        return std::is_sorted(range.data(), range.data() + range.size(), order);
    };
    const bool monotone = is_sorted(std::less<>()) || is_sorted(std::greater<>());
    if (!monotone)
        for (const double t : sign_changes(differentiated(coefficients), 0.0, 1.0)) see(t);
    see(1.0);
    if (!(best.value > floor)) return std::nullopt;
    return best;
}

}  // namespace camopt
