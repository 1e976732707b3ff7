// SPDX-License-Identifier: MIT
// Until when: one value for everything that is done under one limit of time, and one stopwatch.
//
// It is made once, where the time begins, and handed on by value. Copies, and the parts that sooner() cuts
// off, share whether any of them was ever in the way: what asks passed() and hears yes goes another way than
// it would have, so a result depends on the machine's speed only where was_felt().
#pragma once

#include <functional>
#include <memory>

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

    /// Asks the clock; a yes is remembered.
    [[nodiscard]] bool passed() const;
    /// >= 0; infinite where there is no end.
    [[nodiscard]] double seconds_left() const;
    /// This, or so many seconds from now where that is earlier.
    [[nodiscard]] Deadline sooner(double seconds) const;
    /// So many seconds do not count, for this one, its copies and its parts: they went by while another solve
    /// had its turn.
    void leave_out(double seconds) const;
    /// Whether this one, a copy or a part of it has told anybody to stop.
    [[nodiscard]] bool was_felt() const;

 private:
    struct Shared;
    std::shared_ptr<Shared> shared_;  ///< none: never passes
    double end_ = 0.0;                ///< by the clock
};

}  // namespace camopt
