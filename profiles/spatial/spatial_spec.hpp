// SPDX-License-Identifier: MIT
// The dimensions of a barrel or cylindrical cam: their names, once for the scene reader and the formulas
// (profiles/spatial).
#pragma once

#include "scene/cam_flanks.hpp"

namespace camopt {

struct CamKind;

/// cam.type of such a cam.
inline constexpr const char* barrel_type = "barrel";
inline constexpr const char* cylindrical_type = "cylindrical";

enum class SpatialFollower { barrel, cylindrical_rotating, cylindrical_translating };
[[nodiscard]] const char* name_of(SpatialFollower value);

/// The follower turns (an index, a lever): its lift is an angle.
[[nodiscard]] constexpr bool swings(SpatialFollower value) {
    return value != SpatialFollower::cylindrical_translating;
}

/// All numbers of such a mechanism in their order; profiles/spatial/spatial_cam.hpp has the formulas.
enum class SpatialNumber {
    roller_radius,
    arm_length,       ///< barrel: index radius; rotating: pivot to the roller's near end; else unused
    center_distance,  ///< barrel, translating: cam's axis to the roller's near end; rotating: to the pivot
    lateral_offset,
    axial_offset,  ///< changes no limit
    roller_length,
    start  ///< position of the follower at displacement 0: rad, m
};
inline constexpr int spatial_number_count = 7;
[[nodiscard]] const char* name_of_number(SpatialNumber value);  ///< "roller_radius", …

/// How a drum is made, beside the numbers above; m. What a scene gives of it follows them in the dimensions
/// of its CamSpec.
struct DrumForm {
    double groove_clearance = 0.0;  ///< width of the groove less the roller's diameter, half on either side
    DrumBody body = {};
};

/// A cam of this kind with every number at 0 and without formulas (spatial_spec of spatial_cam.hpp adds
/// them); type "barrel" or "cylindrical", the latter with the
/// choice "follower" = "rotating" or "translating".
[[nodiscard]] CamSpec blank_spatial_spec(SpatialFollower follower);
[[nodiscard]] DrumForm drum_form(const CamSpec& spec);
/// Back again; throws InputError for a spec of another type.
[[nodiscard]] SpatialFollower spatial_follower(const CamSpec& spec);

/// Barrel and cylindrical cams, as scene files know them.
[[nodiscard]] CamKind barrel_kind();
[[nodiscard]] CamKind cylindrical_kind();

}  // namespace camopt
