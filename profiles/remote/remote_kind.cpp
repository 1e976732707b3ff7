// SPDX-License-Identifier: MIT
#include "profiles/remote/remote_kind.hpp"

#include "core/units.hpp"
#include "profiles/remote/remote_spec.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

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
         "What leads from the cam's lever to the output, where `cam.type` is `\"remote\"`.", Availability::needs_cam},
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
        {"linkage", "type", text, plain, any,
         {"lever", "lever_coupler_slider", "lever_coupler_lever", "lever_coupler_lever_coupler_slider"},
         "required", "What leads from the cam's lever to the output: the lever itself (lift is an angle), a slider, "
         "a rocker (lift is an angle), or a rocker and a slider."},
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
