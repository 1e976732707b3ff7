// SPDX-License-Identifier: MIT
#include "benchmarks/outside/camshape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt::benchmarks {

namespace {

constexpr double least_radius = 1.0, largest_radius = 2.0, steepest = 1.5;

/// Of an entry, appended where the pattern has none yet. The neighbours are near the end.
int entry_of(SparsityPattern& pattern, int row, int column) {
    for (int k = pattern.size(); k-- > 0;)
        if (pattern.rows[static_cast<std::size_t>(k)] == row &&
            pattern.columns[static_cast<std::size_t>(k)] == column)
            return k;
    pattern.rows.push_back(row);
    pattern.columns.push_back(column);
    return pattern.size() - 1;
}

}  // namespace

Camshape::Camshape(int radii) : radii_(radii), step_(2.0 * std::numbers::pi / (5.0 * (radii + 1))) {
    shape_.x_lower = Eigen::VectorXd::Constant(radii, least_radius);
    shape_.x_upper = Eigen::VectorXd::Constant(radii, largest_radius);
    const int convexity = radii + 2, slopes = radii + 1;
    shape_.g_lower.setZero(convexity + slopes);
    shape_.g_upper.setConstant(convexity + slopes, infinity);
    shape_.rows.resize(static_cast<std::size_t>(convexity + slopes));
    shape_.linear_cost = shape_.quadratic_cost = true;
    add_convexity();
    add_slopes();
}

int Camshape::variable_of(int radius) const {
    if (radius == radii_ + 2) return radii_ - 1;
    return radius >= 1 && radius <= radii_ ? radius - 1 : -1;
}

double Camshape::radius(const ConstVectorRef& x, int index) const {
    const int variable = variable_of(index);
    if (variable >= 0) return x[variable];
    return index <= 0 ? least_radius : largest_radius;
}

int Camshape::jacobian_entry(int row, int variable) {
    return variable < 0 ? -1 : entry_of(shape_.jacobian, row, variable);
}

int Camshape::hessian_entry(int one, int other) {
    return one < 0 || other < 0 ? -1 : entry_of(shape_.hessian, std::max(one, other), std::min(one, other));
}

void Camshape::add_convexity() {
    const double scale = 1.0 / (step_ * step_);
    for (int i = 0; i <= radii_ + 1; ++i) {
        shape_.rows[static_cast<std::size_t>(i)].linear = false;
        for (const auto& [factor, first, second] : {std::tuple{scale, i - 1, i},
                                                    {scale, i, i + 1},
                                                    {-2.0 * scale * std::cos(step_), i - 1, i + 1}}) {
            const int one = variable_of(first), other = variable_of(second);
            products_.push_back({i, factor, first, second, jacobian_entry(i, one), jacobian_entry(i, other),
                                 hessian_entry(one, other)});
        }
    }
}

void Camshape::add_slopes() {
    for (int i = 0; i <= radii_; ++i) {
        const int row = radii_ + 2 + i;
        shape_.g_lower[row] = -steepest * step_;
        shape_.g_upper[row] = steepest * step_;
        for (const int one : {i, i + 1}) (void)jacobian_entry(row, variable_of(one));
        // A given radius goes to the other side.
        const double given = (i == radii_ ? largest_radius : 0.0) - (i == 0 ? least_radius : 0.0);
        shape_.g_lower[row] -= given;
        shape_.g_upper[row] -= given;
    }
}

Eigen::VectorXd Camshape::straight_line() const {
    Eigen::VectorXd x(radii_);
    for (int i = 0; i < radii_; ++i)
        x[i] = least_radius + (largest_radius - least_radius) * (i + 1) / (radii_ + 1);
    return x;
}

double Camshape::cost(const ConstVectorRef& x) const {
    return -std::numbers::pi / radii_ * x.sum();
}

void Camshape::gradient(const ConstVectorRef& /*x*/, VectorRef out) const {
    out.setConstant(-std::numbers::pi / radii_);
}

void Camshape::constraints(const ConstVectorRef& x, VectorRef out) const {
    out.setZero();
    for (const Product& one : products_)
        out[one.row] += one.factor * radius(x, one.first) * radius(x, one.second);
    for (int i = 0; i <= radii_; ++i) {
        const double upper = i < radii_ ? x[i] : 0.0, lower = i > 0 ? x[i - 1] : 0.0;
        out[radii_ + 2 + i] = upper - lower;
    }
}

void Camshape::jacobian(const ConstVectorRef& x, std::span<double> out) const {
    std::ranges::fill(out, 0.0);
    for (const Product& one : products_) {
        if (one.by_first >= 0)
            out[static_cast<std::size_t>(one.by_first)] += one.factor * radius(x, one.second);
        if (one.by_second >= 0)
            out[static_cast<std::size_t>(one.by_second)] += one.factor * radius(x, one.first);
    }
    for (std::size_t k = 0; k < out.size(); ++k) {
        const int i = shape_.jacobian.rows[k] - (radii_ + 2);
        if (i >= 0) out[k] = shape_.jacobian.columns[k] == i ? 1.0 : -1.0;
    }
}

void Camshape::hessian(const ConstVectorRef& /*x*/, double /*sigma*/, const ConstVectorRef& lambda,
                       std::span<double> out) const {
    std::ranges::fill(out, 0.0);
    for (const Product& one : products_) {
        if (one.by_both < 0) continue;
        const bool square = variable_of(one.first) == variable_of(one.second);
        out[static_cast<std::size_t>(one.by_both)] += (square ? 2.0 : 1.0) * one.factor * lambda[one.row];
    }
}

std::string Camshape::variable_name(int index) const {
    return fmt::format("r{}", index + 1);
}

std::string Camshape::row_name(int index) const {
    return index < radii_ + 2 ? fmt::format("convex {}", index) : fmt::format("slope {}", index - radii_ - 2);
}

const std::vector<CamshapeOptimum>& camshape_optima() {
    static const std::vector<CamshapeOptimum> optima = {{100, -4.28414712174675},
                                                        {200, -4.27850023299273},
                                                        {400, -4.27568847892555},
                                                        {800, -4.27427414195420}};
    return optima;
}

double violation_of(const Nlp& problem, const Eigen::VectorXd& x) {
    const NlpShape& shape = problem.shape();
    Eigen::VectorXd rows(shape.constraints());
    problem.constraints(x, rows);
    double worst = 0.0;
    for (const double one : {(shape.x_lower - x).maxCoeff(), (x - shape.x_upper).maxCoeff(),
                             (shape.g_lower - rows).maxCoeff(), (rows - shape.g_upper).maxCoeff()})
        worst = std::max(worst, one);
    return worst;
}

}  // namespace camopt::benchmarks
