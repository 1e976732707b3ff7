// SPDX-License-Identifier: MIT
// Workers on this machine: hand out numbered units of work, listen, survive what happens to them.
//
// Where the system can fork they are processes, because some backends (Ipopt with MUMPS) are not safe to run
// twice in one process, and because a crash then costs one unit and not the run. A worker ignores Ctrl-C (the
// parent decides) and dies with the parent, however that ends. On Windows they are threads: a crash ends the
// run, no unit is ever lost, and what stops a run waits for the units under way.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

struct PoolTask {
    std::vector<int> units;  ///< handed out in this order, each to the worker that is free
    int workers = 1;         ///< >= 1; never more than there are units

    /// In the worker: does one unit. tell(number) reaches `told` in the parent.
    std::function<void(int unit, const std::function<void(int)>& tell)> work;
    /// In a worker process, once, before any work: lets go of what belongs to the parent. May be empty.
    std::function<void()> begin_worker;

    // In the parent.
    std::function<void(int number)> told;
    /// Two workers died of this unit. reason: "worker died: signal 11".
    std::function<void(int unit, const std::string& reason)> lost;
    std::function<void()> tick;            ///< several times a second, for a progress line
    std::function<bool()> stop_requested;  ///< polled; true: the workers are killed
};

enum class PoolOutcome { finished, stopped };

/// Until every unit is done or lost, or until it is told to stop; no worker is left then. A unit whose worker
/// dies of it is given to another worker once; one that a dying worker had not begun with is not blamed. An
/// exception in `work` ends the run: InputError is thrown again as InputError, everything else as
/// std::runtime_error.
[[nodiscard]] PoolOutcome run_workers(const PoolTask& task);

}  // namespace camopt
