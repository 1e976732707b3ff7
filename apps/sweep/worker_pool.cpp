// SPDX-License-Identifier: MIT
#include "apps/sweep/worker_pool.hpp"

#include "apps/sweep/worker_process.hpp"
#include "core/errors.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <poll.h>
#include <stdexcept>

namespace camopt::apps {

namespace {

constexpr int patience_milliseconds = 100;  // between two looks at what is not a message
constexpr int most_deaths = 2;              // of one unit

class Pool {
 public:
    explicit Pool(const PoolTask& task)
        : task_(task),
          duty_{task.begin_worker, task.work, {}},
          waiting_(task.units.begin(), task.units.end()),
          more_may_come_(task.source.has_value()) {}

    PoolOutcome run() {
        while (!waiting_.empty() || busy() > 0 || more_may_come_) {
            if (task_.stop_requested && task_.stop_requested()) return PoolOutcome::stopped;
            ask_for_units();
            hire();
            hand_out();
            wait_and_listen();
            tick();
        }
        return PoolOutcome::finished;
    }

 private:
    /// Messages come by the thousand; a progress line is read by a person.
    void tick() {
        const Clock::time_point now = Clock::now();
        if (!task_.tick || now - last_tick_ < std::chrono::milliseconds(patience_milliseconds)) return;
        last_tick_ = now;
        task_.tick();
    }

    [[nodiscard]] long busy() const {
        return std::ranges::count_if(workers_,
                                     [](const WorkerProcess& one) { return one.unit().has_value(); });
    }

    /// One for each worker that would have nothing to do.
    void ask_for_units() {
        if (!more_may_come_) return;
        const long enough = task_.workers - busy() - static_cast<long>(waiting_.size());
        for (; asked_ < enough; ++asked_) task_.source->ask();
    }

    void take_answer() {
        const std::optional<int> unit = task_.source->answer();
        if (unit) {
            waiting_.push_back(*unit);
            --asked_;
        } else {
            more_may_come_ = false;
        }
    }

    void hire() {
        const auto wanted = std::min<std::size_t>(static_cast<std::size_t>(task_.workers),
                                                  waiting_.size() + static_cast<std::size_t>(busy()));
        while (workers_.size() < wanted) {
            std::vector<int> lines;
            for (const WorkerProcess& worker : workers_) lines.push_back(worker.line());
            workers_.emplace_back(duty_, lines);
        }
    }

    void hand_out() {
        for (WorkerProcess& worker : workers_) {
            if (worker.unit() || waiting_.empty()) continue;
            worker.give(waiting_.front());
            waiting_.pop_front();
        }
    }

    void wait_and_listen() {
        std::vector<pollfd> lines;
        for (const WorkerProcess& worker : workers_) lines.push_back({worker.line(), POLLIN, 0});
        if (more_may_come_) lines.push_back({task_.source->line, POLLIN, 0});
        if (::poll(lines.data(), lines.size(), patience_milliseconds) <= 0) return;
        if (more_may_come_) {
            if (lines.back().revents != 0) take_answer();
            lines.pop_back();
        }
        for (std::size_t i = lines.size(); i-- > 0;)  // from the end: a dead one is taken out
            if (lines[i].revents != 0) listen(i);
    }

    void listen(std::size_t index) {
        using Kind = WorkerMessage::Kind;
        WorkerProcess& worker = workers_[index];
        const std::optional<WorkerMessage> message = worker.listen();
        if (!message) {
            bury(index);
            return;
        }
        if (message->kind == Kind::wrong_input) throw InputError(message->text);
        if (message->kind == Kind::error) throw std::runtime_error(message->text);
        if (message->kind == Kind::told && task_.told) task_.told(message->number);
        if (message->kind == Kind::done) {
            worker.set_idle();
            if (task_.done) task_.done(message->number);
        }
    }

    void bury(std::size_t index) {
        const std::optional<int> unit = workers_[index].unit();
        const bool innocent = workers_[index].died_before_its_unit();
        const std::string cause = workers_[index].cause_of_death();
        workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(index));
        if (!unit) return;
        if (innocent || ++deaths_[*unit] < most_deaths) {
            waiting_.push_front(*unit);
            return;
        }
        task_.lost(*unit, cause);
        if (task_.done) task_.done(*unit);
    }

    using Clock = std::chrono::steady_clock;

    const PoolTask& task_;
    Clock::time_point last_tick_;
    WorkerDuty duty_;
    std::deque<int> waiting_;
    std::vector<WorkerProcess> workers_;
    std::map<int, int> deaths_;
    bool more_may_come_;
    long asked_ = 0;  ///< and not yet answered
};

}  // namespace

PoolOutcome run_workers(const PoolTask& task) {
    return Pool(task).run();
}

}  // namespace camopt::apps
