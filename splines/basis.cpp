// SPDX-License-Identifier: MIT
#include "splines/basis.hpp"

#include <algorithm>

namespace camopt {

namespace {

/// Local knots u_{1} … u_{2p} around a segment, measured from its left end: the B-splines on the segment
/// depend on no others.
Eigen::VectorXd local_knots(const SplineSpace& space, int segment) {
    const int p = space.degree();
    const int first = space.first_basis_function(segment);
    const double origin = space.breakpoints()[segment];
    Eigen::VectorXd local(2 * p);
    for (int k = 0; k < 2 * p; ++k) local[k] = space.knot(first + 1 + k) - origin;
    return local;
}

}  // namespace

Eigen::MatrixXd monomials_of_basis(const SplineSpace& space, int segment) {
    const int p = space.degree();
    const Eigen::VectorXd u = local_knots(space, segment);
    // Cox–de Boor on polynomials in t: row m of column j is the coefficient of t^m.
    Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(p + 1, p + 1);
    basis(0, 0) = 1.0;
    for (int d = 1; d <= p; ++d) {
        Eigen::MatrixXd raised = Eigen::MatrixXd::Zero(p + 1, p + 1);
        for (int j = 0; j < d; ++j) {
            // basis.col(j) of degree d − 1 spans from u_left to u_right in the next recurrence.
            const double left = u[p - d + j];
            const double right = u[p + j];
            const double span = right - left;
            for (int m = 0; m < d; ++m) {
                const double value = basis(m, j) / span;
                raised(m, j) += right * value;
                raised(m + 1, j) -= value;
                raised(m, j + 1) -= left * value;
                raised(m + 1, j + 1) += value;
            }
        }
        basis = raised;
    }
    return basis;
}

Eigen::RowVectorXd blossom_weights(const SplineSpace& space, int function, int segment) {
    const int p = space.degree();
    const Eigen::VectorXd u = local_knots(space, segment);
    const int offset = function - space.first_basis_function(segment);
    // Elementary symmetric sums of the p knots inside the support of the function.
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(p + 1);
    sums[0] = 1.0;
    for (int k = 0; k < p; ++k) {
        for (int m = std::min(k + 1, p); m >= 1; --m) sums[m] += u[offset + k] * sums[m - 1];
    }
    Eigen::RowVectorXd weights(p + 1);
    double binomial = 1.0;
    for (int m = 0; m <= p; ++m) {
        weights[m] = sums[m] / binomial;
        binomial = binomial * (p - m) / (m + 1);
    }
    return weights;
}

}  // namespace camopt
