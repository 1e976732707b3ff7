// SPDX-License-Identifier: MIT
// The interpreter during a solve: Ctrl-C and progress callbacks, while the interpreter's lock is released.
#pragma once

#include <atomic>
#include <camopt/solver.hpp>
#include <chrono>
#include <optional>
#include <pybind11/pybind11.h>
#include <string>
#include <utility>

namespace camopt::python {

namespace py = pybind11;

/// What a callback is told: a camopt::Progress that outlives the call.
struct ProgressValue {
    std::string message;
    std::optional<int> round;
    std::optional<double> incumbent, bound, violation;
};

/// Made and destroyed with the interpreter's lock held; the solve runs in between without it. What a callback
/// or a signal handler raises stops the solve and is kept until raise_what_came().
class Watch {
 public:
    /// progress: a callable, or None.
    explicit Watch(py::object progress) : progress_(std::move(progress)) {}
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    /// For a solve on the thread that made the watch. Asks for signals at most every 20 ms.
    [[nodiscard]] SolveControl control();

    /// Any thread may ask: whether something was raised.
    [[nodiscard]] bool stopped() const { return stopped_; }
    /// Takes the lock and runs the interpreter's signal handlers; whether anything was raised, now or before.
    bool look_for_signals();
    /// Takes the lock; calls the callback with these arguments, where there is one and nothing was raised.
    template <typename... Arguments>
    void tell(Arguments&&... arguments) {
        if (stopped_ || !wants_progress()) return;
        const py::gil_scoped_acquire lock;
        try {
            progress_(std::forward<Arguments>(arguments)...);
        } catch (py::error_already_set& error) {
            keep(error);
        }
    }
    [[nodiscard]] bool wants_progress() const { return !progress_.is_none(); }
    /// Keeps an exception of Python for raise_what_came(), the first one only. With the lock held.
    void keep(py::error_already_set& error);

    /// With the lock held: throws what was kept; `found`, what the solve had until then, is its attribute
    /// `name`.
    void raise_what_came(const char* name, const py::object& found);

 private:
    using Clock = std::chrono::steady_clock;

    py::object progress_;
    py::object raised_ = py::none();
    std::atomic<bool> stopped_{false};
    Clock::time_point looked_{};
};

}  // namespace camopt::python
