// SPDX-License-Identifier: MIT
// From the words of camopt sweep to what is asked for. All throw InputError.
#pragma once

#include "apps/commands.hpp"
#include "output/json/sweep_json.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <string>
#include <vector>

namespace camopt::apps {

/// --vary in their order, then --weights: the last moves fastest, and weights are the cheapest to move.
[[nodiscard]] SweepPlan sweep_plan(const SweepRequest& request);

/// The same as words, for people: "--vary spline.segments=8,16", "--weights simplex:20".
[[nodiscard]] std::vector<std::string> sweep_axes(const SweepRequest& request);

/// --set and --solver, the same for every row.
[[nodiscard]] std::vector<std::string> sweep_settings(const SweepRequest& request);

/// "2/3": the second of three. Empty: the whole.
[[nodiscard]] SweepShard sweep_shard(const SweepRequest& request);

}  // namespace camopt::apps
