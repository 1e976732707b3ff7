// SPDX-License-Identifier: MIT
#include "solvers/ipopt/ipopt_solver.hpp"

#include "core/deadline.hpp"
#include "solvers/backend_support.hpp"
#include "solvers/chained_columns.hpp"
#include "solvers/ipopt/ipopt_adapter.hpp"
#include "solvers/ipopt/ipopt_options.hpp"

#include <fmt/core.h>

#include <IpIpoptApplication.hpp>
#include <IpoptConfig.h>
#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>

namespace camopt {

namespace {

/// Such a run needs 5 to 30 iterations; one that needs more than this goes in circles.
constexpr int predictor_corrector_iterations = 200;

struct Outcome {
    Termination termination;
    const char* word;
};

Outcome outcome_of(Ipopt::ApplicationReturnStatus status) {
    using enum Termination;
    switch (status) {
        case Ipopt::Solve_Succeeded:
            return {converged, "Solve_Succeeded"};
        case Ipopt::Solved_To_Acceptable_Level:
            return {acceptable, "Solved_To_Acceptable_Level"};
        case Ipopt::Infeasible_Problem_Detected:
            return {infeasible, "Infeasible_Problem_Detected"};
        case Ipopt::Search_Direction_Becomes_Too_Small:
            return {acceptable, "Search_Direction_Becomes_Too_Small"};
        case Ipopt::Diverging_Iterates:
            return {unbounded, "Diverging_Iterates"};
        case Ipopt::User_Requested_Stop:
            return {interrupted, "User_Requested_Stop"};
        case Ipopt::Feasible_Point_Found:
            return {converged, "Feasible_Point_Found"};
        case Ipopt::Maximum_Iterations_Exceeded:
            return {iteration_limit, "Maximum_Iterations_Exceeded"};
        case Ipopt::Restoration_Failed:
            return {numerical_failure, "Restoration_Failed"};
        case Ipopt::Error_In_Step_Computation:
            return {numerical_failure, "Error_In_Step_Computation"};
        case Ipopt::Maximum_CpuTime_Exceeded:
            return {time_limit, "Maximum_CpuTime_Exceeded"};
        case Ipopt::Not_Enough_Degrees_Of_Freedom:
            return {unsupported, "Not_Enough_Degrees_Of_Freedom"};
        case Ipopt::Invalid_Problem_Definition:
            return {unsupported, "Invalid_Problem_Definition"};
        case Ipopt::Invalid_Option:
            return {unsupported, "Invalid_Option"};
        case Ipopt::Invalid_Number_Detected:
            return {evaluation_error, "Invalid_Number_Detected"};
        case Ipopt::Unrecoverable_Exception:
            return {numerical_failure, "Unrecoverable_Exception"};
        case Ipopt::NonIpopt_Exception_Thrown:
            return {numerical_failure, "NonIpopt_Exception_Thrown"};
        case Ipopt::Insufficient_Memory:
            return {numerical_failure, "Insufficient_Memory"};
        case Ipopt::Internal_Error:
            return {numerical_failure, "Internal_Error"};
        default:
            return {numerical_failure, "unknown to camopt"};  // a status of a later Ipopt
    }
}

/// Recursive, because an evaluation may itself solve something with Ipopt.
std::recursive_timed_mutex& ipopt_mutex() {
    static std::recursive_timed_mutex mutex;
    return mutex;
}

/// Ipopt's turn for this thread; none where it was told to stop before its turn came. The wait is not part of
/// the time that the solve has.
std::optional<std::unique_lock<std::recursive_timed_mutex>> turn_of_ipopt(const SolveControl& control) {
    constexpr std::chrono::milliseconds between_questions(5);
    const Stopwatch waiting;
    std::unique_lock lock(ipopt_mutex(), std::defer_lock);
    bool waited = false;
    while (!lock.try_lock_for(between_questions)) {
        waited = true;
        if (control.stopped()) return std::nullopt;
    }
    if (waited) control.deadline.leave_out(waiting.seconds());
    return lock;
}

class IpoptSolver final : public Solver {
 public:
    [[nodiscard]] std::string_view name() const override { return "ipopt"; }

    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                         const BackendOptions& options,
                                         const SolveControl& control) const override {
        check_backend_input(entry_, problem, start, options);
        if (auto result = result_of_crossed_bounds(problem)) return *std::move(result);
        const auto turn = turn_of_ipopt(control);
        if (!turn) {
            BackendResult stopped;
            stopped.termination = Termination::interrupted;
            stopped.native_status = "stopped before its turn";
            return stopped;
        }
        SolveGuard guard(options, control);
        const std::vector<int> columns = columns_to_chain(problem.shape(), options);
        if (columns.empty()) return solve(problem, start, options, guard);
        return solve_chained(problem, columns, start, options, guard);
    }

 private:
    static BackendResult solve_chained(const Nlp& problem, const std::vector<int>& columns,
                                       const Eigen::VectorXd& start, const BackendOptions& options,
                                       SolveGuard& guard) {
        std::optional<ChainedColumns> chained;
        BackendResult result;
        const bool built = guard.call([&] { chained.emplace(problem, columns, start); });
        guard.rethrow();
        if (!built) return result;
        result = solve(*chained, chained->chained(start), options, guard);
        if (result.x.size() > 0) result.x = chained->unchained(result.x);
        if (result.row_multipliers) result.row_multipliers = chained->unchained_rows(*result.row_multipliers);
        if (result.bound_multipliers)
            result.bound_multipliers = chained->unchained(*result.bound_multipliers);
        return result;
    }

    /// A predictor-corrector run that has not ended after `predictor_corrector_iterations` is given up for
    /// the filter method, which also recognises infeasible problems.
    static BackendResult solve(const Nlp& problem, const Eigen::VectorXd& start,
                               const BackendOptions& options, SolveGuard& guard) {
        int spent = 0;
        if (wants_predictor_corrector(problem.shape(), options)) {
            BackendOptions first = options;
            first.max_iterations = std::min(options.max_iterations, predictor_corrector_iterations);
            BackendResult result = run(problem, start, first, guard, true);
            const bool asked_for = options.native.contains("mehrotra_algorithm");
            spent = result.iterations;
            if (is_final(result.termination) || guard.stopping() || asked_for ||
                spent >= options.max_iterations)
                return result;
        }
        BackendOptions rest = options;
        rest.max_iterations -= spent;
        BackendResult result = run(problem, start, rest, guard, false);
        result.iterations += spent;
        return result;
    }

    static bool is_final(Termination termination) {
        return termination == Termination::converged || termination == Termination::unsupported ||
               termination == Termination::evaluation_error;
    }

    static BackendResult run(const Nlp& problem, const Eigen::VectorXd& start, const BackendOptions& options,
                             SolveGuard& guard, bool predictor_corrector) {
        constexpr bool with_console = false;
        const Ipopt::SmartPtr<Ipopt::IpoptApplication> application =
            new Ipopt::IpoptApplication(with_console);
        set_ipopt_options(*application, problem.shape(), options, predictor_corrector);
        BackendResult result;
        Outcome outcome = outcome_of(application->Initialize(""));  // "": reads no ipopt.opt
        if (outcome.termination == Termination::converged) {
            const Ipopt::SmartPtr<IpoptAdapter> adapter = new IpoptAdapter(problem, start, guard);
            outcome = outcome_of(application->OptimizeTNLP(GetRawPtr(adapter)));
            result = adapter->result();
        }
        guard.rethrow();
        result.termination = outcome.termination;
        result.native_status = outcome.word;
        if (guard.reason() && outcome.termination != Termination::converged)
            result.termination = *guard.reason();
        return result;
    }

    SolverEntry entry_ = ipopt_entry();
};

}  // namespace

std::string ipopt_version() {
    return IPOPT_VERSION;
}

std::unique_ptr<Solver> make_ipopt_solver() {
    return std::make_unique<IpoptSolver>();
}

}  // namespace camopt
