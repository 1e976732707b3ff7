// SPDX-License-Identifier: MIT
// Antisymmetric polynomial laws: y(x) = Σ coefficients[k] x^k on [0, 1] with y(x) + y(1 - x) = 1.
//
// The upper half is taken from the lower one by the symmetry, so no digits are lost near x = 1. No units.
// Errors: coefficients whose y(1/2) is not 1/2 throw ModelError.
#pragma once

#include "motions/law.hpp"

#include <vector>

namespace camopt {

class PolynomialLaw : public Law {
 public:
    PolynomialLaw(LawInfo info, std::vector<double> coefficients);

    [[nodiscard]] std::vector<double> breakpoints() const override { return {0.0, 1.0}; }

 private:
    [[nodiscard]] LawDerivatives evaluate(double x, Side side) const override;

    std::vector<double> coefficients_;
};

}  // namespace camopt
