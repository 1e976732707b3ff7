// SPDX-License-Identifier: MIT
#include "apps/terminal.hpp"

#include "core/text/printable.hpp"

#include <cerrno>
#include <cstdio>
#include <system_error>

namespace camopt::apps {

namespace {

constexpr const char* wipe_line = "\r\033[K";

}  // namespace

void print(std::string_view text) {
    const std::string shown = printable_lines(text);
    if (std::fwrite(shown.data(), 1, shown.size(), stdout) != shown.size() || std::fflush(stdout) != 0 ||
        !output_is_taken())
        throw std::system_error(errno, std::generic_category(), "cannot write to standard output");
}

std::string written_lines(const std::vector<std::filesystem::path>& paths) {
    std::string text;
    for (const std::filesystem::path& path : paths) text += "  wrote " + path.string() + "\n";
    return text;
}

void print_error(std::string_view text) {
    std::fputs(printable_lines(text).c_str(), stderr);
}

std::function<void(std::string_view)> terminal_progress() {
    if (!error_is_terminal()) return {};
    return [](std::string_view message) {
        std::fputs((wipe_line + printable(message)).c_str(), stderr);
        std::fflush(stderr);
    };
}

void end_progress() {
    if (error_is_terminal()) std::fputs(wipe_line, stderr);
}

}  // namespace camopt::apps
