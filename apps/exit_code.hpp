// SPDX-License-Identifier: MIT
// The exit codes of camopt, the same for every command. 130 is what a shell says of Ctrl-C.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt::apps {

enum ExitCode : int { success = 0, failure = 1, wrong_input = 2, proved_infeasible = 3, interrupted = 130 };

[[nodiscard]] inline ExitCode exit_code_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::optimal:
        case Verdict::local:
        case Verdict::feasible:
            return success;
        case Verdict::infeasible:
            return proved_infeasible;
        case Verdict::failed:
            break;
    }
    return failure;
}

}  // namespace camopt::apps
