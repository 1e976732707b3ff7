// SPDX-License-Identifier: MIT
// Conversion between B-splines and local polynomials.
//
// On segment i with t = x − x_i a spline is Σ_m a_m t^m and also Σ_j c_j N_j(x) over the degree + 1 basis
// functions with support there, j = first_basis_function(i) … + degree. Source: de Boor, A Practical Guide to
// Splines (recurrence, blossom); nothing here is specific to a degree.
#pragma once

#include "splines/space.hpp"

#include <Eigen/Core>

namespace camopt {

/// M, (degree + 1) x (degree + 1), with a = M c on this segment: column j holds N_j^{(m)}(x_i+) / m!.
[[nodiscard]] Eigen::MatrixXd monomials_of_basis(const SplineSpace& space, int segment);

/// w with c_j = wᵀ a: the blossom of t^m at the knots of basis function j, for a segment in its support.
[[nodiscard]] Eigen::RowVectorXd blossom_weights(const SplineSpace& space, int function, int segment);

}  // namespace camopt
