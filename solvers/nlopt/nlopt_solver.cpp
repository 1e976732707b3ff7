// SPDX-License-Identifier: MIT
#include "solvers/nlopt/nlopt_solver.hpp"

#include "solvers/backend_support.hpp"
#include "solvers/nlopt/nlopt_adapter.hpp"

#include <fmt/core.h>

#include <cmath>

namespace camopt {

namespace {

/// Costs below this are taken for unbounded; a problem arrives scaled to about one.
constexpr double unbounded_cost = -1e20;

struct Outcome {
    Termination termination;
    const char* word;
};

Outcome outcome_of(nlopt_result status) {
    using enum Termination;
    switch (status) {
        case NLOPT_SUCCESS:
            return {converged, "SUCCESS"};
        case NLOPT_FTOL_REACHED:
            return {converged, "FTOL_REACHED"};
        case NLOPT_XTOL_REACHED:
            return {converged, "XTOL_REACHED"};
        case NLOPT_STOPVAL_REACHED:
            return {unbounded, "STOPVAL_REACHED"};
        case NLOPT_MAXEVAL_REACHED:
            return {iteration_limit, "MAXEVAL_REACHED"};
        case NLOPT_MAXTIME_REACHED:
            return {time_limit, "MAXTIME_REACHED"};
        case NLOPT_FAILURE:
            return {numerical_failure, "FAILURE"};
        case NLOPT_INVALID_ARGS:
            return {unsupported, "INVALID_ARGS"};
        case NLOPT_OUT_OF_MEMORY:
            return {numerical_failure, "OUT_OF_MEMORY"};
        case NLOPT_ROUNDOFF_LIMITED:
            return {acceptable, "ROUNDOFF_LIMITED"};
        case NLOPT_FORCED_STOP:
            return {interrupted, "FORCED_STOP"};
        default:
            return {numerical_failure, "unknown to camopt"};  // a code of a later NLopt
    }
}

bool finished(Termination termination) {
    return termination == Termination::converged || termination == Termination::acceptable;
}

struct Destroy {
    void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<nlopt_opt_s, Destroy>;

void set_steps(nlopt_opt optimizer, const BackendOptions& options) {
    // A thousandth: a short step of SLSQP on a linear program says little of the distance to the optimum.
    nlopt_set_ftol_rel(optimizer, number_or(options, "ftol_rel", 1e-3 * options.tolerance));
    nlopt_set_xtol_rel(optimizer, number_or(options, "xtol_rel", 1e-3 * options.tolerance));
    nlopt_set_stopval(optimizer, unbounded_cost);
    const double step = number_or(options, "initial_step", 0.0);
    if (step > 0.0) nlopt_set_initial_step1(optimizer, step);
}

/// Runs, and runs again from where that ended, until a run ends feasible and lowers the cost no more. SLSQP
/// needs it on degenerate linear programs, where it stops early or stalls with a worn-out quasi-Newton
/// matrix.
class Runs {
 public:
    Runs(nlopt_opt optimizer, NloptAdapter& adapter, SolveGuard& guard, const BackendOptions& options)
        : optimizer_(optimizer), adapter_(adapter), guard_(guard), options_(options) {}

    BackendResult from(Eigen::VectorXd x) {
        const double feasible = 10.0 * number_or(options_, "constraint_tolerance", options_.tolerance);
        const int restarts = static_cast<int>(number_or(options_, "restarts", 20.0));
        BackendResult result;
        double best = infinity, violation = infinity;
        for (int run = 0; run <= restarts; ++run) {
            double cost = 0.0;
            const Outcome outcome = once(x, cost);
            result.termination = outcome.termination;
            result.native_status = outcome.word;
            if (!finished(outcome.termination)) break;
            violation = adapter_.violation(x);
            const bool settled =
                std::abs(best - cost) <= 0.1 * options_.tolerance * std::max(1.0, std::abs(cost));
            best = cost;
            if (settled && run > 0 && violation <= feasible) break;
        }
        if (finished(result.termination) && violation > feasible) {
            result.termination = Termination::numerical_failure;
            result.native_status += fmt::format(" with violation {:.2g}", violation);
        }
        result.x = std::move(x);
        result.iterations = adapter_.evaluations();
        return result;
    }

 private:
    Outcome once(Eigen::VectorXd& x, double& cost) {
        const int left = options_.max_iterations - adapter_.evaluations();
        if (left < 1) return {Termination::iteration_limit, "MAXEVAL_REACHED"};
        nlopt_set_maxeval(optimizer_, left);
        nlopt_set_maxtime(optimizer_, guard_.seconds_left());
        Eigen::VectorXd end = x;
        const Outcome outcome = outcome_of(nlopt_optimize(optimizer_, end.data(), &cost));
        if (end.allFinite()) x = end;
        return outcome;
    }

    nlopt_opt optimizer_;
    NloptAdapter& adapter_;
    SolveGuard& guard_;
    const BackendOptions& options_;
};

class NloptSolver final : public Solver {
 public:
    NloptSolver(SolverEntry entry, nlopt_algorithm algorithm)
        : entry_(std::move(entry)), algorithm_(algorithm) {}

    [[nodiscard]] std::string_view name() const override { return entry_.name; }

    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                         const BackendOptions& options,
                                         const SolveControl& control) const override {
        check_backend_input(entry_, problem, start, options);
        if (auto result = result_of_crossed_bounds(problem)) return *std::move(result);
        const NlpShape& shape = problem.shape();
        SolveGuard guard(options, control);
        NloptAdapter adapter(problem, guard);
        const Optimizer optimizer(nlopt_create(algorithm_, static_cast<unsigned>(shape.variables())));
        BackendResult result;
        const nlopt_result attached =
            adapter.attach(optimizer.get(), number_or(options, "constraint_tolerance", options.tolerance));
        if (attached < 0) {  // more equalities than variables, for one
            result.termination = outcome_of(attached).termination;
            const char* message = nlopt_get_errmsg(optimizer.get());
            result.native_status =
                fmt::format("{}: {}", outcome_of(attached).word, message ? message : "no message");
            return result;
        }
        set_steps(optimizer.get(), options);
        result = Runs(optimizer.get(), adapter, guard, options)
                     .from(start.cwiseMax(shape.x_lower).cwiseMin(shape.x_upper));
        guard.rethrow();
        if (guard.reason() && !finished(result.termination)) result.termination = *guard.reason();
        return result;
    }

 private:
    SolverEntry entry_;
    nlopt_algorithm algorithm_;
};

}  // namespace

std::string nlopt_library_version() {
    int major = 0, minor = 0, bugfix = 0;
    ::nlopt_version(&major, &minor, &bugfix);
    return fmt::format("{}.{}.{}", major, minor, bugfix);
}

std::unique_ptr<Solver> make_nlopt_slsqp_solver() {
    return std::make_unique<NloptSolver>(nlopt_slsqp_entry(), NLOPT_LD_SLSQP);
}

std::unique_ptr<Solver> make_nlopt_cobyla_solver() {
    return std::make_unique<NloptSolver>(nlopt_cobyla_entry(), NLOPT_LN_COBYLA);
}

}  // namespace camopt
