// SPDX-License-Identifier: MIT
// Among motions that are equally good, the smoothest.
#pragma once

#include "objectives/grid/cam_problem.hpp"
#include "scene/scene.hpp"
#include "solvers/exchange/exchange.hpp"
#include "studies/search/grid_memory.hpp"

namespace camopt {

/// Among the optima within the tolerance, the one of least mean square jerk. On a linear program a small
/// enough weight on the energy picks exactly that one; how small is found by trying. (To demand "objective <=
/// optimum" as a row instead leaves a feasible set without an inside, on which an interior point loses its
/// digits.) Leaves the result alone where nothing smoother is found. The grid of `problem` is refined;
/// `memory` keeps it for a neighbouring scene.
void break_tie(CamProblem& problem, const Scene& scene, ContinuousResult& result, const SolveControl& control,
               GridMemory* memory = nullptr);

/// A proved optimum whose scene asks for it, and that is not unique by itself.
[[nodiscard]] bool wants_tie_break(const Scene& scene, const Certificate& certificate);

/// The exchange as a scene sets it up.
[[nodiscard]] ExchangeOptions exchange_options(const Scene& scene);

}  // namespace camopt
