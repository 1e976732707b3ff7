// SPDX-License-Identifier: MIT
// Polynomials in one variable, p(t) = Σ_m c_m t^m: coefficients ascending, as Eigen vectors of size >= 1.
#pragma once

#include "core/numbers/extremum.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace camopt {

[[nodiscard]] double evaluate_polynomial(const Eigen::Ref<const Eigen::VectorXd>& coefficients, double t);

/// p'; the zero polynomial for a constant.
[[nodiscard]] Eigen::VectorXd differentiated(const Eigen::Ref<const Eigen::VectorXd>& coefficients);

[[nodiscard]] Eigen::VectorXd product(const Eigen::Ref<const Eigen::VectorXd>& left,
                                      const Eigen::Ref<const Eigen::VectorXd>& right);

/// Every sign change t of p in (lower, upper), ascending, to round-off. Found between the sign changes of p'
/// (recursively), so none is missed; a root where p only touches zero is not a sign change.
[[nodiscard]] std::vector<double> sign_changes(const Eigen::Ref<const Eigen::VectorXd>& coefficients,
                                               double lower, double upper);

/// The largest value on [0, 1] and its first location, to round-off; nullopt where the polynomial does not
/// exceed `floor`, which the Bernstein coefficients usually prove without a root. At most 28 coefficients.
[[nodiscard]] std::optional<Extremum> maximum_above(const Eigen::Ref<const Eigen::VectorXd>& coefficients,
                                                    double floor);

}  // namespace camopt
