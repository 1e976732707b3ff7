// SPDX-License-Identifier: MIT
#include "core/platform/console.hpp"

#include <atomic>
#include <csignal>
#include <spawn.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace camopt {

namespace {

// A signal handler can reach nothing but a variable of the program; this one belongs to this file alone.
std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

// sigaction has put the default handler back (SA_RESETHAND): a second Ctrl-C kills.
extern "C" void note_interrupt(int) {
    was_interrupted = true;
}

/// What the caller has told this program to ignore (nohup) stays ignored.
bool is_ignored(int signal) {
    struct sigaction now {};
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

std::vector<std::string> program_words(int count, char** words) {
    return {words, words + count};
}

bool error_is_terminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

bool output_is_taken() {
    const int copy = ::dup(STDOUT_FILENO);
    return copy >= 0 && ::close(copy) == 0;
}

std::filesystem::path program_folder() {
    std::error_code error;
    return std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
}

bool open_in_browser(const std::filesystem::path& page) {
    std::string program = "xdg-open", address = page.string();
    std::array<char*, 3> words = {program.data(), address.data(), nullptr};
    ::pid_t child = 0;
    int status = 0;
    return ::posix_spawnp(&child, program.c_str(), nullptr, nullptr, words.data(), environ) == 0 &&
           ::waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

InterruptWatch::InterruptWatch(Signals signals) {
    was_interrupted = false;
    struct sigaction action {};
    action.sa_handler = note_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    if (signals == Signals::hangup_too && !is_ignored(SIGHUP)) sigaction(SIGHUP, &action, nullptr);
}

InterruptWatch::~InterruptWatch() {
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_DFL);
    if (!is_ignored(SIGHUP)) std::signal(SIGHUP, SIG_DFL);
}

bool InterruptWatch::interrupted() {
    return was_interrupted;
}

}  // namespace camopt
