// SPDX-License-Identifier: MIT
// Small problems with known answers for every backend. The answer and where it comes from stand beside each.
#pragma once

#include "core/nlp.hpp"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>

namespace camopt::test {

/// min ½ xᵀ Q x + cᵀ x + constant  subject to  x_L <= x <= x_U,  g_L <= G x <= g_U.
struct QuadraticData {
    Eigen::MatrixXd hessian;  ///< Q, symmetric; 0 x 0 for a linear cost
    Eigen::VectorXd slope;    ///< c
    double constant = 0.0;
    Eigen::MatrixXd rows;  ///< G; 0 x 0 for none
    Eigen::VectorXd g_lower, g_upper;
    Eigen::VectorXd x_lower, x_upper;  ///< empty: free
    bool convex = true;
};
[[nodiscard]] std::unique_ptr<Nlp> quadratic_problem(QuadraticData data);

struct KnownProblem {
    std::string name;
    std::unique_ptr<Nlp> nlp;
    Eigen::VectorXd start;
    double cost = 0.0;   ///< at the optimum
    Eigen::VectorXd x;   ///< the optimum where it is unique, else empty
    std::string source;  ///< of the answer
};

// Linear programs.
[[nodiscard]] KnownProblem corner_lp();
[[nodiscard]] KnownProblem degenerate_lp();
[[nodiscard]] KnownProblem equality_lp();
[[nodiscard]] KnownProblem two_sided_lp();
[[nodiscard]] KnownProblem fixed_variable_lp();
[[nodiscard]] KnownProblem all_fixed_lp();
/// Least peak acceleration of a rise 0 → 1 in unit time on `steps` equal steps (odd), second differences.
[[nodiscard]] KnownProblem least_acceleration_lp(int steps);
/// Weighted peaks 0.5 V + 0.1 A + 0.01 J of the same rise; 12 or 20 steps.
[[nodiscard]] KnownProblem weighted_peaks_lp(int steps);

// Convex quadratic programs.
[[nodiscard]] KnownProblem unconstrained_qp();
[[nodiscard]] KnownProblem projection_qp();
/// Least ∫a² of the same rise with piecewise linear acceleration.
[[nodiscard]] KnownProblem least_square_acceleration_qp(int segments);

// Nonlinear programs.
[[nodiscard]] KnownProblem hs71();
[[nodiscard]] KnownProblem bounded_rosenbrock();

// Problems without an answer.
[[nodiscard]] KnownProblem infeasible_lp();
[[nodiscard]] KnownProblem unbounded_lp();
[[nodiscard]] KnownProblem overdetermined();

/// The same problem, with its cost passed through a function: to stop, to throw, to spoil, to wait.
class HookedNlp final : public Nlp {
 public:
    using Hook = std::function<double(double cost)>;
    HookedNlp(const Nlp& inner, Hook hook) : Nlp(inner.shape()), inner_(inner), hook_(std::move(hook)) {}
    [[nodiscard]] double cost(const ConstVectorRef& x) const override { return hook_(inner_.cost(x)); }
    void gradient(const ConstVectorRef& x, VectorRef out) const override { inner_.gradient(x, out); }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { inner_.constraints(x, out); }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override { inner_.jacobian(x, out); }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        inner_.hessian(x, sigma, lambda, out);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return inner_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return inner_.row_name(index); }

 private:
    const Nlp& inner_;
    Hook hook_;
};

/// Largest violation of a bound or row at x, relative to max(1, |bound|).
[[nodiscard]] double violation(const Nlp& problem, const Eigen::VectorXd& x);

/// ‖∇f + Jᵀ row_multipliers + bound_multipliers‖∞ at x.
[[nodiscard]] double stationarity(const Nlp& problem, const Eigen::VectorXd& x,
                                  const Eigen::VectorXd& row_multipliers,
                                  const Eigen::VectorXd& bound_multipliers);

/// Largest product of a multiplier with the distance to the bound its sign belongs to (infinite bound:
/// |multiplier|).
[[nodiscard]] double complementarity(const Nlp& problem, const Eigen::VectorXd& x,
                                     const Eigen::VectorXd& row_multipliers,
                                     const Eigen::VectorXd& bound_multipliers);

}  // namespace camopt::test
