// SPDX-License-Identifier: MIT
#include "core/deadline.hpp"

#include <atomic>
#include <chrono>

namespace camopt {

namespace {

double steady_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Stopwatch::Stopwatch() : begin_(steady_seconds()) {}

double Stopwatch::seconds() const {
    return steady_seconds() - begin_;
}

struct Deadline::Shared {
    Clock clock;
    std::atomic<double> left_out{0.0};
    std::atomic<bool> felt{false};

    /// Seconds by the clock that count.
    [[nodiscard]] double counted() const { return clock() - left_out; }
};

Deadline Deadline::after(double seconds, Clock clock) {
    Deadline deadline;
    deadline.shared_ = std::make_shared<Shared>();
    deadline.shared_->clock = clock ? std::move(clock) : Clock(steady_seconds);
    deadline.end_ = deadline.shared_->counted() + seconds;
    return deadline;
}

bool Deadline::passed() const {
    if (!shared_ || shared_->counted() < end_) return false;
    shared_->felt = true;
    return true;
}

double Deadline::seconds_left() const {
    if (!shared_) return std::numeric_limits<double>::infinity();
    return std::max(0.0, end_ - shared_->counted());
}

Deadline Deadline::sooner(double seconds) const {
    if (!shared_) return after(seconds);
    Deadline part = *this;
    part.end_ = std::min(end_, shared_->counted() + seconds);
    return part;
}

void Deadline::leave_out(double seconds) const {
    if (!shared_) return;
    double before = shared_->left_out;
    while (!shared_->left_out.compare_exchange_weak(before, before + seconds)) {
    }
}

bool Deadline::was_felt() const {
    return shared_ && shared_->felt;
}

}  // namespace camopt
