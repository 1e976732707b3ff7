// SPDX-License-Identifier: MIT
#include "splines/curve.hpp"

#include "core/errors.hpp"
#include "core/numbers/polynomial.hpp"
#include "splines/basis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace camopt {

namespace {

/// Amplification of a piece's round-off in a control point: coefficients of t^m are accurate to 1/h^m of
/// their last digit.
double growth(const Eigen::RowVectorXd& weights, double width) {
    double sum = 0.0, power = 1.0;
    for (Eigen::Index m = 0; m < weights.size(); ++m, power /= width) sum += std::abs(weights[m]) * power;
    return sum;
}

}  // namespace

SplineCurve::SplineCurve(SplineSpace space, Eigen::MatrixXd pieces)
    : space_(std::move(space)), pieces_(std::move(pieces)) {
    if (pieces_.rows() != degree() + 1 || pieces_.cols() != space_.segments()) {
        throw InputError(fmt::format("pieces: found {} x {}; allowed: {} x {}", pieces_.rows(),
                                     pieces_.cols(), degree() + 1, space_.segments()));
    }
    if (!pieces_.allFinite()) throw InputError("pieces: found a value that is not finite");
}

SplineCurve SplineCurve::from_coefficients(const SplineSpace& space, const Eigen::VectorXd& coefficients) {
    if (coefficients.size() != space.dimension()) {
        throw InputError(
            fmt::format("coefficients: found {}; allowed: {}", coefficients.size(), space.dimension()));
    }
    const int p = space.degree();
    Eigen::MatrixXd pieces(p + 1, space.segments());
    for (int i = 0; i < space.segments(); ++i) {
        pieces.col(i) =
            monomials_of_basis(space, i) * coefficients.segment(space.first_basis_function(i), p + 1);
    }
    return {space, std::move(pieces)};
}

MotionPoint SplineCurve::at(double x, Side side) const {
    const int segment = space_.segment_of(x, side);
    const double t = x - space_.breakpoints()[segment];
    MotionPoint point{x, {}};
    const Eigen::Index size = pieces_.rows();
    const double* const piece = pieces_.col(segment).data();
    for (Eigen::Index order = 0; order < 4; ++order) {
        double value = 0.0;
        for (Eigen::Index m = size - 1; m >= order; --m) {
            double coefficient = piece[m];
            for (Eigen::Index r = 0; r < order; ++r) coefficient *= static_cast<double>(m - r);
            value = value * t + coefficient;
        }
        point.derivative[static_cast<std::size_t>(order)] = value;
    }
    return point;
}

double SplineCurve::derivative(double x, int order, Side side) const {
    const int segment = space_.segment_of(x, side);
    return evaluate_polynomial(derivative_polynomial(segment, order), x - space_.breakpoints()[segment]);
}

Eigen::VectorXd SplineCurve::derivative_polynomial(int segment, int order) const {
    Eigen::VectorXd polynomial(std::max<Eigen::Index>(1, pieces_.rows() - order));
    derivative_polynomial(segment, order, polynomial);
    return polynomial;
}

void SplineCurve::derivative_polynomial(int segment, int order, Eigen::Ref<Eigen::VectorXd> out) const {
    out[0] = 0.0;
    for (Eigen::Index m = 0; m + order < pieces_.rows(); ++m) {
        double value = pieces_(m + order, segment);
        for (int r = 0; r < order; ++r) value *= static_cast<double>(m + order - r);
        out[m] = value;
    }
}

Eigen::VectorXd SplineCurve::coefficients() const {
    const int p = degree();
    const int step = p - continuity();
    Eigen::VectorXd result(space_.dimension());
    for (int j = 0; j < result.size(); ++j) {
        // Any segment of the support gives the same number, but not the same round-off: seen from a narrow
        // one the knots of the others are distant.
        const int last = std::min(j / step, space_.segments() - 1);
        const int first = j <= p ? 0 : (j - p + step - 1) / step;
        double least = std::numeric_limits<double>::infinity();
        for (int i = first; i <= last; ++i) {
            const Eigen::RowVectorXd weights = blossom_weights(space_, j, i);
            const double grown = growth(weights, space_.width(i));
            if (!(grown < least)) continue;
            least = grown;
            result[j] = weights * pieces_.col(i);
        }
    }
    return result;
}

}  // namespace camopt
