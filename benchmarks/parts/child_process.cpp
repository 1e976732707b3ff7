// SPDX-License-Identifier: MIT
#include "benchmarks/parts/child_process.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace camopt::benchmarks {

namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void run_child(const std::function<std::string()>& work, int out) {
    int code = 1;
    try {
        const std::string text = work();
        std::size_t written = 0;
        while (written < text.size()) {
            const ssize_t step = ::write(out, text.data() + written, text.size() - written);
            if (step <= 0) break;
            written += static_cast<std::size_t>(step);
        }
        code = written == text.size() ? 0 : 1;
    } catch (...) {  // told by the code
    }
    std::fflush(nullptr);
    ::_exit(code);  // nothing of the parent's is to be torn down here
}

/// Everything until the other end closes; false at the deadline.
bool read_all(int in, Clock::time_point deadline, std::string& text) {
    std::array<char, 4096> buffer{};
    while (true) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
        if (left.count() <= 0) return false;
        pollfd ready{in, POLLIN, 0};
        if (::poll(&ready, 1, static_cast<int>(left.count())) <= 0) continue;
        const ssize_t count = ::read(in, buffer.data(), buffer.size());
        if (count <= 0) return true;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

}  // namespace

std::optional<std::string> text_of_child(const std::function<std::string()>& work, double most_seconds) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return {};
    std::fflush(nullptr);  // or the child would print it again
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        run_child(work, ends[1]);
    }
    ::close(ends[1]);
    std::string text;
    const auto budget = std::chrono::milliseconds(static_cast<long>(1000 * most_seconds));
    const bool ended = child > 0 && read_all(ends[0], Clock::now() + budget, text);
    ::close(ends[0]);
    if (child < 0) return {};
    if (!ended) ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (!ended || !WIFEXITED(status) || WEXITSTATUS(status) != 0) return {};
    return text;
}

}  // namespace camopt::benchmarks
