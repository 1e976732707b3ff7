// SPDX-License-Identifier: MIT
#include "solvers/nlopt/nlopt_solver.hpp"

#include "solvers/nlopt/nlopt_adapter.hpp"
#include "solvers/nlopt/nlopt_traits.hpp"

#include <fmt/core.h>

namespace camopt {

namespace {

/// Costs below this count as unbounded; a problem is scaled to about one.
constexpr double unbounded_cost = -1e20;

struct Destroy {
    void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};
using Optimizer = std::unique_ptr<nlopt_opt_s, Destroy>;

nlopt_algorithm algorithm_of(NloptMethod method) {
    switch (method) {
        case NloptMethod::slsqp:
            return NLOPT_LD_SLSQP;
        case NloptMethod::cobyla:
            return NLOPT_LN_COBYLA;
        case NloptMethod::mma:
            return NLOPT_LD_MMA;
        case NloptMethod::ccsaq:
            return NLOPT_LD_CCSAQ;
        case NloptMethod::isres:
            return NLOPT_GN_ISRES;
        default:
            return NLOPT_AUGLAG;
    }
}

nlopt_algorithm inner_algorithm_of(NloptMethod method) {
    if (method == NloptMethod::auglag_lbfgs) return NLOPT_LD_LBFGS;
    return method == NloptMethod::auglag_sbplx ? NLOPT_LN_SBPLX : NLOPT_LN_NELDERMEAD;
}

class NloptSolver final : public Solver {
 public:
    explicit NloptSolver(NloptMethod method)
        : method_(method), traits_(traits_of(method)), entry_(nlopt_entry(method)) {}

    [[nodiscard]] std::string_view name() const override { return entry_.name; }

    [[nodiscard]] BackendResult minimize(const Nlp& problem, const Eigen::VectorXd& start,
                                         const BackendOptions& options,
                                         const SolveControl& control) const override {
        check_backend_input(entry_, problem, start, options);
        if (auto result = result_of_crossed_bounds(problem)) return *std::move(result);
        const NlpShape& shape = problem.shape();
        SolveGuard guard(options, control);
        NloptAdapter adapter(problem, guard);
        if (adapter.equality_rows() > 0 && !traits_.takes_equalities)
            return refused(
                fmt::format("takes no equality rows, this problem has {}", adapter.equality_rows()));
        const Optimizer optimizer(
            nlopt_create(algorithm_of(method_), static_cast<unsigned>(shape.variables())));
        const nlopt_result attached =
            adapter.attach(optimizer.get(), number_or(options, "constraint_tolerance", options.tolerance));
        if (attached < 0) {  // more equalities than variables, for one
            const char* message = nlopt_get_errmsg(optimizer.get());
            return refused(
                fmt::format("{}: {}", outcome_of(attached).word, message ? message : "no message"));
        }
        const Eigen::VectorXd inside = start.cwiseMax(shape.x_lower).cwiseMin(shape.x_upper);
        set_steps(optimizer.get(), options);
        set_own(optimizer.get(), options);
        if (traits_.is_global) set_box(optimizer.get(), shape, inside, options);
        if (traits_.is_augmented) set_inner(optimizer.get(), options);
        BackendResult result =
            NloptRuns(optimizer.get(), adapter, guard, options)
                .from(inside, static_cast<int>(number_or(options, "restarts", traits_.restarts)));
        guard.rethrow();
        if (traits_.is_global && is_finished(result.termination) &&
            is_at_edge(optimizer.get(), shape, result.x)) {
            result.termination = Termination::unbounded;
            result.native_status += " at the edge of its search radius";
        }
        if (guard.reason() && !is_finished(result.termination)) result.termination = *guard.reason();
        return result;
    }

 private:
    static BackendResult refused(std::string why) {
        BackendResult result;
        result.termination = Termination::unsupported;
        result.native_status = std::move(why);
        return result;
    }

    static void set_steps(nlopt_opt optimizer, const BackendOptions& options) {
        const double small = step_tolerance * options.tolerance;
        nlopt_set_ftol_rel(optimizer, number_or(options, "ftol_rel", small));
        nlopt_set_xtol_rel(optimizer, number_or(options, "xtol_rel", small));
        nlopt_set_stopval(optimizer, unbounded_cost);
        const double step = number_or(options, "initial_step", 0.0);
        if (step > 0.0) nlopt_set_initial_step1(optimizer, step);
    }

    void set_own(nlopt_opt optimizer, const BackendOptions& options) const {
        if (method_ == NloptMethod::mma || method_ == NloptMethod::ccsaq) {
            // NLopt's own choice, MMA once more, takes 70 to 150 times as long with some hundred rows.
            const auto dual = options.native.find("dual_algorithm");
            const bool mma = dual != options.native.end() && std::get<std::string>(dual->second) == "mma";
            nlopt_set_param(optimizer, "dual_algorithm", mma ? NLOPT_LD_MMA : NLOPT_LD_LBFGS);
            nlopt_set_param(optimizer, "dual_maxeval",
                            number_or(options, "dual_maxeval", default_dual_evaluations));
        }
        if (traits_.is_global) {
            // The generator is per thread: seeded here, a solve does not depend on those before it.
            nlopt_srand(static_cast<unsigned long>(number_or(options, "seed", 0.0)));
            nlopt_set_population(optimizer, static_cast<unsigned>(number_or(options, "population", 0.0)));
        }
    }

    /// Finite bounds where the problem has none.
    static void set_box(nlopt_opt optimizer, const NlpShape& shape, const Eigen::VectorXd& start,
                        const BackendOptions& options) {
        const double radius = number_or(options, "search_radius", default_search_radius);
        Eigen::VectorXd lower = shape.x_lower, upper = shape.x_upper;
        for (Eigen::Index j = 0; j < start.size(); ++j) {
            const double reach = radius * std::max(1.0, std::abs(start[j]));
            if (!std::isfinite(lower[j])) lower[j] = start[j] - reach;
            if (!std::isfinite(upper[j])) upper[j] = start[j] + reach;
        }
        nlopt_set_lower_bounds(optimizer, lower.data());
        nlopt_set_upper_bounds(optimizer, upper.data());
    }

    /// On a bound that set_box() added.
    static bool is_at_edge(nlopt_opt optimizer, const NlpShape& shape, const Eigen::VectorXd& x) {
        Eigen::VectorXd lower(x.size()), upper(x.size());
        nlopt_get_lower_bounds(optimizer, lower.data());
        nlopt_get_upper_bounds(optimizer, upper.data());
        for (Eigen::Index j = 0; j < x.size(); ++j) {
            const double margin = 1e-6 * (upper[j] - lower[j]);
            if (x[j] < lower[j] + margin && !std::isfinite(shape.x_lower[j])) return true;
            if (x[j] > upper[j] - margin && !std::isfinite(shape.x_upper[j])) return true;
        }
        return false;
    }

    void set_inner(nlopt_opt optimizer, const BackendOptions& options) const {
        // Without its xtol_abs the outer optimizer of NLopt 2.7 dereferences a null pointer.
        nlopt_set_xtol_abs1(optimizer, 0.0);
        const Optimizer inner(nlopt_create(inner_algorithm_of(method_), nlopt_get_dimension(optimizer)));
        set_steps(inner.get(), options);
        nlopt_set_maxeval(inner.get(),
                          static_cast<int>(number_or(options, "inner_maxeval", default_inner_evaluations)));
        nlopt_set_local_optimizer(optimizer, inner.get());  // takes a copy
    }

    NloptMethod method_;
    const NloptTraits& traits_;
    SolverEntry entry_;
};

}  // namespace

std::string nlopt_library_version() {
    int major = 0, minor = 0, bugfix = 0;
    ::nlopt_version(&major, &minor, &bugfix);
    return fmt::format("{}.{}.{}", major, minor, bugfix);
}

std::unique_ptr<Solver> make_nlopt_solver(NloptMethod method) {
    return std::make_unique<NloptSolver>(method);
}

}  // namespace camopt
