// SPDX-License-Identifier: MIT
#include "apps/terminal.hpp"

#include "core/text/printable.hpp"

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>
#include <unistd.h>

namespace camopt::apps {

namespace {

/// Closing a copy asks the file system as closing the stream itself would: some report a full disk only then.
bool is_taken() {
    const int copy = ::dup(STDOUT_FILENO);
    return copy >= 0 && ::close(copy) == 0;
}

constexpr const char* wipe_line = "\r\033[K";

bool on_terminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

// A signal handler can reach nothing but a variable of the program; this one belongs to this file alone.
std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

// sigaction has put the default handler back (SA_RESETHAND): a second Ctrl-C kills.
extern "C" void note_interrupt(int) {
    was_interrupted = true;
}

}  // namespace

void print(std::string_view text) {
    const std::string shown = printable_lines(text);
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() || std::fflush(stdout) != 0 ||
        !is_taken())
        throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
}

void print_error(std::string_view text) {
    std::fputs(printable_lines(text).c_str(), stderr);
}

std::function<void(std::string_view)> terminal_progress() {
    if (!on_terminal()) return {};
    return [](std::string_view message) {
        std::fputs((wipe_line + printable(message)).c_str(), stderr);
        std::fflush(stderr);
    };
}

void end_progress() {
    if (on_terminal()) std::fputs(wipe_line, stderr);
}

InterruptWatch::InterruptWatch(Signals signals) {
    was_interrupted = false;
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    if (signals == Signals::termination_too) sigaction(SIGTERM, &action, nullptr);
}

InterruptWatch::~InterruptWatch() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
}

bool InterruptWatch::interrupted() {
    return was_interrupted;
}

}  // namespace camopt::apps
