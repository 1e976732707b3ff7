// SPDX-License-Identifier: MIT
#include "bindings/python/source/sweep_threads.hpp"

#include "studies/sweep/sweep_check.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace camopt::python {

namespace {

class Crew {
 public:
    Crew(const SweepTask& task, Watch& watch)
        : task_(task),
          watch_(watch),
          chunking_{task.plan.rows(), task.chunk.value_or(chunk_size_for(task.plan.rows()))} {}

    std::vector<SweepRow> run() {
        std::vector<std::thread> threads;
        const int count = std::min(task_.workers, chunking_.count());
        working_ = count;
        for (int i = 0; i < count; ++i) threads.emplace_back([this] { work(); });
        wait();
        for (std::thread& thread : threads) thread.join();
        if (failure_) std::rethrow_exception(failure_);
        std::ranges::sort(rows_, {}, &SweepRow::number);
        return std::move(rows_);
    }

 private:
    void work() {
        try {
            SweepScenes scenes(task_.plan,
                               [this](std::span<const std::string> row) { return scene_of(row); });
            SolveControl control;
            control.stop_requested = [this] { return watch_.stopped() || failed_; };
            for (int chunk = next_++; chunk < chunking_.count() && !control.stopped(); chunk = next_++)
                (void)solve_chunk(scenes, chunking_.range(chunk), control,
                                  [&](const SweepRow& row) { add(row); });
        } catch (...) {
            fail();
        }
        const std::lock_guard lock(mutex_);
        --working_;
        news_.notify_one();
    }

    /// A row that throws is a failed row; what a function of the user's throws is to be seen by him.
    Scene scene_of(std::span<const std::string> row) {
        Scene scene = task_.given.with(row);
        for (OwnTerm& term : scene.own_terms) term.formula = told(std::move(term.formula));
        for (OwnLimit& limit : scene.own_limits) limit.formula = told(std::move(limit.formula));
        return scene;
    }

    MotionFormula told(MotionFormula formula) {
        return [this, own = std::move(formula)](const MotionPoint& point) {
            try {
                return own(point);
            } catch (...) {
                fail();
                throw;
            }
        };
    }

    /// In a handler: ends the sweep with the exception at hand, the first of them.
    void fail() {
        const std::lock_guard lock(mutex_);
        if (!failure_) failure_ = std::current_exception();
        failed_ = true;
    }

    /// A row during which the sweep was stopped is perhaps stopped halfway.
    void add(const SweepRow& row) {
        const std::lock_guard lock(mutex_);
        if (watch_.stopped()) return;
        rows_.push_back(row);
        news_.notify_one();
    }

    void wait() {
        constexpr std::chrono::milliseconds patience{20};
        std::unique_lock lock(mutex_);
        std::size_t told = 0;
        while (working_ > 0) {
            news_.wait_for(lock, patience);
            const std::size_t done = rows_.size();
            lock.unlock();
            watch_.look_for_signals();
            if (done > told) watch_.tell(done, static_cast<std::size_t>(task_.plan.rows()));
            told = done;
            lock.lock();
        }
    }

    const SweepTask& task_;
    Watch& watch_;
    Chunking chunking_;
    std::atomic<int> next_{0};
    std::atomic<bool> failed_{false};
    std::mutex mutex_;
    std::condition_variable news_;
    std::vector<SweepRow> rows_;
    std::exception_ptr failure_;
    int working_ = 0;
};

}  // namespace

SweepTable solve_sweep(const SweepTask& task, Watch& watch) {
    SweepScenes scenes(task.plan, [&](std::span<const std::string> row) { return task.given.with(row); });
    SweepTable table;
    table.columns = check_rows(scenes);
    table.rows = Crew(task, watch).run();
    return table;
}

}  // namespace camopt::python
