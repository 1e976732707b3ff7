// SPDX-License-Identifier: MIT
// COIN Clp on a linear program, as a rival to measure: the call is timed, loading the numbers is not.
#pragma once

#include "benchmarks/linear/linear_program_text.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace camopt::benchmarks {

struct RivalRun {
    std::string status;  ///< the rival's own word
    Eigen::VectorXd x;
    double seconds = 0.0;
    int iterations = 0;
};

/// "dual", "dual, presolved", …; empty where this build has no Clp.
[[nodiscard]] std::vector<std::string> clp_methods();

/// The version of Clp; empty where this build has none.
[[nodiscard]] std::string clp_version();

/// Tolerances 1e-9, no output. Stops after `most_seconds`.
[[nodiscard]] RivalRun run_clp(const LinearProgram& program, const std::string& method, double most_seconds);

}  // namespace camopt::benchmarks
