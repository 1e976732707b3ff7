// SPDX-License-Identifier: MIT
// A sweep by threads of this process: each solves whole chunks, so the rows are those of every other way to
// solve the sweep. The thread that called waits for them, answers Ctrl-C and calls the progress callback.
#pragma once

#include "bindings/python/source/read_scene.hpp"
#include "bindings/python/source/watch.hpp"

#include <camopt/sweep.hpp>
#include <optional>

namespace camopt::python {

struct SweepTask {
    const ReadScene& given;
    SweepPlan plan;
    std::optional<int> chunk;  ///< rows of a chunk; none: as the command line takes them
    int workers = 1;
};

/// Without the interpreter's lock. Where the watch stops it, the rows that were finished until then. Throws
/// InputError for a row that is wrong, before anything is solved.
[[nodiscard]] SweepTable solve_sweep(const SweepTask& task, Watch& watch);

}  // namespace camopt::python
