// SPDX-License-Identifier: MIT
#include "motions/bounds/geometric_program.hpp"

#include "core/errors.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int most_iterations = 300;
/// Slack times multiplier at the start. Far from the central path the steps get short: the next try starts
/// with larger multipliers.
constexpr double first_weight = 0.1, last_weight = 1e3, next_weight = 10.0, largest_multiplier = 1e3;
/// Complementarity at which even a weakly active constraint (slack ~ its root) is exact to 1e-12.
constexpr double last_complementarity = 1e-26;
/// Residuals of the conditions of optimality (logarithms, order 1): reached up to roundings; still accepted.
constexpr double least_residual = 2e-14, accepted_residual = 1e-11;
/// A first phase that ends within this of log t = 0 has found the only feasible point.
constexpr double touching = 2e-13;
/// The first phase may stop once all constraints have this much slack.
constexpr double roomy_slack = 0.05;
constexpr double to_boundary = 0.9;  // part of the way a step may go
/// Added to the Hessian's diagonal: directions without curvature stay put. It shortens steps, it moves no
/// solution.
constexpr double regularisation = 1e-11;
/// Longest step of a logarithm: beyond it the quadratic model of a log-sum-exp says nothing.
constexpr double longest_move = 4.0;

/// log p at one u = log z, with its derivatives.
struct LogSum {
    double value = 0.0;
    VectorXd gradient;
    MatrixXd hessian;
};

LogSum log_sum(const Posynomial& posynomial, const VectorXd& u) {
    const auto terms = static_cast<Eigen::Index>(posynomial.size());
    MatrixXd exponents(terms, u.size());
    VectorXd power(terms);
    for (Eigen::Index k = 0; k < terms; ++k) {
        const Monomial& monomial = posynomial[k];
        exponents.row(k) = VectorXd::Map(monomial.exponents.data(), u.size());
        power[k] = std::log(monomial.coefficient) + exponents.row(k).dot(u);
    }
    const double top = power.maxCoeff();
    VectorXd share = (power.array() - top).exp();
    const double sum = share.sum();
    share /= sum;
    LogSum result{top + std::log(sum), exponents.transpose() * share, {}};
    exponents.rowwise() -= result.gradient.transpose();
    result.hessian = exponents.transpose() * share.asDiagonal() * exponents;
    return result;
}

/// A point with the residuals of its conditions of optimality.
struct Iterate {
    VectorXd u, slack, multiplier;
    VectorXd dual, primal;
    MatrixXd gradients, hessian;  ///< of the constraints, a row each; of the Lagrangian

    [[nodiscard]] double complementarity() const {
        return slack.dot(multiplier) / static_cast<double>(std::max<Eigen::Index>(1, slack.size()));
    }
    /// The dual residual's roundings grow with the multipliers.
    [[nodiscard]] double residual() const {
        return std::max(dual.lpNorm<Eigen::Infinity>() / std::max(1.0, multiplier.lpNorm<Eigen::Infinity>()),
                        primal.lpNorm<Eigen::Infinity>());
    }
    void evaluate(const GeometricProgram& program) {
        const LogSum objective = log_sum(program.objective, u);
        dual = objective.gradient;
        hessian = objective.hessian;
        hessian.diagonal().array() += regularisation;
        primal = slack;
        gradients.resize(slack.size(), u.size());
        for (Eigen::Index i = 0; i < slack.size(); ++i) {
            const LogSum constraint = log_sum(program.constraints[i], u);
            gradients.row(i) = constraint.gradient;
            dual += multiplier[i] * constraint.gradient;
            hessian += multiplier[i] * constraint.hessian;
            primal[i] += constraint.value;
        }
    }
    /// Newton's step towards slack · multiplier = target, as far as both stay positive. Returns its length.
    double move(double target) {
        const VectorXd product = (slack.array() * multiplier.array() - target).matrix();
        const VectorXd weight = multiplier.cwiseQuotient(slack);
        const VectorXd shift = weight.cwiseProduct(primal) - product.cwiseQuotient(slack);
        MatrixXd matrix = hessian + gradients.transpose() * weight.asDiagonal() * gradients;
        // Scaling by the diagonal keeps the pivots of free and of tight directions apart.
        const VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
        matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
        const VectorXd right = -scale.cwiseProduct(dual + gradients.transpose() * shift);
        const VectorXd du = scale.cwiseProduct(matrix.ldlt().solve(right));
        const VectorXd ds = -(primal + gradients * du);
        const VectorXd dm = -(product + multiplier.cwiseProduct(ds)).cwiseQuotient(slack);
        if (!du.allFinite() || !dm.allFinite()) return 0.0;
        const double steepest =
            std::max((-ds.cwiseQuotient(slack)).maxCoeff(), (-dm.cwiseQuotient(multiplier)).maxCoeff());
        const double length = std::min({1.0, to_boundary / std::max(to_boundary, steepest),
                                        longest_move / std::max(longest_move, du.lpNorm<Eigen::Infinity>())});
        u += length * du;
        slack += length * ds;
        multiplier += length * dm;
        return length;
    }
};

struct Minimum {
    bool found = false;
    VectorXd u, multiplier;
    int iterations = 0;
};

VectorXd values(const GeometricProgram& program, const VectorXd& u) {
    VectorXd all(static_cast<Eigen::Index>(program.constraints.size()));
    for (Eigen::Index i = 0; i < all.size(); ++i) all[i] = log_sum(program.constraints[i], u).value;
    return all;
}

/// From a strictly feasible u. `enough(u)` ends the iteration early. Found: the iterate of the least
/// complementarity whose residual is accepted; else the last one.
template <typename Enough>
Minimum minimise(const GeometricProgram& program, VectorXd u, double weight, const Enough& enough) {
    Iterate at;
    at.slack = -values(program, u);
    at.multiplier = (weight * at.slack.cwiseInverse()).cwiseMin(largest_multiplier);
    at.u = std::move(u);
    Minimum result;
    double centering = 0.1, kept_residual = accepted_residual, kept_complementarity = accepted_residual;
    for (; result.iterations < most_iterations; ++result.iterations) {
        at.evaluate(program);
        const double residual = at.residual(), complementarity = at.complementarity();
        const bool better = residual <= kept_residual && complementarity <= kept_complementarity;
        if (better || !result.found) {
            result.u = at.u;
            result.multiplier = at.multiplier;
        }
        if (better) {
            result.found = true;
            kept_residual = std::max(residual, 10.0 * least_residual);
            kept_complementarity = complementarity;
        }
        if (enough(at.u) || (residual <= least_residual && complementarity <= last_complementarity)) break;
        const double length = at.move(centering * complementarity);
        if (length == 0.0) break;
        centering = length > 0.8 ? 0.01 : length > 0.3 ? 0.1 : length > 0.05 ? 0.5 : 1.0;
    }
    return result;
}

void require_sound(const GeometricProgram& program) {
    const auto sound = [&](const Posynomial& posynomial) {
        return !posynomial.empty() && std::ranges::all_of(posynomial, [&](const Monomial& monomial) {
            return std::isfinite(monomial.coefficient) && monomial.coefficient > 0.0 &&
                   monomial.exponents.size() == static_cast<std::size_t>(program.variables);
        });
    };
    if (program.variables >= 1 && sound(program.objective) && !program.constraints.empty() &&
        std::ranges::all_of(program.constraints, sound))
        return;
    throw ModelError(fmt::format(
        "geometric program of {} variables and {} constraints: an empty posynomial, a "
        "coefficient that is not positive and finite, no constraint, or a wrong number of exponents",
        program.variables, program.constraints.size()));
}

/// min t subject to p_i(z) / t <= 1; t is the last variable.
GeometricProgram first_phase(GeometricProgram program) {
    program.objective = {{1.0, std::vector<double>(static_cast<std::size_t>(program.variables), 0.0)}};
    program.objective.front().exponents.push_back(1.0);
    for (Posynomial& constraint : program.constraints)
        for (Monomial& monomial : constraint) monomial.exponents.push_back(-1.0);
    ++program.variables;
    return program;
}

}  // namespace

GeometricProgramResult solve(const GeometricProgram& program) {
    require_sound(program);
    const Eigen::Index n = program.variables;
    const auto violation = [&](const VectorXd& u) { return values(program, u.head(n)).maxCoeff(); };
    VectorXd start = VectorXd::Zero(n + 1);
    start[n] = violation(start) + 1.0;
    Minimum best = minimise(first_phase(program), start, first_weight,
                            [&](const VectorXd& u) { return violation(u) <= -roomy_slack; });
    GeometricProgramResult result;
    result.iterations = best.iterations;
    const double least = violation(best.u);
    if (least > touching && best.found) result.status = GeometricProgramStatus::infeasible;
    if (least > touching) return result;
    if (least < -touching) {
        const VectorXd inside = best.u.head(n);
        best.found = false;
        for (double weight = first_weight; !best.found && weight <= last_weight; weight *= next_weight) {
            best = minimise(program, inside, weight, [](const VectorXd&) { return false; });
            result.iterations += best.iterations;
        }
    }
    if (!best.found) return result;
    result.status = GeometricProgramStatus::optimal;
    result.variables = best.u.head(n).array().exp();
    result.multipliers = best.multiplier;
    result.objective = std::exp(log_sum(program.objective, best.u.head(n)).value);
    return result;
}

}  // namespace camopt
