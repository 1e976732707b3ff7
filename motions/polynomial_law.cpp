// SPDX-License-Identifier: MIT
#include "motions/polynomial_law.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace camopt {

PolynomialLaw::PolynomialLaw(LawInfo info, std::vector<double> coefficients)
    : Law(std::move(info)), coefficients_(std::move(coefficients)) {
    const double middle = evaluate(0.5, Side::left)[0];
    if (!(std::abs(middle - 0.5) <= 1e-14)) {
        throw ModelError(fmt::format("{}: y(1/2) = {}, not 1/2", key(), middle));
    }
}

LawDerivatives PolynomialLaw::evaluate(double x, Side /*side*/) const {
    const bool upper = x > 0.5;
    const double t = upper ? 1.0 - x : x;
    // Horner's rule for the polynomial and its derivatives over r!, all at once.
    LawDerivatives y{};
    for (std::size_t m = coefficients_.size(); m-- > 0;) {
        for (std::size_t r = y.size() - 1; r > 0; --r) y[r] = y[r] * t + y[r - 1];
        y[0] = y[0] * t + coefficients_[m];
    }
    y[2] *= 2.0;
    y[3] *= 6.0;
    y[4] *= 24.0;
    if (!upper) return y;
    return {1.0 - y[0], y[1], -y[2], y[3], -y[4]};
}

}  // namespace camopt
