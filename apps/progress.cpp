// SPDX-License-Identifier: MIT
#include "apps/progress.hpp"

#include "core/text/printable.hpp"

#include <cstdio>
#include <unistd.h>

namespace camopt::apps {

namespace {

constexpr const char* wipe_line = "\r\033[K";

bool on_terminal() {
    return ::isatty(STDERR_FILENO) == 1;
}

}  // namespace

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

}  // namespace camopt::apps
