// SPDX-License-Identifier: MIT
// Many solves as one table: which keys of a scene vary (SweepAxis), the rows in an order of neighbours
// (SweepPlan), a chunk of rows solved in order (solve_chunk). Values of axes are in the unit of their key. A
// row depends on the plan and on the size of its chunk, never on who solved it: chunks may be solved by
// several threads, each with SweepScenes of its own. Or a function sets what varies: sweep(scene, values,
// set).
#pragma once

#include "core/language.hpp"
#include "studies/sweep/sweep_axis.hpp"
#include "studies/sweep/sweep_plan.hpp"
#include "studies/sweep/sweep_row.hpp"
#include "studies/sweep/sweep_run.hpp"
