// SPDX-License-Identifier: MIT
// Replaces ipopt_solver.cpp in a build without Ipopt.
#include "solvers/backend_support.hpp"
#include "solvers/ipopt/ipopt_solver.hpp"

namespace camopt {

std::string ipopt_version() {
    return {};
}

std::unique_ptr<Solver> make_ipopt_solver() {
    throw_unavailable(ipopt_entry());
}

}  // namespace camopt
