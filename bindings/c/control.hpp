// SPDX-License-Identifier: MIT
// A caller's callbacks around a solve or a sweep.
#pragma once

#include "bindings/c/camopt.h"
#include "solvers/solver.hpp"

#include <chrono>
#include <exception>

namespace camopt::c {

/// What a callback throws never crosses the frames of solvers: it is kept, the search is stopped, and
/// finish() throws it on as a Failure. Belongs to the thread that solves; must outlive its control().
class CallbackControl {
 public:
    explicit CallbackControl(const camopt_solve_options& options) : options_(options) {}
    CallbackControl(const CallbackControl&) = delete;
    CallbackControl& operator=(const CallbackControl&) = delete;

    [[nodiscard]] SolveControl control();

    /// Calls `work`, a callback of the caller, unless one has thrown before.
    template <class Work>
    void call(Work&& work) noexcept {
        if (thrown_) return;
        try {
            work();
        } catch (...) {
            thrown_ = std::current_exception();
        }
    }

    /// A callback wanted an end or threw: nothing more is to be begun.
    [[nodiscard]] bool stopped() const { return stopped_ || thrown_; }
    void stop() { stopped_ = true; }

    [[nodiscard]] double seconds() const;

    /// Throws Failure (CALLBACK) where a callback threw.
    void finish() const;

 private:
    camopt_solve_options options_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
    std::exception_ptr thrown_;
    bool stopped_ = false;

    [[nodiscard]] bool asked_to_stop();
    void report(const Progress& progress);
};

}  // namespace camopt::c
