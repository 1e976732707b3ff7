// SPDX-License-Identifier: MIT
#include "solvers/structured/structured_solver.hpp"
