// SPDX-License-Identifier: MIT
#include "tests/soak/known/piecewise_space.hpp"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>

namespace camopt::soak {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double same_row = 1e-11;  // below it rows are the same but for rounding

/// Bernstein polynomials of a degree at t, by de Casteljau's recursion: no cancellation.
VectorXd bernstein(int degree, double t) {
    VectorXd values = VectorXd::Zero(degree + 1);
    values[0] = 1.0;
    for (int d = 1; d <= degree; ++d) {
        for (int k = d; k > 0; --k) values[k] = (1.0 - t) * values[k] + t * values[k - 1];
        values[0] *= 1.0 - t;
    }
    return values;
}

/// Of one piece of a width: the row of the derivative of this order at t.
VectorXd derivative_row(int degree, int order, double width, double t) {
    if (order > degree) return VectorXd::Zero(degree + 1);
    VectorXd row = bernstein(degree - order, t);
    for (int d = degree - order + 1; d <= degree; ++d) {  // the derivative of degree d is that of differences
        VectorXd longer = VectorXd::Zero(d + 1);
        longer.head(d) -= row;
        longer.tail(d) += row;
        row = longer * (d / width);
    }
    return row;
}

/// Gauss–Legendre with eight points, exact to degree 15: (y'')² of degree 7 has degree 10.
constexpr std::array<double, 8> nodes = {-0.9602898564975363, -0.7966664774136267, -0.5255324099163290,
                                         -0.1834346424956498, 0.1834346424956498,  0.5255324099163290,
                                         0.7966664774136267,  0.9602898564975363};
constexpr std::array<double, 8> node_weights = {0.1012285362903763, 0.2223810344533745, 0.3137066458778873,
                                                0.3626837833783620, 0.3626837833783620, 0.3137066458778873,
                                                0.2223810344533745, 0.1012285362903763};

}  // namespace

Combination derivative_alone(int order) {
    Combination weights{};
    weights[static_cast<std::size_t>(order)] = 1.0;
    return weights;
}

int PiecewiseSpace::add_run(const std::vector<double>& breakpoints, int continuity) {
    const int first = pieces();
    for (std::size_t k = 0; k + 1 < breakpoints.size(); ++k) {
        begins_.push_back(breakpoints[k]);
        ends_.push_back(breakpoints[k + 1]);
        if (k > 0) join(pieces() - 2, pieces() - 1, continuity);
    }
    return first;
}

void PiecewiseSpace::join(int left, int right, int continuity) {
    joins_.push_back({left, right, continuity});
}

void PiecewiseSpace::fix_begin(int piece, int order, double value) {
    fixed_.push_back({piece, begin(piece), order, value});
}

void PiecewiseSpace::fix_end(int piece, int order, double value) {
    fixed_.push_back({piece, end(piece), order, value});
}

void PiecewiseSpace::fix(double x, int order, double value) {
    fixed_.push_back({piece_of(x), x, order, value});
}

void PiecewiseSpace::reflect(bool odd) {
    reflection_ = odd ? 1 : 2;
}

int PiecewiseSpace::piece_of(double x) const {
    for (int piece = 0; piece < pieces(); ++piece)
        if (x < end(piece)) return piece;
    return pieces() - 1;
}

VectorXd PiecewiseSpace::row(const Combination& weights, int piece, double x) const {
    VectorXd all = VectorXd::Zero(size());
    const double t = std::clamp((x - begin(piece)) / width(piece), 0.0, 1.0);
    for (int order = 0; order < static_cast<int>(weights.size()); ++order) {
        const double weight = weights[static_cast<std::size_t>(order)];
        if (weight == 0.0) continue;
        all.segment(static_cast<Index>(piece) * (degree_ + 1), degree_ + 1) +=
            weight * derivative_row(degree_, order, width(piece), t);
    }
    return all;
}

template <class Visit>
void PiecewiseSpace::visit_nodes(int piece, Visit&& visit) const {
    for (std::size_t k = 0; k < nodes.size(); ++k)
        visit(begin(piece) + width(piece) * (0.5 + 0.5 * nodes[k]), 0.5 * width(piece) * node_weights[k]);
}

VectorXd PiecewiseSpace::integral() const {
    VectorXd all(size());
    for (int piece = 0; piece < pieces(); ++piece)
        all.segment(static_cast<Index>(piece) * (degree_ + 1), degree_ + 1)
            .setConstant(width(piece) / (degree_ + 1));
    return all;
}

void PiecewiseSpace::add_square(const VectorXd& motion, const Combination& weights, double constant,
                                int first, int count, Square& sum) const {
    for (int piece = first; piece < first + count; ++piece)
        visit_nodes(piece, [&](double x, double weight) {
            const VectorXd own = row(weights, piece, x);
            const double value = own.dot(motion) + constant;
            sum.value += weight * value * value;
            sum.slope += weight * value * own;
        });
}

MatrixXd PiecewiseSpace::jerk_form() const {
    MatrixXd form = MatrixXd::Zero(size(), size());
    for (int piece = 0; piece < pieces(); ++piece)
        visit_nodes(piece, [&](double x, double weight) {
            const Index at = static_cast<Index>(piece) * (degree_ + 1);
            const VectorXd own = row(derivative_alone(3), piece, x).segment(at, degree_ + 1);
            form.block(at, at, degree_ + 1, degree_ + 1) += weight * own * own.transpose();
        });
    return form;
}

void PiecewiseSpace::require(const VectorXd& row, double value, double growth) {
    const double size = row.lpNorm<Eigen::Infinity>();
    if (size == 0.0) return;
    conditions_.push_back({row / size, value / size, growth});
}

bool PiecewiseSpace::close() {
    conditions_.clear();
    for (const Join& one : joins_)
        for (int order = 0; order <= one.continuity; ++order) {
            const Combination weights = derivative_alone(order);
            const double narrow = std::min(width(one.left), width(one.right));
            require(row(weights, one.left, end(one.left)) - row(weights, one.right, begin(one.right)), 0.0,
                    1.0 + order * std::abs(end(one.left)) / narrow);
        }
    for (const Fixed& one : fixed_)
        require(row(derivative_alone(one.order), one.piece, one.x), one.value,
                1.0 + (one.order + 1) * std::abs(one.x) / width(one.piece));
    if (reflection_ != 0) {
        const double sign = reflection_ == 1 ? 1.0 : -1.0;
        for (Index k = 0; k < size() / 2; ++k) {
            VectorXd mirrored = VectorXd::Zero(size());
            mirrored[k] = 1.0;
            mirrored[size() - 1 - k] += sign;
            require(mirrored, reflection_ == 1 ? 1.0 : 0.0, 1.0);
        }
    }
    equations_.resize(static_cast<Index>(conditions_.size()), size());
    VectorXd values(static_cast<Index>(conditions_.size()));
    for (std::size_t k = 0; k < conditions_.size(); ++k) {
        equations_.row(static_cast<Index>(k)) = conditions_[k].row.transpose();
        values[static_cast<Index>(k)] = conditions_[k].value;
    }
    Eigen::ColPivHouseholderQR<MatrixXd> factor(equations_.transpose());
    factor.setThreshold(same_row);
    const Index rank = factor.rank();
    least_pivot_ = std::abs(factor.matrixQR()(rank - 1, rank - 1));
    MatrixXd basis = MatrixXd::Identity(size(), size());
    basis.applyOnTheLeft(factor.householderQ());
    directions_ = basis.rightCols(size() - rank);
    // E = P R' Q': the coefficients in the range of E' by forward substitution, and once more for the rest.
    const MatrixXd range = basis.leftCols(rank);
    const MatrixXd reduced = equations_ * range;
    const Eigen::ColPivHouseholderQR<MatrixXd> solver(reduced);
    VectorXd particular = range * solver.solve(values);
    particular += range * solver.solve(values - equations_ * particular);
    if ((values - equations_ * particular).lpNorm<Eigen::Infinity>() > 1e-10) return false;
    const MatrixXd gram = jerk_form();
    const MatrixXd own = directions_.transpose() * gram * directions_;
    if (freedom() > 0)
        smoothest_ =
            particular - directions_ * own.ldlt().solve(directions_.transpose() * (gram * particular));
    else
        smoothest_ = particular;
    smoothest_ += range * solver.solve(values - equations_ * smoothest_);
    return smoothest_.allFinite();
}

Polynomial PiecewiseSpace::polynomial(const VectorXd& motion, const Combination& weights, int piece) const {
    const double h = width(piece);
    // y = Σ C(p, k) Δᵏc₀ tᵏ.
    std::vector<long double> differences;
    for (int k = 0; k <= degree_; ++k)
        differences.push_back(motion[static_cast<Index>(piece) * (degree_ + 1) + k]);
    Polynomial y;
    long double binomial = 1.0L;
    for (int k = 0; k <= degree_; ++k) {
        y.push_back(binomial * differences[0]);
        for (int j = 0; j < degree_ - k; ++j)
            differences[static_cast<std::size_t>(j)] =
                differences[static_cast<std::size_t>(j) + 1] - differences[static_cast<std::size_t>(j)];
        binomial = binomial * (degree_ - k) / (k + 1);
    }
    Polynomial sum(static_cast<std::size_t>(degree_) + 1, 0.0L);
    long double scale = 1.0L;
    for (int order = 0; order < static_cast<int>(weights.size()) && order <= degree_; ++order) {
        for (std::size_t k = 0; k < y.size(); ++k)
            sum[k] += scale * static_cast<long double>(weights[static_cast<std::size_t>(order)]) * y[k];
        y = derivative_of(y);
        scale /= h;
    }
    return sum;
}

std::vector<Extreme> PiecewiseSpace::extremes(const VectorXd& motion, const Combination& weights, int piece,
                                              double low, double high) const {
    const double a = begin(piece), h = width(piece);
    Polynomial sum = polynomial(motion, weights, piece);
    int lowest = 0;
    while (lowest <= degree_ && weights[static_cast<std::size_t>(lowest)] == 0.0) ++lowest;
    std::vector<double> places = {low, high};
    if (lowest >= degree_) {  // constant along the piece: its middle says all
        places = {0.5 * (low + high)};
    } else {
        sum.resize(static_cast<std::size_t>(degree_ - lowest) + 1);
        const long double from = (low - a) / h, to = (high - a) / h;
        for (const long double t : roots_within(derivative_of(sum), from, to))
            places.push_back(std::clamp(a + h * static_cast<double>(t), low, high));
    }
    std::vector<Extreme> found;
    for (const double x : places) found.push_back({x, piece, row(weights, piece, x).dot(motion)});
    return found;
}

double PiecewiseSpace::sensitivity(const VectorXd& v, const VectorXd& motion) const {
    const Eigen::ColPivHouseholderQR<MatrixXd> factor(equations_.transpose());
    const VectorXd multipliers = factor.solve(v);
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    double sum = 0.0;
    for (std::size_t k = 0; k < conditions_.size(); ++k) {
        const Condition& condition = conditions_[k];
        const double terms = condition.row.cwiseAbs().dot(motion.cwiseAbs());
        // At rest all terms are small, and what the motion leaves of the condition is rounding of others.
        const double left = std::abs(condition.row.dot(motion) - condition.value) / rounding;
        sum += std::abs(multipliers[static_cast<Index>(k)]) * (terms * condition.growth + left);
    }
    return sum;
}

double PiecewiseSpace::drift(const VectorXd& motion) const {
    VectorXd change(static_cast<Index>(conditions_.size()));
    for (std::size_t k = 0; k < conditions_.size(); ++k)
        change[static_cast<Index>(k)] =
            conditions_[k].row.cwiseAbs().dot(motion.cwiseAbs()) * conditions_[k].growth;
    return change.norm() * std::sqrt(static_cast<double>(size())) / least_pivot_;
}

VectorXd PiecewiseSpace::correction(const VectorXd& motion) const {
    VectorXd left(static_cast<Index>(conditions_.size()));
    for (std::size_t k = 0; k < conditions_.size(); ++k) {
        // What is left is rounding of the terms: double would add as much.
        const auto terms = conditions_[k].row.cast<long double>().cwiseProduct(motion.cast<long double>());
        left[static_cast<Index>(k)] = static_cast<double>(conditions_[k].value - terms.sum());
    }
    Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor(equations_);
    factor.setThreshold(same_row);
    return factor.solve(left);
}

}  // namespace camopt::soak
