// SPDX-License-Identifier: MIT
// Entries of NLopt's algorithms in the registry; compiled whether or not this build has them.
#include "core/errors.hpp"
#include "solvers/backend_support.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"
#include "solvers/nlopt/nlopt_traits.hpp"

#include <fmt/core.h>

namespace camopt {

namespace {

// In the order of NloptMethod.
constexpr std::array<NloptTraits, 8> all_traits = {{
    {.name = "nlopt.slsqp",
     .text = "sequential quadratic programming, dense, gradients only, n up to about 150"},
    {.name = "nlopt.cobyla",
     .text = "linear approximations without derivatives, n up to about 20",
     .needs_derivatives = false},
    {.name = "nlopt.mma",
     .text = "moving asymptotes: many inequalities, few variables, slow to the last digits",
     .takes_equalities = false},
    {.name = "nlopt.ccsaq",
     .text = "convex quadratic approximations: many inequalities, few variables, slow to the last digits",
     .takes_equalities = false},
    {.name = "nlopt.isres",
     .text = "evolution without derivatives, global in a box, n up to about 5, uses up its evaluations",
     .needs_derivatives = false,
     .takes_equalities = false,
     .restarts = 0,
     .is_global = true},
    {.name = "nlopt.auglag.lbfgs",
     .text =
         "augmented Lagrangian around limited-memory BFGS: smooth curved problems, poor on linear programs",
     .is_augmented = true},
    {.name = "nlopt.auglag.sbplx",
     .text = "augmented Lagrangian around Subplex, without derivatives, n up to about 5",
     .needs_derivatives = false,
     .is_augmented = true},
    {.name = "nlopt.auglag.neldermead",
     .text =
         "augmented Lagrangian around the simplex of Nelder and Mead, without derivatives, n up to about 5",
     .needs_derivatives = false,
     .is_augmented = true},
}};

void add_own_options(NloptMethod method, std::vector<NativeOption>& options) {
    const NloptTraits& traits = traits_of(method);
    if (method == NloptMethod::mma || method == NloptMethod::ccsaq) {
        options.push_back(
            text_option("dual_algorithm", "lbfgs", {"lbfgs", "mma"},
                        "solver of the dual of each approximation; mma takes minutes for many rows"));
        options.push_back(integer_option("dual_maxeval", fmt::format("{}", default_dual_evaluations),
                                         {1.0, 1e7}, "evaluations of that dual in one iteration"));
    }
    if (traits.is_global) {
        options.push_back(
            number_option("search_radius", fmt::format("{:g}", default_search_radius), positive,
                          "where a variable has no bound: largest distance from the start, in units of "
                          "max(1, |start|)"));
        options.push_back(integer_option("population", "0", {0.0, 1e6}, "points kept; 0: 20 (n + 1)"));
        options.push_back(integer_option("seed", "0", {0.0, 4294967295.0}, "seed of the random numbers"));
    }
    if (traits.is_augmented)
        options.push_back(integer_option("inner_maxeval", fmt::format("{}", default_inner_evaluations),
                                         {1.0, 1e7}, "evaluations between two updates of the multipliers"));
    if (!traits.needs_derivatives && !traits.is_global)
        options.push_back(
            number_option("initial_step", "NLopt's own", positive, "first step of every variable"));
}

}  // namespace

const NloptTraits& traits_of(NloptMethod method) {
    return all_traits.at(static_cast<std::size_t>(method));
}

SolverEntry nlopt_entry(NloptMethod method) {
    const NloptTraits& traits = traits_of(method);
    SolverEntry entry;
    entry.name = traits.name;
    entry.method = traits.text;
    entry.version = nlopt_library_version();
    entry.available = !entry.version.empty();
    entry.remedy = "install libnlopt-dev and configure camopt again with CAMOPT_WITH_NLOPT=ON";
    entry.needs_derivatives = traits.needs_derivatives;
    entry.takes_equalities = traits.takes_equalities;
    const std::string step = fmt::format("{:g} tolerance", step_tolerance);
    entry.options = {
        number_option("ftol_rel", step, not_negative, "stop at a smaller relative change of the cost"),
        number_option("xtol_rel", step, not_negative, "stop at a smaller relative change of x"),
        number_option("constraint_tolerance", "tolerance", not_negative, "violation that counts as none"),
        integer_option("restarts", fmt::format("{}", traits.restarts), {0.0, 1000.0},
                       "runs from the point of the run before, until one changes nothing more"),
    };
    add_own_options(method, entry.options);
    return entry;
}

}  // namespace camopt
