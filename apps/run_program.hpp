// SPDX-License-Identifier: MIT
#pragma once

namespace camopt::apps {

/// What main() of a program returns, of whose parts program_parts() tells (apps/program_parts.hpp).
[[nodiscard]] int run_program(int count, char** words);

}  // namespace camopt::apps
