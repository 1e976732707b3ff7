// SPDX-License-Identifier: MIT
// What the registry says of the structured solver; always there, since it needs nothing but Eigen.
#include "solvers/backend_support.hpp"
#include "solvers/structured/structured_solver.hpp"

#include <Eigen/Core>
#include <fmt/core.h>

namespace camopt {

SolverEntry structured_entry() {
    SolverEntry entry;
    entry.name = "structured";
    entry.method =
        "primal-dual interior point, banded quasi-definite factorization with a dense border; around it a "
        "trust-region method of "
        "quadratic programs for nonlinear rows";
    entry.available = true;
    entry.version =
        fmt::format("Eigen {}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    entry.gives_multipliers = true;
    entry.options = {
        integer_option("max_iterations", "200", {1.0, 1e9}, "iterations, the elastic phase apart"),
        number_option("regularisation", "1e-9", {1e-14, 1e-3}, "diagonal shift of the scaled Newton matrix"),
        integer_option("correctors", "1", {0.0, 10.0}, "centrality correctors in one iteration, at most"),
        text_option("factorization", "auto", {"auto", "chain", "simplicial", "cholmod", "klu"},
                    "of the Newton matrix; chain falls back on simplicial where the matrix is none; cholmod "
                    "and klu are "
                    "SuiteSparse's"),
        integer_option("patience", "12", {2.0, 1e9},
                       "iterations without a better point before the search ends"),
        integer_option("max_passes", "200", {1.0, 1e9}, "nonlinear rows: linearizations, at most"),
        number_option("first_radius", "1", {1e-8, 1e8},
                      "nonlinear rows: how far the first linearization is trusted, relative to max(1, |x|)"),
    };
    if (!has_suitesparse_factors())
        for (NativeOption& option : entry.options)
            if (option.name == "factorization") {
                option.absent = {"cholmod", "klu"};
                option.remedy = suitesparse_remedy;
            }
    return entry;
}

}  // namespace camopt
