// SPDX-License-Identifier: MIT
// What the registry says of NLopt's algorithms; compiled whether or not this build has them.
#include "solvers/backend_support.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"

namespace camopt {

namespace {

SolverEntry nlopt_entry(std::string name, std::string method) {
    SolverEntry entry;
    entry.name = std::move(name);
    entry.method = std::move(method);
    entry.version = nlopt_library_version();
    entry.available = !entry.version.empty();
    entry.remedy = "install libnlopt-dev and configure camopt again with CAMOPT_WITH_NLOPT=ON";
    entry.options = {
        number_option("ftol_rel", "tolerance / 1000", not_negative,
                      "stop at a smaller relative change of the cost"),
        number_option("xtol_rel", "tolerance / 1000", not_negative, "stop at a smaller relative change of x"),
        number_option("constraint_tolerance", "tolerance", not_negative, "violation that counts as none"),
        integer_option("restarts", "20", {0.0, 1000.0},
                       "runs from the point of the run before, until one changes nothing more"),
    };
    return entry;
}

}  // namespace

SolverEntry nlopt_slsqp_entry() {
    return nlopt_entry("nlopt.slsqp",
                       "sequential quadratic programming, dense, gradients only, n up to about 150");
}

SolverEntry nlopt_cobyla_entry() {
    SolverEntry entry =
        nlopt_entry("nlopt.cobyla", "linear approximations without derivatives, n up to about 20");
    entry.options.push_back(
        number_option("initial_step", "NLopt's own", positive, "first step of every variable"));
    return entry;
}

}  // namespace camopt
