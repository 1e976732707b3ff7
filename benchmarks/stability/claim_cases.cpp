// SPDX-License-Identifier: MIT
#include "benchmarks/stability/stability_cases.hpp"

namespace camopt::stability {

std::vector<StabilityCase> claim_cases() {
    return {};
}

}  // namespace camopt::stability
