// SPDX-License-Identifier: MIT
// Of equal optima the smoothest.
#pragma once

#include "studies/search/planned_run.hpp"

namespace camopt {

/// Of a proved optimum whose plan breaks ties: among the optima within the tolerance, the one of least mean
/// square jerk. On a linear program a small enough weight on the energy picks exactly that one; how small is
/// found by trying. (To demand "objective <= optimum" as a row instead leaves a feasible set without an
/// inside, on which an interior point loses its digits.) Leaves the result alone where nothing smoother is
/// found; false: where none was tried to the end. The grid of `problem` is refined.
bool break_tie(const PlannedRun& run, CamProblem& problem, ContinuousResult& result);

}  // namespace camopt
