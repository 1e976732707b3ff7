// SPDX-License-Identifier: MIT
#include "motions/laws/polynomial_law.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace camopt {

namespace {

/// How far the two expansions may differ at x = 1/2, as a part of the sum of the coefficients' magnitudes
/// times the derivative's growth with the degree: rounding of Horner's rule is some 1e-15 of that.
constexpr double kMeeting = 1e-13;

std::vector<double> mirrored(std::vector<double> coefficients) {
    for (double& coefficient : coefficients) coefficient = -coefficient;
    if (!coefficients.empty()) coefficients[0] += 1.0;
    return coefficients;
}

/// Horner's rule for a polynomial and its derivatives over r!, all at once.
template <class T>
std::array<T, 5> horner(const std::vector<double>& coefficients, const T& t) {
    std::array<T, 5> y{};
    for (std::size_t m = coefficients.size(); m-- > 0;) {
        for (std::size_t r = y.size() - 1; r > 0; --r) y[r] = y[r] * t + y[r - 1];
        y[0] = y[0] * t + T(coefficients[m]);
    }
    double factorial = 1.0;
    for (std::size_t r = 2; r < y.size(); ++r) y[r] = T(factorial *= static_cast<double>(r)) * y[r];
    return y;
}

template <class T>
std::array<T, 5> horner_from_top(const std::vector<double>& coefficients, const T& x) {
    std::array<T, 5> y = horner(coefficients, T(1.0) - x);
    y[1] = -y[1];
    y[3] = -y[3];
    return y;
}

}  // namespace

PolynomialLaw::PolynomialLaw(LawInfo info, const std::vector<double>& from_below)
    : PolynomialLaw(std::move(info), from_below, mirrored(from_below)) {}

PolynomialLaw::PolynomialLaw(LawInfo info, std::vector<double> from_below, std::vector<double> from_top)
    : Law(std::move(info)), from_below_(std::move(from_below)), from_top_(std::move(from_top)) {
    const LawDerivatives below = horner(from_below_, 0.5), top = horner_from_top(from_top_, 0.5);
    double scale = 1.0;
    for (const double coefficient : from_below_) scale += std::abs(coefficient);
    for (std::size_t r = 0; r < below.size(); ++r) {
        if (!(std::abs(below[r] - top[r]) <= kMeeting * scale)) {
            throw ModelError(fmt::format("{}: derivative {} at x = 1/2 is {} from below and {} from the top",
                                         key(), r, below[r], top[r]));
        }
        scale *= static_cast<double>(from_below_.size());
    }
}

LawDerivatives PolynomialLaw::evaluate(double x, Side /*side*/) const {
    return x > 0.5 ? horner_from_top(from_top_, x) : horner(from_below_, x);
}

std::optional<std::array<Interval, 5>> PolynomialLaw::ranges(const Interval& x) const {
    return 0.5 * (x.lower + x.upper) > 0.5 ? horner_from_top(from_top_, x) : horner(from_below_, x);
}

}  // namespace camopt
