// SPDX-License-Identifier: MIT
// Ipopt's entry in the registry; the same whether or not its part is there. Only the options listed here
// reach Ipopt: linear_solver is restricted to mumps because the packaged 3.11 ends the whole process on ma97.
#include "solvers/backend_support.hpp"
#include "solvers/ipopt/ipopt_solver.hpp"

namespace camopt {

SolverEntry ipopt_entry() {
    SolverEntry entry;
    entry.name = "ipopt";
    entry.safe_in_threads = false;
    entry.method =
        "primal-dual interior point with a filter line search, exact sparse derivatives, any smooth problem";
    entry.version = ipopt_version();
    entry.available = !entry.version.empty();
    entry.remedy = ipopt_remedy();
    entry.gives_multipliers = true;
    entry.options = {
        text_option("linear_solver", "mumps", {"mumps"}, "sparse factorization"),
        text_option("hessian_approximation", "exact", {"exact", "limited-memory"}, "second derivatives"),
        text_option("mu_strategy", "adaptive", {"adaptive", "monotone"}, "how the barrier parameter falls"),
        text_option("nlp_scaling_method", "none", {"none", "gradient-based"}, "scaling of cost and rows"),
        text_option("fixed_variable_treatment", "make_parameter",
                    {"make_parameter", "make_constraint", "relax_bounds"}, "variables with equal bounds"),
        flag_option("mehrotra_algorithm", "true for convex problems with linear rows",
                    "predictor-corrector steps without a line search"),
        text_option(
            "chain_dense_columns", "auto", {"auto", "yes", "no"},
            "split each peak shared by many rows into chained copies, one per group of rows; auto: where "
            "the problem is large"),
        number_option("mu_init", "0.1", positive, "first barrier parameter"),
        number_option("mu_target", "0", not_negative, "barrier parameter at which to stop"),
        number_option("bound_push", "0.01", positive, "least distance of the start from its bounds"),
        number_option("bound_frac", "0.01", {0.0, 0.5, true},
                      "the same relative to the distance of the bounds"),
        number_option("bound_relax_factor", "tolerance / 100", not_negative,
                      "relative widening of all bounds"),
        number_option("constr_viol_tol", "tolerance", positive, "largest violation at the end"),
        number_option("dual_inf_tol", "tolerance", positive, "largest gradient of the Lagrangian at the end"),
        number_option("compl_inf_tol", "tolerance / 100", positive, "largest complementarity at the end"),
        number_option("acceptable_tol", "100 tolerance", positive,
                      "error that is accepted when progress stalls"),
        integer_option("acceptable_iter", "15", {0.0, 1e6},
                       "iterations at that error before it is accepted; 0: never"),
        number_option("mumps_pivtol", "1e-6", {0.0, 1.0}, "pivot tolerance of MUMPS"),
        integer_option("mumps_mem_percent", "100", {0.0, 1e6}, "spare memory of MUMPS in percent"),
        integer_option("mumps_permuting_scaling", "7; 0 from 3000 variables on", {0.0, 7.0},
                       "how MUMPS permutes and scales; 0: not, 7: automatic"),
        integer_option("max_soc", "4", {0.0, 1e6}, "second-order corrections in one iteration"),
    };
    return entry;
}

}  // namespace camopt
