// SPDX-License-Identifier: MIT
// Replaces nlopt_solver.cpp in a build without NLopt.
#include "solvers/backend_support.hpp"
#include "solvers/nlopt/nlopt_solver.hpp"

namespace camopt {

std::string nlopt_library_version() {
    return {};
}

std::unique_ptr<Solver> make_nlopt_solver(NloptMethod method) {
    throw_unavailable(nlopt_entry(method));
}

}  // namespace camopt
