// SPDX-License-Identifier: MIT
// Which backends there are, which of them this build has, and the options each takes: solver_entries(),
// make_solver(name). A backend that this build leaves out throws UnavailableError naming the package. The
// registry is constant.
#pragma once

#include "core/language.hpp"
#include "solvers/registry.hpp"
