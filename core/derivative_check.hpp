// SPDX-License-Identifier: MIT
// Checks gradient, Jacobian and Hessian of any Nlp against central differences of fourth order,
//
//     f'(x) ≈ (f(x-2h) - 8 f(x-h) + 8 f(x+h) - f(x+2h)) / 12h,   h = step max(1, |x_j|)
//
// (one-sided, of fourth order too, where a bound leaves no room). The gradient is compared with differences
// of the cost, the Jacobian with differences of the rows, the Hessian with differences of the gradient of the
// Lagrangian formed with the multipliers (sigma, lambda) = (0.7, ±[0.5, 1.5]), all different. Whole columns
// are differenced: an entry that is missing from a pattern is found too. An entry's error is |given −
// differenced| beyond the rounding of the differences, over max(1, |given|, |differenced|). Errors:
// InputError for a point of the wrong size or a step or tolerance that is not positive.
#pragma once

#include "core/nlp.hpp"

#include <Eigen/Core>

#include <span>
#include <string>
#include <vector>

namespace camopt {

struct DerivativeCheckOptions {
    double step = 1e-3;  ///< relative; near the fifth root of the rounding unit, where both errors are least
    double tolerance = 1e-6;  ///< on an entry's error; a wrong formula misses by far more
    int worst = 10;           ///< offending entries kept for each kind of derivative
    void validate() const;    ///< throws InputError
};

enum class DerivativeKind { gradient, jacobian, hessian };
[[nodiscard]] const char* name_of(DerivativeKind value);

struct DerivativeFault {
    DerivativeKind kind = DerivativeKind::gradient;
    int point = 0;         ///< which of the given points
    std::string row;       ///< row name; variable name for a Hessian; empty for a gradient
    std::string variable;  ///< by which was differentiated
    double given = 0.0, differenced = 0.0;
    double error = 0.0;
    bool in_pattern = true;  ///< false: the entry is not zero but missing from the pattern
};

struct DerivativeReport {
    std::vector<DerivativeFault> faults;  ///< errors above the tolerance, worst first
    double worst_error = 0.0;             ///< over all entries; infinity where a value is not finite
    long entries = 0;                     ///< compared
    [[nodiscard]] bool passed() const { return faults.empty(); }
};

[[nodiscard]] DerivativeReport check_derivatives(const Nlp& problem, std::span<const Eigen::VectorXd> points,
                                                 const DerivativeCheckOptions& options = {});

/// "jacobian of 'row3' by 'x1' at point 0: given 2, differenced 4, error 0.5"
[[nodiscard]] std::string describe(const DerivativeFault& fault);

}  // namespace camopt
