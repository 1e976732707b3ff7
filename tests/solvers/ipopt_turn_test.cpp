// SPDX-License-Identifier: MIT
// Ipopt's solves take turns. Waiting for one is not part of a solve's time, and can be stopped.
#include "solvers/registry.hpp"
#include "solvers/test_problems.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <thread>

namespace camopt {
namespace ipopt_turn_test {

using namespace std::chrono_literals;

bool has_ipopt() {
    return std::ranges::any_of(
        solver_entries(), [](const SolverEntry& entry) { return entry.name == "ipopt" && entry.available; });
}

/// A solve that keeps Ipopt's turn until it is let go.
class Holder {
 public:
    Holder() {
        control_.stop_requested = [this] {
            holds_ = true;
            while (!let_go_) std::this_thread::sleep_for(1ms);
            return true;
        };
        thread_ = std::thread([this] {
            const test::KnownProblem problem = test::hs71();
            (void)make_solver("ipopt")->minimize(*problem.nlp, problem.start, {}, control_);
        });
        while (!holds_) std::this_thread::sleep_for(1ms);
    }
    ~Holder() {
        let_go();
        thread_.join();
    }
    Holder(const Holder&) = delete;
    Holder& operator=(const Holder&) = delete;
    void let_go() { let_go_ = true; }

 private:
    std::atomic<bool> holds_{false}, let_go_{false};
    SolveControl control_;
    std::thread thread_;
};

BackendResult solved_with(const SolveControl& control, double seconds) {
    const test::KnownProblem problem = test::hs71();
    BackendOptions options;
    options.max_seconds = seconds;
    return make_solver("ipopt")->minimize(*problem.nlp, problem.start, options, control);
}

TEST(IpoptTurn, WaitingDoesNotCount) {
    if (!has_ipopt()) GTEST_SKIP() << "this build has no Ipopt";
    Holder holder;
    SolveControl control;
    control.deadline = Deadline::after(0.3);
    auto waiting = std::async(std::launch::async, [&] { return solved_with(control, 0.3); });
    EXPECT_EQ(waiting.wait_for(400ms), std::future_status::timeout);  // longer than all the time it has
    holder.let_go();
    EXPECT_EQ(waiting.get().termination, Termination::converged);
    EXPECT_FALSE(control.deadline.was_felt());
    EXPECT_GT(control.deadline.seconds_left(), 0.0);
}

TEST(IpoptTurn, WaitingCanBeStopped) {
    if (!has_ipopt()) GTEST_SKIP() << "this build has no Ipopt";
    const Holder holder;
    SolveControl control;
    std::atomic<bool> stop{false};
    control.stop_requested = [&] { return stop.load(); };
    auto waiting = std::async(std::launch::async, [&] { return solved_with(control, 60.0); });
    EXPECT_EQ(waiting.wait_for(50ms), std::future_status::timeout);
    stop = true;
    ASSERT_EQ(waiting.wait_for(10s), std::future_status::ready);
    const BackendResult result = waiting.get();
    EXPECT_EQ(result.termination, Termination::interrupted);
    EXPECT_EQ(result.x.size(), 0);
}

}  // namespace ipopt_turn_test
}  // namespace camopt
