// SPDX-License-Identifier: MIT
// The one executor: numbered units of work, handed out to threads of this machine.
//
// A fence is a child process around threads or units, where the system can fork: it holds what a crash takes
// with it, and what is not safe in threads. A child ignores Ctrl-C (the parent decides) and dies with the
// parent, however that ends. On Windows there is no fence: a crash ends the run, and what stops a run waits
// for the units under way.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

enum class Fence {
    none,        ///< threads of this process, with its memory and its callbacks; a crash ends it
    around_all,  ///< threads of one child; where that dies, what is left goes on as around_each
    around_each  ///< every unit in a child of its own, forked by a thread that waits for it
};

struct PoolTask {
    std::vector<int> units;  ///< handed out in this order, each to the worker that is free
    int workers = 1;         ///< >= 1; never more than there are units
    Fence fence = Fence::none;

    /// In a worker: does one unit. tell(number) reaches `told`. Threads call it at once.
    std::function<void(int unit, const std::function<void(int)>& tell)> work = {};
    /// In a child, first of all: lets go of what belongs to the parent. May be empty.
    std::function<void()> begin_child = {};

    // In the thread that runs the task.
    std::function<void(int number)> told = {};
    /// Two children died of this unit. reason: "worker died: signal 11".
    std::function<void(int unit, const std::string& reason)> lost = {};
    /// Some times a second, and at the end: for a progress line.
    std::function<void()> tick = {};
    /// Polled; true: children are killed, threads of this process finish their units.
    std::function<bool()> stop_requested = {};
};

enum class PoolOutcome { finished, stopped };

/// Until every unit is done or lost, or until it is told to stop; no worker is left then. An exception in
/// `work` ends the run: of this process it is thrown on; of a child InputError comes as InputError,
/// everything else as std::runtime_error.
[[nodiscard]] PoolOutcome run_workers(const PoolTask& task);

}  // namespace camopt
