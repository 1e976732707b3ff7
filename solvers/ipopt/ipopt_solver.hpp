// SPDX-License-Identifier: MIT
// Ipopt: primal-dual interior point with a filter line search, for large sparse problems, convex or not.
// Exact sparse Jacobian and Hessian; gives multipliers.
//
// Ipopt 3.11 with MUMPS is not thread-safe (four threads crash in every run), so one process-wide mutex is
// held from the creation of an application to its destruction: solves in several threads are serialized. A
// solve started by an Nlp's evaluation inside a solve of the same thread is allowed. For speed run several
// processes.
//
// Changed defaults of Ipopt are listed with their reasons in ipopt_run.cpp. Source: A. Wächter, L. T.
// Biegler, Math. Program. 106 (2006) 25-57.
#pragma once

#include "solvers/registry.hpp"

namespace camopt {

[[nodiscard]] SolverEntry ipopt_entry();

/// Throws UnavailableError where this build has no Ipopt or its part (core/platform/parts.hpp) is not there.
[[nodiscard]] std::unique_ptr<Solver> make_ipopt_solver();

/// Of the Ipopt that this build was made with, "3.11.9"; empty where make_ipopt_solver() throws. Opens
/// nothing.
[[nodiscard]] std::string ipopt_version();

/// What to do where it is empty, without a full stop.
[[nodiscard]] std::string ipopt_remedy();

}  // namespace camopt
