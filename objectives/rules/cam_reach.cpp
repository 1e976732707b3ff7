// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_reach.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace camopt {

namespace {

// Of the longest dimension: a cam nearer than this to where it stops being one has no digits left.
constexpr double least_reach = 1e-6;

void add_inequality(CamModel& model, const DiskVariables& cam, const CamSpec& spec,
                    std::span<const SignedDimension> inequality) {
    ParameterRow row{"cam.base_radius", {}, {}, 0.0, true, 1.0};
    double most = 0.0, longest = 0.0;
    for (const auto& [which, sign] : inequality) {
        const Dimension& dimension = spec[which];
        most += std::max(sign * dimension.low, sign * dimension.high);
        longest = std::max({longest, std::abs(dimension.low), std::abs(dimension.high)});
        if (!dimension.is_variable()) {
            row.upper -= sign * dimension.low;
            continue;
        }
        const auto variable = std::ranges::find(cam.variables, which, &DiskVariables::Variable::dimension);
        row.parameters.push_back(variable->parameter);
        row.weights.push_back(sign * variable->reference);
    }
    const double margin = least_reach * longest;
    if (row.parameters.empty() || most <= -margin) return;
    row.upper -= margin;
    // Measured by the longest dimension.
    for (double& weight : row.weights) weight /= longest;
    row.upper /= longest;
    model.parameter_rows.push_back(std::move(row));
}

}  // namespace

void add_reach_rows(CamModel& model, const CamSpec& spec) {
    const DiskVariables cam(*model.cam);
    for (const auto& inequality : reach_of(spec.follower)) add_inequality(model, cam, spec, inequality);
}

}  // namespace camopt
