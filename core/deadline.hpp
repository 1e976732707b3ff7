// SPDX-License-Identifier: MIT
// A deadline: one time limit and one stopwatch for everything that runs under it.
//
// It is created once, where the time begins, and passed by value. Copies and the parts made by sooner() share
// one flag: once passed() returns true, the caller takes another path, so the result depends on the machine's
// speed exactly where was_felt().
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

/// Seconds since it was made.
class Stopwatch {
 public:
    Stopwatch();
    [[nodiscard]] double seconds() const;

 private:
    double begin_;
};

class Deadline {
 public:
    using Clock = std::function<double()>;  ///< seconds from any origin, never falling

    Deadline() = default;  ///< never passes
    /// `seconds` from now. A deadline of another clock than the machine's steady one is for tests.
    [[nodiscard]] static Deadline after(double seconds, Clock clock = {});

    /// Reads the clock; a true result is remembered.
    [[nodiscard]] bool passed() const;
    /// >= 0; infinite without a deadline.
    [[nodiscard]] double seconds_left() const;
    /// This, or `seconds` from now if that is earlier.
    [[nodiscard]] Deadline sooner(double seconds) const;
    /// These seconds do not count, for this one, its copies and its parts: another solve ran meanwhile.
    void leave_out(double seconds) const;
    /// Whether this one, a copy or a part of it has reported that it passed.
    [[nodiscard]] bool was_felt() const;

 private:
    struct Shared;
    std::shared_ptr<Shared> shared_;  ///< none: never passes
    double end_ = 0.0;                ///< by the clock
};

}  // namespace camopt
