// SPDX-License-Identifier: MIT
// A linear (plate, wedge) cam: followers, dimensions, keys. m, rad; frames and formulas:
// profiles/linear/linear_mechanism.hpp.
#pragma once

#include "scene/cam_spec.hpp"

namespace camopt {

struct CamKind;

/// cam.type of such a cam.
inline constexpr const char* linear_type = "linear";

enum class PlateFollower { translating_roller, translating_knife, oscillating_roller };
[[nodiscard]] const char* name_of(PlateFollower value);
/// The follower that a spec chooses. Throws InputError for another type and for an unknown word.
[[nodiscard]] PlateFollower plate_follower(const CamSpec& spec);
/// The roller is on an arm: the lift is an angle.
[[nodiscard]] constexpr bool is_on_arm(PlateFollower follower) {
    return follower == PlateFollower::oscillating_roller;
}

enum class PlateNumber {
    travel,         ///< what the plate slides in one cycle of 360° of the master; its sign is the direction
    base_height,    ///< from the plate's bottom to its surface at displacement 0
    roller_radius,  ///< 0: a knife edge
    inclination,    ///< δ of a pushed follower's path against the normal of the travel, rad
    arm_length,     ///< from the pivot to the roller's centre
    pivot_height    ///< of the pivot above the plate's bottom
};
inline constexpr int plate_number_count = 6;
[[nodiscard]] const char* name_of(PlateNumber value);  ///< "travel", …
[[nodiscard]] bool has_number(PlateFollower follower, PlateNumber number);

/// Type "linear", every number at 0, without formulas: linear_spec of linear_mechanism.hpp adds them.
[[nodiscard]] CamSpec blank_linear_spec(PlateFollower follower);

/// Linear cams with their followers, as scene files know them.
[[nodiscard]] CamKind linear_kind();

}  // namespace camopt
