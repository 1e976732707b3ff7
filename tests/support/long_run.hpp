// SPDX-License-Identifier: MIT
// Tests whose worth grows with the number of random scenes have two lengths: a short one in every run of the
// tests, and the whole one where the environment sets CAMOPT_LONG_TESTS (`scripts/nightly random`). Both
// check the same things.
#pragma once

#include <cstdlib>

namespace camopt::testing_support {

[[nodiscard]] inline int scenes_to_try(int in_every_run, int in_a_long_run) {
    return std::getenv("CAMOPT_LONG_TESTS") != nullptr ? in_a_long_run : in_every_run;
}

}  // namespace camopt::testing_support
