// SPDX-License-Identifier: MIT
#include "solvers/solver.hpp"
