// SPDX-License-Identifier: MIT
// Energies of a spline as exact quadratic forms of its design vector.
//
//   (1/L) ∫ (y^{(r)})² dx = xᵀ Q x + 2 bᵀ x + c,   L = end − begin,
// by integrating the local polynomials in closed form, so without quadrature error.
#pragma once

#include "splines/design_vector.hpp"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace camopt {

struct QuadraticForm {
    Eigen::SparseMatrix<double> matrix;  ///< Q, symmetric, both triangles
    Eigen::VectorXd linear;              ///< b
    double constant = 0.0;               ///< c
    [[nodiscard]] double value(const Eigen::VectorXd& x) const {
        return x.dot(matrix * x) + 2.0 * linear.dot(x) + constant;
    }
};

/// Adds weight · ∫_0^width (y^{(order)})² dt of one local polynomial to a form whose matrix is still
/// triplets.
void add_energy(const LocalMap& map, int order, double width, double weight, QuadraticForm& form,
                std::vector<Eigen::Triplet<double>>& entries);

/// Mean square of the derivative of `order` (0 … degree) over the whole spline.
[[nodiscard]] QuadraticForm mean_square_form(const DesignVector& design, int order);

}  // namespace camopt
