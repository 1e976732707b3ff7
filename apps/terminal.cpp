// SPDX-License-Identifier: MIT
#include "apps/terminal.hpp"

#include "core/text/printable.hpp"

#include <cstdio>

namespace camopt::apps {

void print(std::string_view text) {
    std::fputs(printable_lines(text).c_str(), stdout);
}

void print_error(std::string_view text) {
    std::fputs(printable_lines(text).c_str(), stderr);
}

}  // namespace camopt::apps
