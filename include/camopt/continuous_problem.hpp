// SPDX-License-Identifier: MIT
// The problem behind the grid: constraints that hold at every cam angle. Derive from ContinuousProblem to
// have a problem of your own solved by exchange (grid, true maxima, new rows) and judged. One belongs to one
// thread at a time.
#pragma once

#include "core/continuous_problem.hpp"
#include "core/language.hpp"
#include "solvers/exchange/continuous_solve.hpp"
