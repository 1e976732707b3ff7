// SPDX-License-Identifier: MIT
// Common code of all backends: the table of native options and its validation, the validation of arguments,
// and the guard between the library's frames and the Nlp (wall clock, stop request, exceptions, values that
// are not finite). For code inside solvers/; users need registry.hpp.
#pragma once

#include "solvers/registry.hpp"

#include <exception>

namespace camopt {

/// Values allowed for a number: [minimum, maximum], or (minimum, maximum] where `minimum_excluded`.
struct NumberRange {
    double minimum = -infinity, maximum = infinity;
    bool minimum_excluded = false;
};
inline constexpr NumberRange positive{0.0, infinity, true};
inline constexpr NumberRange not_negative{0.0, infinity, false};

/// `default_value` of the numbers is text, because many depend on the problem ("tolerance / 100").
[[nodiscard]] NativeOption flag_option(std::string name, std::string default_value, std::string meaning);
[[nodiscard]] NativeOption integer_option(std::string name, std::string default_value, NumberRange range,
                                          std::string meaning);
[[nodiscard]] NativeOption number_option(std::string name, std::string default_value, NumberRange range,
                                         std::string meaning);
[[nodiscard]] NativeOption text_option(std::string name, std::string default_value,
                                       std::initializer_list<const char*> choices, std::string meaning);

/// Throws InputError for an option that the entry does not list, or a value outside its kind or range.
void check_native_options(const SolverEntry& entry, const std::map<std::string, OptionValue>& options);

/// The value of a native number (an integer is taken too) or integer, or the default.
[[nodiscard]] double number_or(const BackendOptions& options, const std::string& name, double otherwise);

/// The preconditions of every backend. Throws InputError for options (validate(), the native ones) and for a
/// start of the wrong size or with entries that are not finite; ModelError for a shape whose sizes do not
/// match or whose bounds are NaN.
void check_backend_input(const SolverEntry& entry, const Nlp& problem, const Eigen::VectorXd& start,
                         const BackendOptions& options);

/// A finished result (infeasible) where some lower bound is above its upper bound: libraries differ on those.
[[nodiscard]] std::optional<BackendResult> result_of_crossed_bounds(const Nlp& problem);

[[noreturn]] void throw_unavailable(const SolverEntry& entry);

/// Wraps all evaluations of a backend. The first reason to stop is stored. Virtual is what a backend in a
/// separate part (core/platform/parts.hpp) calls here, because the part does not contain it.
class SolveGuard {
 public:
    SolveGuard(const BackendOptions& options, const SolveControl& control);
    virtual ~SolveGuard() = default;
    SolveGuard(const SolveGuard&) = delete;
    SolveGuard& operator=(const SolveGuard&) = delete;

    /// Polls the clock and the stop request; true once there is any reason to stop. Never throws.
    [[nodiscard]] virtual bool must_stop() noexcept;
    [[nodiscard]] bool stopping() const noexcept { return reason_.has_value(); }

    /// Calls the function unless an exception is pending; false if it throws (stored for rethrow()).
    template <class Function>
    [[nodiscard]] bool call(Function&& function) noexcept {
        if (exception_) return false;
        try {
            std::forward<Function>(function)();
            return true;
        } catch (...) {
            keep_exception(std::current_exception());
            return false;
        }
    }
    /// The backend must stop for this reason.
    void stop(Termination reason) noexcept {
        if (!reason_) reason_ = reason;
    }
    /// One short line for control.progress, at most every half second. Never throws.
    virtual void report(int iteration, double cost, double violation) noexcept;

    /// Throws the stored exception, if any.
    void rethrow() const {
        if (exception_) std::rethrow_exception(exception_);
    }
    [[nodiscard]] std::optional<Termination> reason() const noexcept { return reason_; }
    /// > 0 for a deadline in the past too: 1e-3.
    [[nodiscard]] double seconds_left() const { return std::max(1e-3, deadline_.seconds_left()); }

 private:
    virtual void keep_exception(std::exception_ptr exception) noexcept;

    const SolveControl& control_;
    Deadline deadline_;
    Stopwatch since_report_;
    std::optional<Termination> reason_;
    std::exception_ptr exception_;
};

}  // namespace camopt
