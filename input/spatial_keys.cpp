// SPDX-License-Identifier: MIT
// The rows of the key table that only barrel and cylindrical cams have.
#include "input/key_spellings.hpp"

namespace camopt::input {
namespace {

using enum KeyType;
using namespace spellings;

}  // namespace

// A row is read as a row.
// clang-format off
std::vector<KeyRow> spatial_rows() {
    std::vector<KeyRow> rows = {
        {"cam", "cylinder_radius", number_or_range, length, positive, {}, "required for cylindrical, translating",
         "From the cam's axis to the roller's near end; the roller's axis points to the cam's. "
         "`cylindrical` with a `translating` follower only."},
        {"cam", "roller_length", number_or_range, length, positive, {}, "required for barrel, cylindrical",
         "Length of the roller; every limit holds from its near to its far end."},
        {"cam", "lateral_offset", number_or_range, length, any, {}, "required for barrel, else 0",
         "From the cam's axis across it: to the pivot of a rotating or the axis of a translating follower (+x); "
         "of a barrel cam's index axis (−x)."},
        {"cam", "axial_offset", number, length, any, {}, "0",
         "Of the follower along the cam's axis; shifts the cam and changes no limit."},
        {"cam", "start_angle", number, angle, any, {}, "minus half the lift",
         "Angle of the index arm or the rotating follower from the line through both axes at displacement 0."},
    };
    for (KeyRow& row : rows) row.cam_type = "barrel|cylindrical";
    return rows;
}
// clang-format on

}  // namespace camopt::input
