// SPDX-License-Identifier: MIT
// Affine functions of a design vector x: values of a spline, and its local polynomials.
#pragma once

#include "core/base/standard.hpp"

#include <Eigen/Core>

namespace camopt {

/// value(x) = offset + Σ_k weights_k x[columns_k].
struct AffineRow {
    double offset = 0.0;
    std::vector<int> columns;  ///< ascending, without duplicates
    std::vector<double> weights;

    [[nodiscard]] double value(const Eigen::VectorXd& x) const;
};

/// this + factor · other, columns merged.
[[nodiscard]] AffineRow combined(const AffineRow& row, double factor, const AffineRow& other);

struct Equality {
    AffineRow row;  ///< must be 0
    std::string name;
    /// Of the value at x of size 1, by round-off of the row; relative to its largest weight.
    double uncertainty = 0.0;
};

/// One local polynomial as an affine map of x.
struct LocalMap {
    std::vector<int> columns;
    Eigen::MatrixXd matrix;  ///< (degree + 1) x columns
    Eigen::VectorXd offset;  ///< degree + 1

    /// offset + matrix · x[columns], summed in more than double precision: on a segment of width h the
    /// displacements of its ends, nearly equal, have weights of 1/h³ and more.
    [[nodiscard]] Eigen::VectorXd polynomial(const Eigen::VectorXd& x) const;
};

/// The derivative of `order` at t of the local polynomial, as a row over its columns.
[[nodiscard]] AffineRow functional_of(const LocalMap& map, double t, int order);

}  // namespace camopt
