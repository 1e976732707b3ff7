// SPDX-License-Identifier: MIT
// A line on the standard error now and then while trials run: every second on a terminal, where it is written
// over, else after a pause.
#pragma once

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <unistd.h>

namespace camopt::soak {

class Progress {
 public:
    /// seconds: between two lines where the standard error is no terminal.
    explicit Progress(double seconds) : pause_(terminal_ ? 1.0 : seconds) {}
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    Progress(Progress&&) = delete;
    Progress& operator=(Progress&&) = delete;
    ~Progress() { end(); }

    /// Whether the pause is over; the next one begins then.
    [[nodiscard]] bool is_due() {
        const auto now = std::chrono::steady_clock::now();
        if (std::chrono::duration<double>(now - last_).count() < pause_) return false;
        last_ = now;
        return true;
    }
    void tell(const std::string& line) const {
        fmt::print(stderr, "{}{}{}", terminal_ ? "\r" : "", line, terminal_ ? "" : "\n");
        std::fflush(stderr);
    }
    /// What follows stands on a new line.
    void end() {
        if (terminal_ && !ended_) fmt::print(stderr, "\n");
        ended_ = true;
    }

 private:
    bool terminal_ = ::isatty(STDERR_FILENO) != 0, ended_ = false;
    double pause_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace camopt::soak
