// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_reach.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace camopt {

namespace {

// Relative to the longest dimension: a cam closer to the limit of its reach than this is ill-conditioned.
constexpr double least_reach = 1e-6;

void add_inequality(CamModel& model, const CamSpec& spec,
                    std::span<const CamMechanism::SignedIndex> inequality) {
    ParameterRow row{"cam.base_radius", {}, {}, 0.0, true, 1.0};
    double most = 0.0, longest = 0.0;
    for (const auto& [which, sign] : inequality) {
        const Dimension& dimension = spec.dimensions[static_cast<std::size_t>(which)].value;
        most += std::max(sign * dimension.low, sign * dimension.high);
        longest = std::max({longest, std::abs(dimension.low), std::abs(dimension.high)});
        if (!dimension.is_variable()) {
            row.upper -= sign * dimension.low;
            continue;
        }
        const auto variable =
            std::ranges::find(model.cam->variables, which, &CamVariables::Variable::dimension);
        row.parameters.push_back(variable->parameter);
        row.weights.push_back(sign * variable->reference);
    }
    const double margin = least_reach * longest;
    if (row.parameters.empty() || most <= -margin) return;
    row.upper -= margin;
    // Normalised by the longest dimension.
    for (double& weight : row.weights) weight /= longest;
    row.upper /= longest;
    model.parameter_rows.push_back(std::move(row));
}

}  // namespace

void add_reach_rows(CamModel& model, const CamSpec& spec) {
    for (const auto& inequality : spec.formulas()->reach()) add_inequality(model, spec, inequality);
}

}  // namespace camopt
