// SPDX-License-Identifier: MIT
// One trial: a scene, its checks, its comparisons. Runs in a worker process.
#pragma once

#include "tests/soak/run/options.hpp"
#include "tests/soak/scenes/scene_numbers.hpp"

#include <cstdint>
#include <functional>
#include <string>

namespace camopt::soak {

struct TrialPlan {
    Kind kind = Kind::motion;
    std::uint64_t seed = 1;
    int number = 0;
    std::string scene = {};  ///< to replay; empty: drawn
    [[nodiscard]] std::string name() const;
};

/// `tell` takes the lines of run/message.hpp.
void run_trial(const TrialPlan& plan, const Options& options,
               const std::function<void(const std::string&)>& tell);

/// The plan that the remarks of a scene of a failure tell; `options.only` becomes its relation where it is
/// empty.
[[nodiscard]] TrialPlan replayed_plan(const std::string& scene, Options& options);

}  // namespace camopt::soak
