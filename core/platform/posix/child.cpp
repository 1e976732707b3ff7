// SPDX-License-Identifier: MIT
#include "core/platform/child.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <mutex>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace camopt {

namespace {

constexpr int patience_milliseconds = 50;  // between two questions whether to stop

enum class Kind { told, done, finished, wrong_input, error };

/// One packet of the line: these, then the text of an error.
struct Head {
    Kind kind = Kind::told;
    int number = 0;
};
constexpr std::size_t longest_packet = 4096;

/// In the child. Ends it where no one is there any more.
void say(int line, const Head& head, std::string_view text = {}) {
    std::array<char, longest_packet> packet{};
    const std::size_t length = std::min(text.size(), packet.size() - sizeof head);
    std::memcpy(packet.data(), &head, sizeof head);
    std::copy_n(text.begin(), length, packet.begin() + sizeof head);
    ssize_t sent = -1;
    do {
        sent = ::send(line, packet.data(), sizeof head + length, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    if (sent < 0) ::_exit(0);
}

/// The whole life of a child. _exit, not exit: what the parent has in its buffers is the parent's to write.
[[noreturn]] void live(const Child& child, int line, pid_t parent) {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
    // Between fork and this call the parent may have died: then no one would tell.
    if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent) ::_exit(0);
    try {
        child.work(
            [line](int number) {
                say(line, {Kind::told, number});
            },
            [line](int number) {
                say(line, {Kind::done, number});
            });
        say(line, {Kind::finished});
    } catch (const InputError& error) {
        say(line, {Kind::wrong_input}, error.what());
    } catch (const std::exception& error) {
        say(line, {Kind::error}, error.what());
    }
    ::_exit(0);
}

class Process {
 public:
    explicit Process(const Child& child) {
        // A child that another thread forks meanwhile would hold the far end of this line open.
        static std::mutex one_at_a_time;
        const std::lock_guard lock(one_at_a_time);
        std::array<int, 2> ends{};
        if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
            throw std::system_error(errno, std::generic_category(), "cannot make a line to a worker");
        std::fflush(nullptr);
        const pid_t parent = ::getpid();
        process_ = ::fork();
        const int reason = errno;
        if (process_ == 0) {
            ::close(ends[0]);
            live(child, ends[1], parent);
        }
        ::close(ends[1]);
        line_ = ends[0];
        if (process_ > 0) return;
        ::close(line_);
        throw std::system_error(reason, std::generic_category(), "cannot start a worker");
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;
    ~Process() {
        if (process_ > 0) (void)end();
        ::close(line_);
    }

    /// Something is there to be read, perhaps the end.
    [[nodiscard]] bool has_news() const {
        pollfd line{line_, POLLIN, 0};
        return ::poll(&line, 1, patience_milliseconds) > 0;
    }
    /// None: it hung up.
    [[nodiscard]] std::optional<std::pair<Head, std::string>> listen() const {
        std::array<char, longest_packet> packet{};
        ssize_t size = -1;
        do {
            size = ::recv(line_, packet.data(), packet.size(), 0);
        } while (size < 0 && errno == EINTR);
        Head head;
        if (size < static_cast<ssize_t>(sizeof head)) return std::nullopt;
        std::memcpy(&head, packet.data(), sizeof head);
        return std::pair(head, std::string(packet.data() + sizeof head, packet.data() + size));
    }
    /// Kills it; if it is dead nothing changes.
    std::string end() {
        ::kill(process_, SIGKILL);
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        return WIFSIGNALED(status) ? fmt::format("worker died: signal {}", WTERMSIG(status))
                                   : fmt::format("worker died: exit code {}", WEXITSTATUS(status));
    }

 private:
    pid_t process_ = -1;
    int line_ = -1;
};

}  // namespace

bool can_run_children() {
    return true;
}

std::optional<std::string> run_in_child(const Child& child) {
    Process process(child);
    while (!child.stop || !child.stop()) {
        if (!process.has_news()) continue;
        const auto news = process.listen();
        if (!news) return process.end();
        const auto& [head, text] = *news;
        switch (head.kind) {
            case Kind::told:
                if (child.told) child.told(head.number);
                break;
            case Kind::done:
                if (child.done) child.done(head.number);
                break;
            case Kind::finished:
                return std::nullopt;
            case Kind::wrong_input:
                throw InputError(text);
            case Kind::error:
                throw std::runtime_error(text);
        }
    }
    return std::nullopt;
}

}  // namespace camopt
