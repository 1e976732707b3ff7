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

#include "core/errors.hpp"
#include "core/nlp.hpp"
#include "core/word_of.hpp"

#include <fmt/format.h>

#include <map>

namespace camopt {

struct DerivativeCheckOptions {
    double step = 1e-3;  ///< relative; near the fifth root of the rounding unit, where both errors are least
    double tolerance = 1e-6;  ///< on an entry's error; a wrong formula misses by far more
    int worst = 10;           ///< offending entries kept for each kind of derivative
    void validate() const;    ///< throws InputError
};

enum class DerivativeKind { gradient, jacobian, hessian };

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

namespace derivative_check {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double sigma = 0.7;

/// Weights of an evaluation at x + offset h; the sum over the stencil, over h, is the derivative.
struct Node {
    double offset, weight;
};
using Stencil = std::array<Node, 5>;
constexpr Stencil central{{{-2, 1.0 / 12}, {-1, -8.0 / 12}, {0, 0}, {1, 8.0 / 12}, {2, -1.0 / 12}}};
constexpr Stencil forward{{{0, -25.0 / 12}, {1, 4}, {2, -3}, {3, 4.0 / 3}, {4, -0.25}}};

struct Column {
    VectorXd derivative, rounding;
};

using Function = std::function<VectorXd(const VectorXd&)>;

/// The derivative of all components by variable j.
inline Column differenced(const Function& function, const NlpShape& shape, VectorXd x, int j,
                          double relative_step) {
    const double origin = x[j];
    double step = relative_step * std::max(1.0, std::abs(origin));
    const double below = origin - shape.x_lower[j], above = shape.x_upper[j] - origin;
    const bool fixed = !(shape.x_upper[j] > shape.x_lower[j]);
    const bool one_sided = !fixed && std::min(below, above) < 2.0 * step;
    if (one_sided && std::max(below, above) < 4.0 * step) step = std::max(below, above) / 4.0;
    if (one_sided && below > above) step = -step;
    Column column;
    double largest_weight = 0.0;
    for (const Node& node : one_sided ? forward : central) {
        if (node.weight == 0.0) continue;
        x[j] = origin + node.offset * step;
        const VectorXd value = function(x);
        if (column.derivative.size() == 0) column.derivative = column.rounding = VectorXd::Zero(value.size());
        column.derivative += node.weight * value;
        column.rounding = column.rounding.cwiseMax(value.cwiseAbs());
        largest_weight = std::max(largest_weight, std::abs(node.weight));
    }
    column.derivative /= step;
    // A value is assumed correct to some units in its last place.
    constexpr double value_error = 16.0 * std::numeric_limits<double>::epsilon();
    column.rounding *= value_error * largest_weight / std::abs(step);
    return column;
}

inline VectorXd multipliers(int rows) {
    VectorXd lambda(rows);
    for (int i = 0; i < rows; ++i)
        lambda[i] = (i % 2 ? -1.0 : 1.0) * (0.5 + std::fmod(0.6180339887 * (i + 1), 1.0));
    return lambda;
}

inline VectorXd lagrangian_gradient(const Nlp& problem, const VectorXd& x, const VectorXd& lambda) {
    const SparsityPattern& pattern = problem.shape().jacobian;
    VectorXd slope(x.size());
    problem.gradient(x, slope);
    slope *= sigma;
    std::vector<double> values(pattern.rows.size());
    problem.jacobian(x, values);
    for (int k = 0; k < pattern.size(); ++k) slope[pattern.columns[k]] += lambda[pattern.rows[k]] * values[k];
    return slope;
}

struct Given {
    MatrixXd values;
    Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic> known;
};

inline Given dense(const SparsityPattern& pattern, const std::vector<double>& values, int rows, int columns,
                   bool mirror) {
    Given given{MatrixXd::Zero(rows, columns), {}};
    given.known.setConstant(rows, columns, false);
    for (int k = 0; k < pattern.size(); ++k) {
        const int i = pattern.rows[k], j = pattern.columns[k];
        given.values(i, j) += values[k];
        given.known(i, j) = true;
        if (mirror && i != j) {
            given.values(j, i) += values[k];
            given.known(j, i) = true;
        }
    }
    return given;
}

class Checker {
 public:
    Checker(const Nlp& problem, const DerivativeCheckOptions& options)
        : problem_(problem), shape_(problem.shape()), options_(options) {}

    void check_point(const VectorXd& x, int point) {
        point_ = point;
        const int n = shape_.variables(), m = shape_.constraints();
        Given gradient{MatrixXd(1, n), {}};
        gradient.known.setConstant(1, n, true);
        VectorXd slope(n);
        problem_.gradient(x, slope);
        gradient.values = slope.transpose();
        compare(DerivativeKind::gradient, gradient, x,
                [this](const VectorXd& at) { return VectorXd::Constant(1, problem_.cost(at)).eval(); });
        if (m > 0) {
            std::vector<double> values(shape_.jacobian.rows.size());
            problem_.jacobian(x, values);
            compare(DerivativeKind::jacobian, dense(shape_.jacobian, values, m, n, false), x,
                    [this, m](const VectorXd& at) {
                        VectorXd g(m);
                        problem_.constraints(at, g);
                        return g;
                    });
        }
        const VectorXd lambda = multipliers(m);
        std::vector<double> values(shape_.hessian.rows.size());
        problem_.hessian(x, sigma, lambda, values);
        compare(DerivativeKind::hessian, dense(shape_.hessian, values, n, n, true), x,
                [this, &lambda](const VectorXd& at) { return lagrangian_gradient(problem_, at, lambda); });
    }

    DerivativeReport take_report() {
        for (auto& [kind, faults] : faults_) {
            std::sort(faults.begin(), faults.end(), worse);
            if (std::ssize(faults) > options_.worst) faults.resize(static_cast<std::size_t>(options_.worst));
            report_.faults.insert(report_.faults.end(), faults.begin(), faults.end());
        }
        std::sort(report_.faults.begin(), report_.faults.end(), worse);
        return std::move(report_);
    }

 private:
    static bool worse(const DerivativeFault& a, const DerivativeFault& b) { return a.error > b.error; }

    void compare(DerivativeKind kind, const Given& given, const VectorXd& x, const Function& function) {
        for (int j = 0; j < shape_.variables(); ++j) {
            const Column column = differenced(function, shape_, x, j, options_.step);
            const int first = kind == DerivativeKind::hessian ? j : 0;  // lower triangle
            for (int i = first; i < column.derivative.size(); ++i) {
                DerivativeFault fault{kind,
                                      point_,
                                      row_name(kind, i),
                                      problem_.variable_name(j),
                                      given.values(i, j),
                                      column.derivative[i],
                                      0.0,
                                      given.known(i, j)};
                fault.error = error_of(fault, column.rounding[i]);
                ++report_.entries;
                report_.worst_error = std::max(report_.worst_error, fault.error);
                if (fault.error > options_.tolerance) faults_[kind].push_back(std::move(fault));
            }
        }
    }

    static double error_of(const DerivativeFault& fault, double rounding) {
        if (!std::isfinite(fault.given) || !std::isfinite(fault.differenced)) return infinity;
        const double distance = std::abs(fault.given - fault.differenced) - rounding;
        return std::max(0.0, distance) / std::max({1.0, std::abs(fault.given), std::abs(fault.differenced)});
    }

    [[nodiscard]] std::string row_name(DerivativeKind kind, int index) const {
        if (kind == DerivativeKind::gradient) return {};
        return kind == DerivativeKind::jacobian ? problem_.row_name(index) : problem_.variable_name(index);
    }

    const Nlp& problem_;
    const NlpShape& shape_;
    const DerivativeCheckOptions& options_;
    int point_ = 0;
    std::map<DerivativeKind, std::vector<DerivativeFault>> faults_;
    DerivativeReport report_;
};

}  // namespace derivative_check

inline void DerivativeCheckOptions::validate() const {
    if (!(step > 0.0 && step < 0.1))
        throw InputError(fmt::format("derivative check: step is {}, allowed is a number in (0, 0.1)", step));
    if (!(tolerance > 0.0))
        throw InputError(
            fmt::format("derivative check: tolerance is {}, allowed is a number > 0", tolerance));
    if (worst < 1)
        throw InputError(fmt::format("derivative check: worst is {}, allowed is an integer >= 1", worst));
}

inline const char* name_of(DerivativeKind value) {
    return word_of<DerivativeKind::hessian>(value, {"gradient", "jacobian", "hessian"});
}

inline DerivativeReport check_derivatives(const Nlp& problem, std::span<const Eigen::VectorXd> points,
                                          const DerivativeCheckOptions& options = {}) {
    options.validate();
    derivative_check::Checker checker(problem, options);
    int index = 0;
    for (const Eigen::VectorXd& point : points) {
        if (point.size() != problem.shape().variables())
            throw InputError(
                fmt::format("derivative check: point {} has {} entries, the problem has {} variables", index,
                            point.size(), problem.shape().variables()));
        checker.check_point(point, index++);
    }
    return checker.take_report();
}

inline std::string describe(const DerivativeFault& fault) {
    const std::string of = fault.row.empty() ? "" : fmt::format(" of '{}'", fault.row);
    return fmt::format("{}{} by '{}' at point {}: given {}, differenced {}, error {:.2g}{}",
                       name_of(fault.kind), of, fault.variable, fault.point,
                       fault.in_pattern ? fmt::format("{:.10g}", fault.given) : "nothing",
                       fmt::format("{:.10g}", fault.differenced), fault.error,
                       fault.in_pattern ? "" : " (missing from the pattern)");
}

}  // namespace camopt
