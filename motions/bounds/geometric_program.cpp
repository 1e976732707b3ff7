// SPDX-License-Identifier: MIT
#include "motions/bounds/geometric_program.hpp"

#include "core/errors.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace camopt {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kMostIterations = 200;
constexpr int kMostBarrierSteps = 100;
/// Weights of the first and the last barrier function, and the Newton decrement in their unit that counts as
/// 0.
constexpr double kFirstWeight = 0.1;
constexpr double kLastBarrier = 1e-9;
constexpr double kCentred = 1e-3;
/// Complementarity at which even a weakly active constraint (slack ~ its root) is exact to 1e-12.
constexpr double kLastComplementarity = 1e-26;
/// Residuals of the conditions of optimality (logarithms, order 1) reached up to roundings.
constexpr double kResidual = 2e-14;
/// What is still accepted as solved when roundings stop the iteration.
constexpr double kAcceptedResidual = 1e-11;
/// A first phase that ends within this of log t = 0 has found the only feasible point.
constexpr double kTouching = 2e-13;
/// The first phase may stop once all constraints have this much slack.
constexpr double kRoomySlack = 0.05;
/// Part of the way to the boundary a step may go, and the least decrease asked of the residual.
constexpr double kToBoundary = 0.995;
constexpr double kLeastDecrease = 0.01;
constexpr double kSmallestStep = 1e-10;
/// Added to the Hessian's diagonal: directions without curvature stay put. It shortens steps, it moves no
/// solution.
constexpr double kRegularisation = 1e-11;
/// Longest step of a logarithm: beyond it the quadratic model of a log-sum-exp says nothing.
constexpr double kLongestMove = 4.0;

/// log Σ exp(offset + exponents·u), its gradient and Hessian.
class LogSumExp {
 public:
    LogSumExp(const Posynomial& posynomial, int variables)
        : exponents_(static_cast<Eigen::Index>(posynomial.size()), variables), offset_(exponents_.rows()) {
        for (Eigen::Index k = 0; k < exponents_.rows(); ++k) {
            const Monomial& monomial = posynomial[static_cast<std::size_t>(k)];
            offset_[k] = std::log(monomial.coefficient);
            for (int j = 0; j < variables; ++j)
                exponents_(k, j) = monomial.exponents[static_cast<std::size_t>(j)];
        }
    }

    [[nodiscard]] double value(const VectorXd& u) const {
        const VectorXd power = offset_ + exponents_ * u;
        const double top = power.maxCoeff();
        return top + std::log((power.array() - top).exp().sum());
    }

    /// At one u; the shares of the terms in the sum.
    struct Slope {
        double value = 0.0;
        VectorXd share, gradient;
    };
    [[nodiscard]] Slope slope(const VectorXd& u) const {
        const VectorXd power = offset_ + exponents_ * u;
        const double top = power.maxCoeff();
        Slope result;
        result.share = (power.array() - top).exp();
        const double sum = result.share.sum();
        result.share /= sum;
        result.value = top + std::log(sum);
        result.gradient = exponents_.transpose() * result.share;
        return result;
    }

    /// Adds factor · Hessian.
    void add_hessian(const Slope& at, double factor, MatrixXd& sum) const {
        for (Eigen::Index k = 0; k < exponents_.rows(); ++k) {
            const VectorXd apart = exponents_.row(k).transpose() - at.gradient;
            sum.noalias() += (factor * at.share[k]) * apart * apart.transpose();
        }
    }

 private:
    MatrixXd exponents_;
    VectorXd offset_;
};

struct Convex {
    LogSumExp objective;
    std::vector<LogSumExp> constraints;

    explicit Convex(const GeometricProgram& program) : objective(program.objective, program.variables) {
        for (const Posynomial& constraint : program.constraints) {
            constraints.emplace_back(constraint, program.variables);
        }
    }

    [[nodiscard]] VectorXd values(const VectorXd& u) const {
        VectorXd g(static_cast<Eigen::Index>(constraints.size()));
        for (Eigen::Index i = 0; i < g.size(); ++i) g[i] = constraints[static_cast<std::size_t>(i)].value(u);
        return g;
    }

    /// Of the objective and of every constraint.
    struct Slopes {
        LogSumExp::Slope objective;
        std::vector<LogSumExp::Slope> constraints;
    };
    [[nodiscard]] Slopes slopes(const VectorXd& u) const {
        Slopes result{objective.slope(u), {}};
        result.constraints.reserve(constraints.size());
        for (const LogSumExp& constraint : constraints) result.constraints.push_back(constraint.slope(u));
        return result;
    }
};

/// u, slacks and multipliers; the residuals of the conditions of optimality at them.
struct Iterate {
    VectorXd u, slack, multiplier;

    [[nodiscard]] double complementarity() const {
        return slack.dot(multiplier) / static_cast<double>(std::max<Eigen::Index>(1, slack.size()));
    }
};

struct Residual {
    VectorXd dual, primal, product;
    double scale = 1.0;  ///< of the dual residual: its roundings grow with the multipliers

    [[nodiscard]] double conditions() const {
        return std::max(dual.lpNorm<Eigen::Infinity>() / scale, primal.lpNorm<Eigen::Infinity>());
    }
    [[nodiscard]] double norm() const {
        return std::sqrt(dual.squaredNorm() + primal.squaredNorm() + product.squaredNorm());
    }
};

Residual residual_at(const Convex::Slopes& slopes, const Iterate& at, double target) {
    Residual residual;
    residual.dual = slopes.objective.gradient;
    residual.primal = at.slack;
    for (Eigen::Index i = 0; i < at.slack.size(); ++i) {
        const LogSumExp::Slope& constraint = slopes.constraints[static_cast<std::size_t>(i)];
        residual.dual += at.multiplier[i] * constraint.gradient;
        residual.primal[i] += constraint.value;
    }
    residual.product = (at.slack.array() * at.multiplier.array() - target).matrix();
    residual.scale = std::max(1.0, at.multiplier.lpNorm<Eigen::Infinity>());
    return residual;
}

Iterate newton_step(const Convex& problem, const Convex::Slopes& slopes, const Iterate& at,
                    const Residual& residual) {
    MatrixXd rows(at.slack.size(), at.u.size());  // row i is the gradient of constraint i
    MatrixXd matrix = MatrixXd::Zero(at.u.size(), at.u.size());
    problem.objective.add_hessian(slopes.objective, 1.0, matrix);
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const VectorXd& gradient = slopes.constraints[index].gradient;
        rows.row(i) = gradient.transpose();
        matrix.noalias() += (at.multiplier[i] / at.slack[i]) * gradient * gradient.transpose();
        problem.constraints[index].add_hessian(slopes.constraints[index], at.multiplier[i], matrix);
    }
    matrix.diagonal().array() += kRegularisation;
    const VectorXd shift =
        (at.multiplier.cwiseProduct(residual.primal) - residual.product).cwiseQuotient(at.slack);
    // Scaling by the diagonal keeps the pivots of free and of tight directions apart.
    const VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
    matrix = scale.asDiagonal() * matrix * scale.asDiagonal();
    const VectorXd right = -(residual.dual + rows.transpose() * shift);
    Iterate step;
    step.u = scale.cwiseProduct(matrix.ldlt().solve(scale.cwiseProduct(right)));
    step.slack = -(residual.primal + rows * step.u);
    step.multiplier = -(residual.product + at.multiplier.cwiseProduct(step.slack)).cwiseQuotient(at.slack);
    return step;
}

double longest_step(const Iterate& at, const Iterate& step) {
    double length = std::min(1.0, kLongestMove / std::max(kLongestMove, step.u.lpNorm<Eigen::Infinity>()));
    for (Eigen::Index i = 0; i < at.slack.size(); ++i) {
        if (step.slack[i] < 0.0) length = std::min(length, -kToBoundary * at.slack[i] / step.slack[i]);
        if (step.multiplier[i] < 0.0) {
            length = std::min(length, -kToBoundary * at.multiplier[i] / step.multiplier[i]);
        }
    }
    return length;
}

Iterate moved(const Iterate& at, const Iterate& step, double length) {
    return {at.u + length * step.u, at.slack + length * step.slack, at.multiplier + length * step.multiplier};
}

/// f - weight Σ log(-g), infinite outside.
double barrier(const Convex& problem, const VectorXd& u, double weight) {
    const VectorXd slack = -problem.values(u);
    if (!(slack.array() > 0.0).all()) return std::numeric_limits<double>::infinity();
    return problem.objective.value(u) - weight * slack.array().log().sum();
}

/// Damped Newton on the barrier function: sure and slow, it brings the start near the central path. Returns
/// the steps taken; `enough(u)` ends it.
int follow_barrier(const Convex& problem, VectorXd& u, double weight) {
    int steps = 0;
    for (; steps < kMostBarrierSteps; ++steps) {
        const VectorXd slack = -problem.values(u);
        // A Newton step on the barrier is a primal-dual step whose multipliers are weight / slack.
        const Iterate at{u, slack, weight * slack.cwiseInverse()};
        const Convex::Slopes slopes = problem.slopes(u);
        const Residual residual = residual_at(slopes, at, weight);
        const VectorXd move = newton_step(problem, slopes, at, residual).u;
        const double decrease = -residual.dual.dot(move);
        if (!(decrease > kCentred * weight) || !move.allFinite()) break;
        double length = std::min(1.0, kLongestMove / std::max(kLongestMove, move.lpNorm<Eigen::Infinity>()));
        const double here = barrier(problem, u, weight);
        const auto low_enough = [&] {
            return barrier(problem, u + length * move, weight) <= here - kLeastDecrease * length * decrease;
        };
        while (length > kSmallestStep && !low_enough()) length *= 0.5;
        if (length <= kSmallestStep) break;
        u += length * move;
    }
    return steps;
}

struct Minimum {
    bool found = false;
    Iterate at;
    int iterations = 0;
};

/// From a strictly feasible u. `weight` of the barrier whose minimum it is near; `enough(u)` may end the
/// iteration early.
template <typename Enough>
Minimum minimise(const Convex& problem, VectorXd start, double weight, const Enough& enough) {
    Minimum result;
    Iterate& at = result.at;
    at.u = std::move(start);
    at.slack = -problem.values(at.u);
    at.multiplier = (weight * at.slack.cwiseInverse()).cwiseMin(1e3);
    Convex::Slopes slopes = problem.slopes(at.u);
    double centering = 0.1;
    for (int i = 0; i < kMostIterations; ++i, ++result.iterations) {
        const double complementarity = at.complementarity();
        const Residual now = residual_at(slopes, at, 0.0);
        result.found = now.conditions() <= kAcceptedResidual && complementarity <= kAcceptedResidual;
        if (enough(at.u) || (now.conditions() <= kResidual && complementarity <= kLastComplementarity)) break;
        const double target = centering * complementarity;
        const Residual aimed = residual_at(slopes, at, target);
        const Iterate step = newton_step(problem, slopes, at, aimed);
        if (!step.u.allFinite() || !step.multiplier.allFinite()) break;
        double length = longest_step(at, step);
        Iterate trial;
        Convex::Slopes its_slopes;
        const auto accepted = [&] {
            trial = moved(at, step, length);
            its_slopes = problem.slopes(trial.u);
            const Residual there = residual_at(its_slopes, trial, target);
            return there.conditions() <= kResidual ||
                   there.norm() <= (1.0 - kLeastDecrease * length) * aimed.norm();
        };
        while (length > kSmallestStep && !accepted()) length *= 0.5;
        if (length <= kSmallestStep) {
            if (centering >= 1.0) break;
            centering = 1.0;
            continue;
        }
        at = std::move(trial);
        slopes = std::move(its_slopes);
        centering = length > 0.9 ? 0.01 : length > 0.3 ? 0.1 : 0.5;
    }
    return result;
}

void require_sound(const GeometricProgram& program) {
    const auto sound = [&program](const Posynomial& posynomial) {
        return !posynomial.empty() &&
               std::all_of(posynomial.begin(), posynomial.end(), [&program](const Monomial& monomial) {
                   return std::isfinite(monomial.coefficient) && monomial.coefficient > 0.0 &&
                          monomial.exponents.size() == static_cast<std::size_t>(program.variables);
               });
    };
    if (program.variables < 1 || !sound(program.objective) ||
        !std::all_of(program.constraints.begin(), program.constraints.end(), sound)) {
        throw ModelError(
            fmt::format("geometric program of {} variables and {} constraints: an empty posynomial, a "
                        "coefficient that is not positive and finite, or a wrong number of exponents",
                        program.variables, program.constraints.size()));
    }
}

/// min t subject to p_i(z) / t <= 1; t is the last variable.
GeometricProgram first_phase(const GeometricProgram& program) {
    GeometricProgram phase;
    phase.variables = program.variables + 1;
    const auto widened = [](Monomial monomial, double power) {
        monomial.exponents.push_back(power);
        return monomial;
    };
    phase.objective = {
        widened({1.0, std::vector<double>(static_cast<std::size_t>(program.variables), 0.0)}, 1.0)};
    for (const Posynomial& constraint : program.constraints) {
        Posynomial relaxed;
        for (const Monomial& monomial : constraint) relaxed.push_back(widened(monomial, -1.0));
        phase.constraints.push_back(std::move(relaxed));
    }
    return phase;
}

}  // namespace

GeometricProgramResult solve(const GeometricProgram& program) {
    require_sound(program);
    GeometricProgramResult result;
    const Convex problem(program);
    const Eigen::Index n = program.variables;
    VectorXd start = VectorXd::Zero(n + 1);
    if (!program.constraints.empty()) start[n] = problem.values(start.head(n)).maxCoeff() + 1.0;
    const Minimum first = minimise(Convex(first_phase(program)), start, kFirstWeight, [&](const VectorXd& u) {
        return program.constraints.empty() || problem.values(u.head(n)).maxCoeff() <= -kRoomySlack;
    });
    result.iterations = first.iterations;
    const VectorXd inside = first.at.u.head(n);
    const double violation = program.constraints.empty() ? -1.0 : problem.values(inside).maxCoeff();
    if (violation > kTouching) {
        if (first.found) result.status = GeometricProgramStatus::infeasible;
        return result;
    }
    const auto take = [&](const VectorXd& u, const VectorXd& multipliers) {
        result.status = GeometricProgramStatus::optimal;
        result.variables = u.array().exp();
        result.multipliers = multipliers;
        result.objective = std::exp(problem.objective.value(u));
    };
    if (violation >= -kTouching) {
        if (first.found) take(inside, first.at.multiplier);
        return result;
    }
    const auto never = [](const VectorXd&) { return false; };
    Minimum second = minimise(problem, inside, kFirstWeight, never);
    // Far from the central path the residual's norm can get stuck: walk along the path first, then again.
    VectorXd centred = inside;
    for (double weight = kFirstWeight; !second.found && weight >= kLastBarrier; weight *= 0.1) {
        result.iterations += second.iterations + follow_barrier(problem, centred, weight);
        second = minimise(problem, centred, weight, never);
    }
    result.iterations += second.iterations;
    if (second.found) take(second.at.u, second.at.multiplier);
    return result;
}

}  // namespace camopt
