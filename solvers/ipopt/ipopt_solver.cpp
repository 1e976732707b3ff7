// SPDX-License-Identifier: MIT
#include "solvers/ipopt/ipopt_solver.hpp"

#include "core/platform/parts.hpp"
#include "solvers/chained_columns.hpp"
#include "solvers/ipopt/ipopt_part.hpp"

#include <chrono>

extern "C" const void* camopt_part_ipopt(const char* build);  // ipopt_run.cpp

namespace camopt {

namespace {

constexpr PartInfo ipopt_info = {"ipopt",
                                 "solves by ipopt",
                                 "Ipopt",
                                 "camopt-parts",
                                 "coinor-libipopt-dev",
                                 "CAMOPT_WITH_IPOPT",
                                 PartBuild::CAMOPT_PART_IPOPT};

const IpoptPart& ipopt_part() {
    return opened_part<IpoptPart, ipopt_info, camopt_part_ipopt>();
}

/// Number of variables above which chained columns are faster, measured on the states form (three variables
/// per knot): equal with 256 to 2048 knots, faster by a tenth with 4096 and a fifth with 8192.
constexpr int chaining_pays = 6000;

/// Predictor-corrector steps without a line search: up to a quarter fewer iterations on convex problems with
/// linear rows, but no termination where that is infeasible. Chosen by the shape, unless the native options
/// set it.
bool wants_predictor_corrector(const NlpShape& shape, const BackendOptions& options) {
    const auto native = options.native.find("mehrotra_algorithm");
    if (native != options.native.end()) return std::get<bool>(native->second);
    // Ipopt refuses predictor-corrector steps with any other barrier update.
    const auto rule = options.native.find("mu_strategy");
    if (rule != options.native.end() && std::get<std::string>(rule->second) != "adaptive") return false;
    const Linearity linear = linearity_of(shape);
    return linear.equalities && linear.inequalities && shape.convex && shape.quadratic_cost;
}

/// Columns in many rows that Ipopt receives as chained copies (solvers/chained_columns.hpp); none: the
/// unchanged problem. Chosen by the size of the problem, unless the native options set it.
std::vector<int> columns_to_chain(const NlpShape& shape, const BackendOptions& options) {
    const auto native = options.native.find("chain_dense_columns");
    const std::string wish = native == options.native.end() ? "auto" : std::get<std::string>(native->second);
    if (wish == "no" || (wish == "auto" && shape.variables() < chaining_pays)) return {};
    return dense_columns(shape);
}

/// Such a run needs 5 to 30 iterations; one that needs more cycles.
constexpr int predictor_corrector_iterations = 200;

/// Ipopt's lock for this thread; none if it was stopped while waiting. The wait is not part of the solve's
/// time.
std::optional<std::unique_lock<std::recursive_timed_mutex>> turn_of_ipopt(const SolveControl& control) {
    constexpr std::chrono::milliseconds between_questions(5);
    const Stopwatch waiting;
    std::unique_lock lock(ipopt_part().turn(), std::defer_lock);
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
            stopped.native_status = "stopped while waiting for another solve";
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

    /// A predictor-corrector run that has not converged after `predictor_corrector_iterations` is replaced by
    /// the filter method, which also recognises infeasible problems.
    static BackendResult solve(const Nlp& problem, const Eigen::VectorXd& start,
                               const BackendOptions& options, SolveGuard& guard) {
        int spent = 0;
        if (wants_predictor_corrector(problem.shape(), options)) {
            BackendOptions first = options;
            first.max_iterations = std::min(options.max_iterations, predictor_corrector_iterations);
            BackendResult result = ipopt_part().run(problem, start, first, guard, true);
            const bool asked_for = options.native.contains("mehrotra_algorithm");
            spent = result.iterations;
            if (is_final(result.termination) || guard.stopping() || asked_for ||
                spent >= options.max_iterations)
                return result;
        }
        BackendOptions rest = options;
        rest.max_iterations -= spent;
        BackendResult result = ipopt_part().run(problem, start, rest, guard, false);
        result.iterations += spent;
        return result;
    }

    static bool is_final(Termination termination) {
        return termination == Termination::converged || termination == Termination::unsupported ||
               termination == Termination::evaluation_error;
    }

    SolverEntry entry_ = ipopt_entry();
};

}  // namespace

std::string ipopt_version() {
    return part_available(ipopt_info) ? CAMOPT_IPOPT_VERSION : "";
}

std::string ipopt_remedy() {
    return part_remedy(ipopt_info);
}

std::unique_ptr<Solver> make_ipopt_solver() {
    if (ipopt_info.build == PartBuild::absent) throw_unavailable(ipopt_entry());
    require_part(ipopt_info);
    return std::make_unique<IpoptSolver>();
}

}  // namespace camopt
