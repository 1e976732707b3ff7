// SPDX-License-Identifier: MIT
// Polynomial laws. The lower half is expanded about x = 0 and the upper one about x = 1, so no digits are
// lost at either end:
//
//   y(x) = Σ from_below[k] x^k on [0, 1/2],   y(x) = Σ from_top[k] (1 - x)^k on [1/2, 1].
//
// Both are the same polynomial; an antisymmetric one, y(x) + y(1 - x) = 1, is given by from_below alone.
// No units. Errors: expansions that do not meet at x = 1/2 in y … y'''' throw ModelError.
#pragma once

#include "motions/laws/law.hpp"

#include <vector>

namespace camopt {

class PolynomialLaw : public Law {
 public:
    /// Antisymmetric.
    PolynomialLaw(LawInfo info, const std::vector<double>& from_below);
    PolynomialLaw(LawInfo info, std::vector<double> from_below, std::vector<double> from_top);

    [[nodiscard]] std::vector<double> breakpoints() const override { return {0.0, 1.0}; }
    [[nodiscard]] std::optional<std::array<Interval, 5>> ranges(const Interval& x) const override;

 private:
    [[nodiscard]] LawDerivatives evaluate(double x, Side side) const override;

    std::vector<double> from_below_, from_top_;
};

}  // namespace camopt
