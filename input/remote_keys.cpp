// SPDX-License-Identifier: MIT
// The rows of the key table that have to do with a cam of type "remote" and its linkage.
#include "input/key_spellings.hpp"

namespace camopt::input {
namespace {

using enum KeyType;
using namespace spellings;

}  // namespace

// A row is read as a row.
// clang-format off
std::vector<KeyRow> remote_rows() {
    std::vector<KeyRow> rows = {
        {"cam", "roller_arm", number_or_range, length, positive, {}, "required for remote",
         "From the lever's pivot to the roller's centre."},
        {"cam", "lever_pivot_x", number_or_range, length, any, {}, "required for remote",
         "Of the pivot of the lever that carries the roller; all coordinates are of one frame that stands still."},
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
         "Direction of the slider's way, from +x."},
        {"linkage", "output_angle", number_or_range, angle, any, {}, "required without a slider",
         "Angle of the swinging output (roller's arm, rocker's arm) at displacement 0, from +x; the lift turns it "
         "counterclockwise."},
    };
    for (KeyRow& row : rows) row.cam_type = "remote";
    return rows;
}
// clang-format on

}  // namespace camopt::input
