// SPDX-License-Identifier: MIT
#include "tests/soak/run/worker_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <poll.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace camopt::soak {

namespace {

using Clock = Patience::Clock;

struct Running {
    int number = 0;
    pid_t child = -1;
    int in = -1;
    std::string rest;  ///< of a line that is not complete yet
    Patience patience;
    bool killed = false;
};

[[noreturn]] void run_child(const Worker& worker, int number, int out) {
    const auto tell = [out](const std::string& line) {
        std::size_t written = 0;
        while (written < line.size()) {
            const ssize_t step = ::write(out, line.data() + written, line.size() - written);
            if (step <= 0) ::_exit(3);  // nobody listens
            written += static_cast<std::size_t>(step);
        }
    };
    int code = 0;
    try {
        worker.work(number, tell);
    } catch (...) {
        code = 4;
    }
    ::_exit(code);  // nothing of the parent's is to be torn down here
}

Running started(const Worker& worker, int number) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe for a worker process");
    std::fflush(nullptr);  // or the child would print it again
    const pid_t child = ::fork();
    if (child < 0) throw std::runtime_error("no worker process");
    if (child == 0) {
        ::close(ends[0]);
        run_child(worker, number, ends[1]);
    }
    ::close(ends[1]);
    return {number, child, ends[0], {}, Patience(Clock::now()), false};
}

void hear(Running& running, const Worker& worker, const char* text, std::size_t size) {
    running.rest.append(text, size);
    std::size_t begin = 0;
    for (auto end = running.rest.find('\n'); end != std::string::npos; end = running.rest.find('\n', begin)) {
        worker.heard(running.number, running.rest.substr(begin, end - begin));
        begin = end + 1;
    }
    running.rest.erase(0, begin);
}

std::string fault_of(const Running& running) {
    int status = 0;
    ::waitpid(running.child, &status, 0);
    if (running.killed) return "hung and was killed";
    if (WIFSIGNALED(status)) return fmt::format("died of signal {}", WTERMSIG(status));
    if (WEXITSTATUS(status) != 0) return fmt::format("ended with status {}", WEXITSTATUS(status));
    return {};
}

/// True: its end of the pipe is closed.
bool read_some(Running& running, const Worker& worker) {
    std::array<char, 65536> buffer{};
    const ssize_t count = ::read(running.in, buffer.data(), buffer.size());
    if (count <= 0) return true;
    hear(running, worker, buffer.data(), static_cast<std::size_t>(count));
    return false;
}

}  // namespace

void run_in_processes(int count, int jobs, double most_seconds, const Worker& worker) {
    const auto budget = std::chrono::milliseconds(static_cast<long>(1000 * most_seconds));
    std::vector<Running> all;
    int next = 0;
    while (next < count || !all.empty()) {
        while (next < count && static_cast<int>(all.size()) < jobs) {
            all.push_back(started(worker, next));
            ++next;
        }
        std::vector<pollfd> ready;
        for (const Running& running : all) ready.push_back({running.in, POLLIN, 0});
        ::poll(ready.data(), ready.size(), static_cast<int>(Patience::turn.count()));
        const Clock::time_point now = Clock::now();
        for (std::size_t k = all.size(); k-- > 0;) {
            Running& running = all[k];
            running.patience.look(now);
            if (!running.killed && running.patience.waited() > budget) {
                running.killed = true;
                ::kill(running.child, SIGKILL);
            }
            if ((ready[k].revents & (POLLIN | POLLHUP)) == 0 || !read_some(running, worker)) continue;
            ::close(running.in);
            worker.ended(running.number, fault_of(running));
            all.erase(all.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
}

}  // namespace camopt::soak
