// SPDX-License-Identifier: MIT
#include "tests/soak/stability/stability_cases.hpp"

#include <iterator>

namespace camopt::stability {

std::vector<StabilityCase> all_cases() {
    std::vector<StabilityCase> all;
    for (auto* const cases :
         {design_vector_cases, many_segment_cases, scaling_cases, weight_cases, breakpoint_cases,
          exact_point_cases, limit_cases, degenerate_cases, claim_cases, train_cases}) {
        std::vector<StabilityCase> group = cases();
        all.insert(all.end(), std::make_move_iterator(group.begin()), std::make_move_iterator(group.end()));
    }
    return all;
}

}  // namespace camopt::stability
