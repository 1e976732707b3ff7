// SPDX-License-Identifier: MIT
// Worker processes on this machine: fork, hand out numbered units of work, listen, survive what happens to
// them.
//
// Processes and not threads, because some backends (Ipopt with MUMPS) are not safe to run twice in one
// process, and because a crash then costs one unit and not the run. A worker ignores Ctrl-C (the parent
// decides) and dies with the parent, whatever kills that.
#pragma once

#include "core/base/standard.hpp"

#include <sys/types.h>

namespace camopt::apps {

/// Units that come while the pool runs, from the code that hands them out to several pools.
struct UnitSource {
    int line = -1;                               ///< a file descriptor, readable where an answer has come
    std::function<void()> ask;                   ///< one more unit is wanted
    std::function<std::optional<int>()> answer;  ///< to one `ask`: a unit; none: there are no more
};

struct PoolTask {
    std::vector<int> units;            ///< handed out in this order, each to the rank or worker that is free
    std::optional<UnitSource> source;  ///< of further ones
    int workers = 1;                   ///< >= 1; never more than there are units

    /// In the worker: does one unit. tell(number) reaches `told` in the parent.
    std::function<void(int unit, const std::function<void(int)>& tell)> work;
    /// In the worker, once, before any work: lets go of what belongs to the parent. May be empty.
    std::function<void()> begin_worker;

    // In the parent.
    std::function<void(int number)> told;
    std::function<void(int unit)> done;  ///< may be empty
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

// One worker process and the line to it. Used by worker_pool.cpp, and by ranks/ for what runs such a pool.

/// What a worker says.
struct WorkerMessage {
    enum class Kind { told, done, asks, wrong_input, error };
    Kind kind = Kind::told;
    int number = 0;    ///< told, done
    std::string text;  ///< wrong_input, error
};

/// What runs in the worker.
struct WorkerDuty {
    std::function<void()> begin;
    std::function<void(int unit, const std::function<void(int)>& tell)> work;
    /// Instead of both: has the line to itself, and ends with it. May throw as `work` may.
    std::function<void(int line)> life;
};

/// In the worker: the next number that it was given; none: no one is there any more.
[[nodiscard]] std::optional<int> receive_number(int line);
/// In the worker. Ends it where no one is there any more.
void send_message(int line, const WorkerMessage& message);

class WorkerProcess {
 public:
    /// Forks. `not_mine`: ends of other workers' lines, which the child closes. Throws std::system_error
    /// where the system gives no process.
    WorkerProcess(const WorkerDuty& duty, const std::vector<int>& not_mine);
    WorkerProcess(WorkerProcess&& other) noexcept;
    WorkerProcess& operator=(WorkerProcess&& other) noexcept;
    ~WorkerProcess();  ///< kills it where it still works

    [[nodiscard]] int line() const { return line_; }  ///< a file descriptor to poll
    [[nodiscard]] const std::optional<int>& unit() const { return unit_; }
    void give(int unit);  ///< a worker that is dead already is noticed by listen()
    void set_idle();

    /// The next message; none: it died. Blocks until there is one.
    [[nodiscard]] std::optional<WorkerMessage> listen();
    /// Of a dead worker that had done a unit: whether it died before it took the one that it has now. (One
    /// that has done nothing yet may be unable to begin: who gave to such for ever would never end.)
    [[nodiscard]] bool died_before_its_unit() const { return has_served_ && unread_; }

    /// Of a dead worker: "worker died: signal 11".
    [[nodiscard]] std::string cause_of_death();

 private:
    void end() noexcept;

    pid_t process_ = -1;
    int line_ = -1;
    std::optional<int> unit_;
    bool has_served_ = false;  ///< it has done a unit
    bool unread_ = false;      ///< what it was given last it never read
};

}  // namespace camopt::apps
