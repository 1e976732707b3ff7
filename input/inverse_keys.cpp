// SPDX-License-Identifier: MIT
// The rows of the key table that only inverse cams have.
#include "input/key_spellings.hpp"

namespace camopt::input {
namespace {

using enum KeyType;
using namespace spellings;

}  // namespace

// A row is read as a row.
// clang-format off
std::vector<KeyRow> inverse_rows() {
    std::vector<KeyRow> rows = {
        {"cam", "roller_rest", number_or_range, length, not_negative, {}, "required for inverse",
         "Distance from the body's pivot at which the roller started from rest; from there its acceleration is "
         "constant."},
        {"cam", "roller_end", number_or_range, length, positive, {}, "required for inverse",
         "The same at the end of the roller's stroke."},
        {"cam", "roller_angle", number_or_range, angle, positive, {}, "required for inverse",
         "Cam angle of that stroke, from rest to its end."},
        {"cam", "roller_from", number_or_range, length, positive, {}, "required for inverse",
         "The same distance where the rise begins; between rest and end."},
        {"cam", "pin_distance", number_or_range, length, positive, {}, "required for inverse",
         "From the body's pivot, the origin, to its pin in the rocker's slot."},
        {"cam", "pin_angle", number_or_range, angle, any, {}, "0",
         "Of the pin from the body's x axis."},
        {"cam", "rocker_pivot_x", number_or_range, length, any, {}, "required for inverse",
         "Of the pivot of the slotted rocker."},
        {"cam", "rocker_pivot_y", number_or_range, length, any, {}, "0", "The same."},
        {"cam", "feeder_offset", number_or_range, length, any, {}, "required for inverse",
         "From the rocker's pivot to the line along y on which the feeder slides; not 0."},
        {"cam", "feeder_start", number_or_range, length, any, {}, "required for inverse",
         "y of the feeder at displacement 0."},
    };
    for (KeyRow& row : rows) row.cam_type = "inverse";
    return rows;
}
// clang-format on

}  // namespace camopt::input
