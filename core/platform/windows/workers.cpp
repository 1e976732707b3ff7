// SPDX-License-Identifier: MIT
// Threads, since there is no fork. A crash ends the run; what is finished by then is kept by `work`.
#include "core/platform/workers.hpp"

#include "core/errors.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace camopt {

namespace {

constexpr std::chrono::milliseconds patience{100};  // between two looks at what is not a message

class Crew {
 public:
    explicit Crew(const PoolTask& task) : task_(task), waiting_(task.units.begin(), task.units.end()) {}

    PoolOutcome run() {
        const std::size_t count = std::min(static_cast<std::size_t>(task_.workers), waiting_.size());
        busy_ = count;
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < count; ++i) threads.emplace_back([this] { live(); });
        const PoolOutcome outcome = follow();
        threads.clear();  // waits for the units that are under way
        hear();
        if (fault_) std::rethrow_exception(fault_);
        return outcome;
    }

 private:
    PoolOutcome follow() {
        while (!hear()) {
            if (task_.tick) task_.tick();
            if (!task_.stop_requested || !task_.stop_requested()) continue;
            const std::lock_guard lock(mutex_);
            waiting_.clear();
            return PoolOutcome::stopped;
        }
        return PoolOutcome::finished;
    }

    /// True: no thread works any more.
    bool hear() {
        std::unique_lock lock(mutex_);
        news_.wait_for(lock, patience, [this] { return !told_.empty() || busy_ == 0; });
        const std::vector<int> told = std::exchange(told_, {});
        const bool all_done = busy_ == 0;
        lock.unlock();
        for (const int number : told)
            if (task_.told) task_.told(number);
        return all_done;
    }

    void live() {
        try {
            while (const std::optional<int> unit = next())
                task_.work(*unit, [this](int number) {
                    const std::lock_guard lock(mutex_);
                    told_.push_back(number);
                    news_.notify_one();
                });
        } catch (...) {
            keep_fault();
        }
        const std::lock_guard lock(mutex_);
        --busy_;
        news_.notify_one();
    }

    std::optional<int> next() {
        const std::lock_guard lock(mutex_);
        if (waiting_.empty()) return std::nullopt;
        const int unit = waiting_.front();
        waiting_.pop_front();
        return unit;
    }

    /// As a worker process would hand it on: by its text.
    void keep_fault() {
        const std::lock_guard lock(mutex_);
        waiting_.clear();
        if (fault_) return;
        try {
            throw;
        } catch (const InputError& error) {
            fault_ = std::make_exception_ptr(InputError(error.what()));
        } catch (const std::exception& error) {
            fault_ = std::make_exception_ptr(std::runtime_error(error.what()));
        }
    }

    const PoolTask& task_;
    std::mutex mutex_;
    std::condition_variable news_;
    std::deque<int> waiting_;
    std::vector<int> told_;
    std::size_t busy_ = 0;
    std::exception_ptr fault_;
};

}  // namespace

PoolOutcome run_workers(const PoolTask& task) {
    return Crew(task).run();
}

}  // namespace camopt
