// SPDX-License-Identifier: MIT
// Stands in for nlopt_solver.cpp in a build without NLopt.
#include "solvers/backend_support.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"

namespace camopt {

std::string nlopt_library_version() {
    return {};
}

std::unique_ptr<Solver> make_nlopt_slsqp_solver() {
    throw_unavailable(nlopt_slsqp_entry());
}

std::unique_ptr<Solver> make_nlopt_cobyla_solver() {
    throw_unavailable(nlopt_cobyla_entry());
}

}  // namespace camopt
