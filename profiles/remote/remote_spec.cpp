// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_spec.hpp"

#include "core/errors.hpp"
#include "core/word_of.hpp"
#include "scene/cam_kind.hpp"

#include <fmt/format.h>

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

using enum KeyType;
using namespace spellings;

/// What a scene need not say.
std::optional<double> default_of(RemoteDimension which) {
    using enum RemoteDimension;
    if (which == slider_angle) return 90.0 * units::degree;
    const bool zero = which == center_x || which == center_y || which == lever_angle || which == rocker_angle;
    return zero ? std::optional<double>(0.0) : std::nullopt;
}

// A row is read as a row.
// clang-format off
std::vector<KeyRow> remote_rows() {
    return {
        {"", "linkage", table, plain, any, {}, "no linkage",
         "What leads from the cam's lever to the output, where `cam.type` is `\"remote\"`.", {}, Availability::needs_cam},
        {"cam", "roller_arm", number_or_range, length, positive, {}, "required for remote",
         "From the lever's pivot to the roller's centre."},
        {"cam", "lever_pivot_x", number_or_range, length, any, {}, "required for remote",
         "Of the pivot of the lever that carries the roller; all coordinates are in one fixed frame."},
        {"cam", "lever_pivot_y", number_or_range, length, any, {}, "required for remote", "The same."},
        {"cam", "center_x", number_or_range, length, any, {}, "0", "Of the cam's centre."},
        {"cam", "center_y", number_or_range, length, any, {}, "0", "Of the cam's centre."},
        {"cam", "pressure_angle_at", text, plain, any, {"roller_center", "contact_point"}, "\"roller_center\"",
         "What the pressure angle is measured at: the roller's centre, as the roller turns freely, or the contact "
         "point, taken as fixed to the lever."},
        called("kind of linkage", {"linkage", "type", text, plain, any,
         {"lever", "lever_coupler_slider", "lever_coupler_lever", "lever_coupler_lever_coupler_slider"},
         "required", "What leads from the cam's lever to the output: the lever itself (lift is an angle), a slider, "
         "a rocker (lift is an angle), or a rocker and a slider."}),
        {"linkage", "lever_arm", number_or_range, length, positive, {}, "required with a coupler",
         "From the lever's pivot to its joint with the coupler."},
        {"linkage", "lever_angle", number_or_range, angle, any, {}, "0",
         "From the roller's arm to that arm, counterclockwise."},
        {"linkage", "lever_branch", text, plain, any, {"left", "right"}, "\"left\"",
         "Side of the line from the lever's pivot to the coupler's far joint on which the lever's joint lies."},
        {"linkage", "coupler", number_or_range, length, positive, {}, "required with a coupler",
         "Length of the coupler between lever and slider or rocker."},
        {"linkage", "rocker_pivot_x", number_or_range, length, any, {}, "required with a rocker",
         "Of the rocker's pivot."},
        {"linkage", "rocker_pivot_y", number_or_range, length, any, {}, "required with a rocker",
         "Of the rocker's pivot."},
        {"linkage", "rocker_input_arm", number_or_range, length, positive, {}, "required with a rocker",
         "From the rocker's pivot to its joint with the coupler."},
        {"linkage", "rocker_output_arm", number_or_range, length, positive, {}, "required with two couplers",
         "From the rocker's pivot to its joint with the second coupler."},
        {"linkage", "rocker_angle", number_or_range, angle, any, {}, "0",
         "From the rocker's output arm to its input arm, counterclockwise."},
        {"linkage", "rocker_branch", text, plain, any, {"left", "right"}, "\"left\"",
         "Side of the line from the rocker's pivot to the slider's joint on which the rocker's joint lies."},
        {"linkage", "second_coupler", number_or_range, length, positive, {}, "required with two couplers",
         "Length of the coupler between rocker and slider."},
        {"linkage", "slider_x", number_or_range, length, any, {}, "required with a slider",
         "Of the slider's joint at displacement 0."},
        {"linkage", "slider_y", number_or_range, length, any, {}, "required with a slider",
         "Of the slider's joint at displacement 0."},
        {"linkage", "slider_angle", number_or_range, angle, any, {}, "90 deg",
         "Direction of the slider's path, from +x."},
        {"linkage", "output_angle", number_or_range, angle, any, {}, "required without a slider",
         "Angle of the swinging output (roller's arm, rocker's arm) at displacement 0, from +x; the lift turns it "
         "counterclockwise."},
    };
}
// clang-format on

CamVariant variant(RemoteLinkage linkage) {
    CamVariant all{name_of(linkage),
                   fmt::format("the linkage \"{}\"", name_of(linkage)),
                   output_swings(linkage),
                   "a roller",
                   {},
                   {},
                   [linkage] { return blank_remote_spec(linkage); }};
    for (int i = 0; i < remote_dimension_count; ++i) {
        const auto which = static_cast<RemoteDimension>(i);
        all.numbers.push_back(
            {table_of(which), name_of(which), has_dimension(linkage, which), default_of(which), 0.0, i});
    }
    all.choices = {{"cam", "pressure_angle_at"},
                   {"linkage", "lever_branch", has_dimension(linkage, RemoteDimension::lever_arm)},
                   {"linkage", "rocker_branch", has_dimension(linkage, RemoteDimension::second_coupler)}};
    return all;
}

}  // namespace

const char* name_of(RemoteLinkage value) {
    return word_of<lever_coupler_lever_coupler_slider>(
        value,
        {"lever", "lever_coupler_slider", "lever_coupler_lever", "lever_coupler_lever_coupler_slider"});
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

CamKind remote_kind() {
    CamKind kind;
    kind.type = remote_type;
    kind.spoken = "one whose lever moves the output through a linkage";
    kind.choosing_table = "linkage";
    kind.choosing_key = "type";
    using enum RemoteLinkage;
    for (const RemoteLinkage linkage :
         {lever, lever_coupler_slider, lever_coupler_lever, lever_coupler_lever_coupler_slider})
        kind.variants.push_back(variant(linkage));
    kind.with_angle = "\"lever\" or \"lever_coupler_lever\"";
    kind.with_length = "a linkage with a slider";
    kind.rows = remote_rows();
    return kind;
}

}  // namespace camopt
