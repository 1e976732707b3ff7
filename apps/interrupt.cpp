// SPDX-License-Identifier: MIT
#include "apps/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace camopt::apps {

namespace {

// A signal handler can reach nothing but a variable of the program; this one belongs to this file alone.
std::atomic<bool> was_interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

// sigaction has put the default handler back (SA_RESETHAND): a second Ctrl-C kills.
extern "C" void note_interrupt(int) {
    was_interrupted = true;
}

}  // namespace

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
