// SPDX-License-Identifier: MIT
#include "apps/terminal.hpp"

#include "core/text/printable.hpp"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>
#include <unistd.h>

namespace camopt::apps {

namespace {

/// Closing a copy asks the file system as closing the stream itself would: some report a full disk only then.
bool is_taken() {
    const int copy = ::dup(STDOUT_FILENO);
    return copy >= 0 && ::close(copy) == 0;
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

}  // namespace camopt::apps
