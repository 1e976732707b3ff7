// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_reach.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace camopt {

namespace {

using enum DimensionIndex;

// Of the longest dimension: a cam nearer than this to where it stops being one has no digits left.
constexpr double least_reach = 1e-6;

struct Share {
    DimensionIndex dimension;
    double sign;
};
/// The sum of the shares stays below 0.
using Inequality = std::vector<Share>;

std::vector<Inequality> inequalities_of(FollowerType follower) {
    const bool roller = has_roller(follower);
    const auto with_prime = [&](Inequality inequality, double sign) {
        inequality.push_back({base_radius, sign});
        if (roller) inequality.push_back({roller_radius, sign});
        return inequality;
    };
    switch (follower) {
        case FollowerType::translating_roller:
        case FollowerType::translating_knife:
            return {with_prime({{offset, 1.0}}, -1.0), with_prime({{offset, -1.0}}, -1.0)};
        case FollowerType::oscillating_roller:
            return {with_prime({{center_distance, 1.0}, {arm_length, -1.0}}, -1.0),
                    with_prime({{center_distance, -1.0}, {arm_length, 1.0}}, -1.0),
                    with_prime({{center_distance, -1.0}, {arm_length, -1.0}}, 1.0)};
        case FollowerType::oscillating_flat:
            return {{{base_radius, 1.0}, {face_offset, 1.0}, {center_distance, -1.0}},
                    {{base_radius, -1.0}, {face_offset, -1.0}, {center_distance, -1.0}}};
        case FollowerType::translating_flat:
            break;
    }
    return {};
}

void add_inequality(CamModel& model, const CamSpec& spec, const Inequality& inequality) {
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
        const auto variable =
            std::ranges::find(model.cam->variables, which, &CamVariables::Variable::dimension);
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
    for (const Inequality& inequality : inequalities_of(spec.follower))
        add_inequality(model, spec, inequality);
}

}  // namespace camopt
