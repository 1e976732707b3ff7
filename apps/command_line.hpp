// SPDX-License-Identifier: MIT
// From the words of the command line to one command. The only place that knows the option parser.
#pragma once

#include "apps/commands.hpp"

namespace camopt::apps {

/// Prints one line "camopt: …" to stderr and returns the code where something is wrong. Never throws.
[[nodiscard]] ExitCode run_command_line(int count, const char* const* words) noexcept;

}  // namespace camopt::apps
