// SPDX-License-Identifier: MIT
#include "core/platform/workers.hpp"

#include "core/platform/child.hpp"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>

namespace camopt {

namespace {

constexpr std::chrono::milliseconds patience{50};  // between two looks at what is not news
constexpr int most_deaths = 2;                     // of one unit

/// News comes by the thousand; a progress line is read by a person.
class Ticks {
 public:
    explicit Ticks(const std::function<void()>& tick) : tick_(tick) {}
    void tick() {
        const auto now = std::chrono::steady_clock::now();
        if (!tick_ || now - last_ < patience) return;
        last_ = now;
        tick_();
    }

 private:
    const std::function<void()>& tick_;
    std::chrono::steady_clock::time_point last_;
};

class Crew {
 public:
    explicit Crew(const PoolTask& task)
        : task_(task),
          fenced_(task.fence != Fence::none && can_run_children()),
          waiting_(task.units.begin(), task.units.end()) {}

    PoolOutcome run() {
        const std::size_t count = std::min(static_cast<std::size_t>(task_.workers), waiting_.size());
        busy_ = count;
        std::vector<std::thread> threads;
        try {
            while (threads.size() < count) threads.emplace_back([this] { live(); });
            follow();
        } catch (...) {  // of a callback: the threads must end before it goes on
            fail();
        }
        for (std::thread& thread : threads) thread.join();
        if (fault_) std::rethrow_exception(fault_);
        hear();
        if (task_.tick) task_.tick();
        return ending_ ? PoolOutcome::stopped : PoolOutcome::finished;
    }

 private:
    void follow() {
        Ticks ticks(task_.tick);
        while (!hear()) {
            ticks.tick();
            if (task_.stop_requested && task_.stop_requested()) ending_ = true;
        }
    }

    /// True: no thread works any more.
    bool hear() {
        std::unique_lock lock(mutex_);
        something_new_.wait_for(lock, patience, [this] { return !news_.empty() || busy_ == 0; });
        const std::vector<News> news = std::exchange(news_, {});
        const bool all_done = busy_ == 0;
        lock.unlock();
        for (const News& one : news) {
            if (!one.cause_of_death.empty())
                task_.lost(one.number, one.cause_of_death);
            else if (task_.told)
                task_.told(one.number);
        }
        return all_done;
    }

    void live() {
        try {
            while (const std::optional<int> unit = next())
                if (fenced_)
                    do_in_child(*unit);
                else
                    task_.work(*unit, [this](int number) { tell({number, {}}); });
        } catch (...) {
            fail();
        }
        const std::lock_guard lock(mutex_);
        --busy_;
        something_new_.notify_one();
    }

    void do_in_child(int unit) {
        Child child;
        child.work = [&](const std::function<void(int)>& say, const auto&) {
            if (task_.begin_child) task_.begin_child();
            task_.work(unit, say);
        };
        child.told = [this](int number) { tell({number, {}}); };
        child.stop = [this] { return ending_.load(); };
        std::optional<std::string> death;
        for (int deaths = 0; deaths < most_deaths; ++deaths)
            if (death = run_in_child(child); !death) return;
        tell({unit, *death});
    }

    std::optional<int> next() {
        const std::lock_guard lock(mutex_);
        if (waiting_.empty() || ending_) return std::nullopt;
        const int unit = waiting_.front();
        waiting_.pop_front();
        return unit;
    }

    struct News {
        int number = 0;
        std::string cause_of_death;  ///< of a unit; empty: the number was told
    };
    void tell(News news) {
        const std::lock_guard lock(mutex_);
        news_.push_back(std::move(news));
        something_new_.notify_one();
    }

    /// In a handler: the first exception ends the run.
    void fail() {
        const std::lock_guard lock(mutex_);
        if (!fault_) fault_ = std::current_exception();
        ending_ = true;
    }

    const PoolTask& task_;
    bool fenced_;
    std::atomic<bool> ending_{false};
    std::mutex mutex_;
    std::condition_variable something_new_;
    std::deque<int> waiting_;
    std::vector<News> news_;
    std::size_t busy_ = 0;
    std::exception_ptr fault_;
};

/// Threads of one child. What a crash leaves is done one by one, so that it takes no other unit with it.
PoolOutcome run_in_one_child(const PoolTask& task) {
    PoolTask rest = task;
    rest.fence = Fence::around_each;
    bool stopped = false;
    Ticks ticks(task.tick);
    Child child;
    child.work = [&](const std::function<void(int)>& tell, const std::function<void(int)>& done) {
        if (task.begin_child) task.begin_child();
        PoolTask inside;
        inside.units = task.units;
        inside.workers = task.workers;
        inside.work = [&](int unit, const auto&) {
            task.work(unit, tell);
            done(unit);
        };
        (void)Crew(inside).run();
    };
    child.told = task.told;
    child.done = [&](int unit) { std::erase(rest.units, unit); };
    child.stop = [&] {
        ticks.tick();
        stopped = stopped || (task.stop_requested && task.stop_requested());
        return stopped;
    };
    const bool died = run_in_child(child).has_value();
    if (stopped) return PoolOutcome::stopped;
    return died ? Crew(rest).run() : PoolOutcome::finished;
}

}  // namespace

PoolOutcome run_workers(const PoolTask& task) {
    const bool in_one_child = task.fence == Fence::around_all && can_run_children() && !task.units.empty();
    return in_one_child ? run_in_one_child(task) : Crew(task).run();
}

}  // namespace camopt
