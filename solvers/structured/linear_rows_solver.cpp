// SPDX-License-Identifier: MIT
#include "solvers/structured/linear_rows_solver.hpp"

#include "core/word_of.hpp"
#include "solvers/structured/standard_form.hpp"

#include <fmt/core.h>

namespace camopt::structured {

namespace {

using Eigen::VectorXd;

constexpr double acceptable = 100.0;  // times the tolerance
constexpr double elastic_tolerance = 1e-13;

// A warm start takes a dozen iterations; where it takes as many as a cold start, the cold start is more
// reliable.
constexpr int most_from_near = 30;

const char* word(Stop stop) {
    return word_of<Stop::suspect_unbounded>(
        stop,
        {"converged", "no further progress", "factorization breakdown", "iteration limit", "time limit",
         "interrupted", "a value of the problem is not finite", "multipliers diverge", "point diverges"});
}

class LinearRowsRun {
 public:
    LinearRowsRun(const Nlp& problem, const VectorXd& start, const BackendOptions& options,
                  const SolveControl& control)
        : problem_(problem),
          start_(start),
          control_(control),
          near_(options.near),
          tolerance_(options.tolerance),
          exact_after_failure_(options.exact_steps == ExactSteps::after_failure),
          has_optimum_(options.has_optimum),
          limits_(interior_point_limits(options, structured_options(options.native), control)),
          form_(problem, start) {
        limits_.suspicious = !has_optimum_;
    }

    BackendResult run() {
        if (form_.status() != StandardForm::Status::ready) return refused();
        const VectorXd start = form_.to_model(start_);
        InteriorPointResult solved = from_near();
        if (!solved.has_point()) solved = searched(start, limits_);
        BackendResult result;
        const auto hopeless = [&] {
            return solved.stop != Stop::converged && solved.stop != Stop::interrupted &&
                   solved.stop != Stop::time_limit && solved.stop != Stop::iteration_limit &&
                   solved.stop != Stop::evaluation_error && solved.errors.worst() > limits_.tolerance;
        };
        const bool runs_away =
            solved.stop == Stop::suspect_infeasible || solved.stop == Stop::suspect_unbounded;
        if (hopeless() && !runs_away && limits_.shift > fine_regularisation) {
            limits_.shift = fine_regularisation;
            repeat(start, solved);
        }
        if (!has_optimum_ && hopeless()) {
            const bool far_off = solved.errors.worst() > acceptable * tolerance_;
            if ((runs_away || far_off || solved.errors.primal > limits_.tolerance) &&
                proved_infeasible(result))
                return result;
            if (runs_away) {
                if (proved_unbounded(solved, result)) return result;
                limits_.suspicious = false;
                solved = searched(start, limits_);
            }
        }
        if (hopeless() && solved.errors.worst() > acceptable * tolerance_) {
            if (!has_optimum_ && proved_unbounded(solved, result)) return result;
            if (exact_after_failure_) {
                limits_.exact_steps = true;
                repeat(start, solved);
            }
        }
        return delivered(solved);
    }

 private:
    /// From a point, or along the path from one near it.
    template <class Start>
    InteriorPointResult searched(const Start& start, const InteriorPointLimits& limits) {
        InteriorPointResult solved = interior_point(form_.model(), start, limits, control_);
        iterations_ += solved.iterations;
        return solved;
    }
    BackendResult refused() {
        BackendResult result;
        result.native_status = form_.detail();
        result.x = start_;
        if (form_.status() == StandardForm::Status::evaluation_error) {
            result.termination = Termination::evaluation_error;
            return result;
        }
        result.termination = Termination::infeasible;
        if (form_.ray()) {
            result.row_multipliers = form_.ray()->row_multipliers;
            result.bound_multipliers = form_.ray()->bound_multipliers;
        }
        return result;
    }
    /// Along the path of a neighbouring problem; no point if the warm start fails.
    InteriorPointResult from_near() {
        if (!near_ || near_->mu <= 0.0 || near_->x.size() != problem_.shape().variables()) return {};
        const CentralPoint near{{form_.to_model(near_->x), form_.model_multipliers(near_->row_multipliers)},
                                form_.cost_scale() * near_->mu,
                                near_->gap};
        InteriorPointLimits limits = limits_;
        limits.max_iterations = std::min(limits.max_iterations, most_from_near);
        InteriorPointResult solved = searched(near, limits);
        const bool ended = solved.stop == Stop::converged || solved.stop == Stop::interrupted ||
                           solved.stop == Stop::time_limit;
        return ended ? solved : InteriorPointResult{};
    }
    /// With limits that have changed; the better of both points is kept.
    void repeat(const VectorXd& start, InteriorPointResult& solved) {
        InteriorPointResult again = searched(start, limits_);
        if (again.errors.worst() < solved.errors.worst()) solved = std::move(again);
    }
    BackendResult delivered(const InteriorPointResult& solved) const {
        BackendResult result;
        result.iterations = iterations_;
        const double error = solved.errors.worst();
        result.native_status =
            fmt::format("{}: errors primal {:.1e}, dual {:.1e}, gap {:.1e}", word(solved.stop),
                        solved.errors.primal, solved.errors.dual, solved.errors.gap);
        if (error <= tolerance_)
            result.termination = Termination::converged;
        else if (solved.stop == Stop::iteration_limit)
            result.termination = Termination::iteration_limit;
        else if (solved.stop == Stop::time_limit)
            result.termination = Termination::time_limit;
        else if (solved.stop == Stop::interrupted)
            result.termination = Termination::interrupted;
        else if (solved.stop == Stop::evaluation_error)
            result.termination = Termination::evaluation_error;
        else
            result.termination =
                error <= acceptable * tolerance_ ? Termination::acceptable : Termination::numerical_failure;
        if (!solved.has_point()) {
            result.x = start_;
            return result;
        }
        for (const CentralPoint& place : solved.path)
            result.path.push_back({form_.to_problem(place.point.x),
                                   form_.row_multipliers(place.point.lambda, form_.cost_scale()),
                                   place.mu / form_.cost_scale(), place.gap});
        result.x = form_.to_problem(solved.best.x);
        result.row_multipliers = form_.row_multipliers(solved.best.lambda, form_.cost_scale());
        VectorXd gradient(result.x.size());
        problem_.gradient(result.x, gradient);
        if (!gradient.allFinite()) gradient.setZero();
        result.bound_multipliers = form_.bound_multipliers(gradient, *result.row_multipliers);
        return result;
    }
    bool proved_infeasible(BackendResult& result) {
        InteriorPointLimits limits = limits_;
        limits.tolerance = elastic_tolerance;
        const ElasticResult elastic =
            least_violation(form_.model(), form_.to_model(start_), limits, control_);
        iterations_ += elastic.iterations;
        if (!(elastic.violation > least_contradiction)) return false;
        Ray ray{form_.row_multipliers(elastic.lambda, 1.0), {}};
        const VectorXd none = VectorXd::Zero(problem_.shape().variables());
        ray.bound_multipliers = form_.bound_multipliers(none, ray.row_multipliers);
        const double value = form_.ray_value(ray);
        // What remains of Cᵀλ + z on variables without the bound to carry it, times the size of the point.
        const ConvexModel& model = form_.model();
        const VectorXd rest = model.rows.transpose() * elastic.lambda;
        double uncertain = 0.0;
        for (Eigen::Index j = 0; j < rest.size(); ++j)
            if (!std::isfinite(rest[j] > 0.0 ? model.x_lower[j] : model.x_upper[j]))
                uncertain += std::abs(rest[j]) * (1.0 + std::abs(elastic.x[j]));
        if (!(value > least_contradiction) || !(value > 10.0 * uncertain)) return false;
        result.termination = Termination::infeasible;
        result.native_status =
            fmt::format("least common violation {:.3e} of the scaled rows", elastic.violation);
        result.x = form_.to_problem(elastic.x);
        result.row_multipliers = ray.row_multipliers / value;
        result.bound_multipliers = ray.bound_multipliers / value;
        result.iterations = iterations_;
        return true;
    }
    bool proved_unbounded(const InteriorPointResult& solved, BackendResult& result) const {
        if (!solved.has_point()) return false;
        const VectorXd point = solved.best.x;
        InteriorPointLimits limits = limits_;
        limits.tolerance = 1e-9;
        if (!recession(form_.model(), point, limits, control_).descends) return false;
        result = delivered(solved);
        result.termination = Termination::unbounded;
        result.native_status = "a direction of unlimited descent exists";
        return true;
    }

    const Nlp& problem_;
    const VectorXd& start_;
    const SolveControl& control_;
    const std::optional<PathPoint>& near_;
    double tolerance_;
    bool exact_after_failure_;
    bool has_optimum_;
    InteriorPointLimits limits_;  ///< its clock runs while the problem is read
    StandardForm form_;
    int iterations_ = 0;
};

}  // namespace

InteriorPointLimits interior_point_limits(const BackendOptions& options, const StructuredOptions& own,
                                          const SolveControl& control) {
    constexpr double aim = 0.1;
    InteriorPointLimits limits;
    limits.tolerance = aim * options.tolerance;
    limits.max_iterations = std::min(own.max_iterations, options.max_iterations);
    limits.patience = own.patience;
    limits.shift = own.regularisation;
    limits.factor = own.factor;
    limits.correctors = own.correctors;
    limits.keep_path = options.keep_path;
    limits.exact_steps = options.exact_steps == ExactSteps::always;
    limits.deadline = control.deadline.sooner(options.max_seconds);
    return limits;
}

BackendResult linear_rows_minimize(const Nlp& problem, const VectorXd& start, const BackendOptions& options,
                                   const SolveControl& control) {
    return LinearRowsRun(problem, start, options, control).run();
}

}  // namespace camopt::structured
