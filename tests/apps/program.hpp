// SPDX-License-Identifier: MIT
// Running the built camopt program, as a user's shell would.
#pragma once

#include <string>

namespace camopt::test {

struct ProgramRun {
    int exit_code = -1;
    std::string output, errors;  ///< stdout and stderr
};

/// arguments: as typed into a shell.
[[nodiscard]] ProgramRun run_camopt(const std::string& arguments);

/// The same, with SIGINT sent after so many seconds.
[[nodiscard]] ProgramRun run_camopt_interrupted(const std::string& arguments, double seconds);

/// Full path of a scene of this project.
[[nodiscard]] std::string scene(const std::string& name);

}  // namespace camopt::test
