// SPDX-License-Identifier: MIT
// A backend: takes an Nlp and a start, hands back a point, perhaps multipliers, and why it stopped
// (Termination). It judges nothing; certificate.hpp does. SolveControl carries the limits of time and a stop
// request, which may be set by another thread. A Solver belongs to one thread at a time.
#pragma once

#include "core/language.hpp"
#include "solvers/solver.hpp"
