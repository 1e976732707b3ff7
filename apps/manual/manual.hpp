// SPDX-License-Identifier: MIT
// The manual page camopt.1, from the commands and options themselves and the table of keys: `camopt __manual`
// prints it, the build writes it to a file.
#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace camopt::apps {

/// In the man macros of roff, UTF-8.
[[nodiscard]] std::string manual_page(const CLI::App& program);

}  // namespace camopt::apps
