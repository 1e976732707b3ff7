// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_spec.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"

#include <algorithm>
#include <array>

namespace camopt {
namespace {

using enum RemoteDimension;
using enum RemoteLinkage;

struct DimensionRow {
    const char* name;
    bool angle, sign;
};

constexpr std::array<DimensionRow, remote_dimension_count> dimension_rows = {{
    {"roller_radius", false, false},     {"roller_arm", false, false},    {"lever_pivot_x", false, true},
    {"lever_pivot_y", false, true},      {"center_x", false, true},       {"center_y", false, true},
    {"lever_arm", false, false},         {"lever_angle", true, true},     {"coupler", false, false},
    {"rocker_pivot_x", false, true},     {"rocker_pivot_y", false, true}, {"rocker_input_arm", false, false},
    {"rocker_output_arm", false, false}, {"rocker_angle", true, true},    {"second_coupler", false, false},
    {"slider_x", false, true},           {"slider_y", false, true},       {"slider_angle", true, true},
    {"output_angle", true, true},
}};

const DimensionRow& row_of(RemoteDimension dimension) {
    return dimension_rows[static_cast<std::size_t>(dimension)];
}

}  // namespace

const char* name_of(RemoteLinkage value) {
    switch (value) {
        case lever:
            return "lever";
        case lever_coupler_slider:
            return "lever_coupler_slider";
        case lever_coupler_lever:
            return "lever_coupler_lever";
        case lever_coupler_lever_coupler_slider:
            break;
    }
    return "lever_coupler_lever_coupler_slider";
}

bool output_swings(RemoteLinkage value) {
    return value == lever || value == lever_coupler_lever;
}

const char* name_of(RemoteDimension value) {
    return row_of(value).name;
}

bool has_dimension(RemoteLinkage linkage, RemoteDimension dimension) {
    const bool two_dyads = linkage == lever_coupler_lever_coupler_slider;
    switch (dimension) {
        case roller_radius:
        case roller_arm:
        case lever_pivot_x:
        case lever_pivot_y:
        case center_x:
        case center_y:
            return true;
        case lever_arm:
        case lever_angle:
        case coupler:
            return linkage != lever;
        case rocker_pivot_x:
        case rocker_pivot_y:
        case rocker_input_arm:
            return two_dyads || linkage == lever_coupler_lever;
        case rocker_output_arm:
        case rocker_angle:
        case second_coupler:
            return two_dyads;
        case slider_x:
        case slider_y:
        case slider_angle:
            return !output_swings(linkage);
        case output_angle:
            return output_swings(linkage);
    }
    throw ModelError("remote cam: no known dimension");
}

bool is_angle(RemoteDimension dimension) {
    return row_of(dimension).angle;
}

bool has_sign(RemoteDimension dimension) {
    return row_of(dimension).sign;
}

const char* table_of(RemoteDimension dimension) {
    return dimension <= center_y ? "cam" : "linkage";
}

const char* name_of(RemoteBranch value) {
    return value == RemoteBranch::left ? "left" : "right";
}

const char* name_of(PressurePoint value) {
    return value == PressurePoint::roller_center ? "roller_center" : "contact_point";
}

CamSpec blank_remote_spec(RemoteLinkage linkage) {
    CamSpec spec;
    spec.type = remote_type;
    for (int i = 0; i < remote_dimension_count; ++i) {
        const auto which = static_cast<RemoteDimension>(i);
        Dimension value;
        if (is_angle(which)) value.unit = units::degree;
        spec.dimensions.push_back({name_of(which), value, is_angle(which)});
    }
    spec.choices = {{"linkage", name_of(linkage)},
                    {"lever_branch", "left"},
                    {"rocker_branch", "left"},
                    {"pressure_angle_at", "roller_center"}};
    return spec;
}

}  // namespace camopt
