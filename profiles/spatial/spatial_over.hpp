// SPDX-License-Identifier: MIT
// Private to profiles/spatial/: the limits of barrel and cylindrical cams over a box of motions and
// dimensions, by the formulas of spatial_formulas.hpp.
#pragma once

#include "profiles/spatial/spatial_cam.hpp"
#include "scene/cam_mechanism.hpp"

namespace camopt::spatial_formulas {

/// A location on the roller: its part of the roller's length, and the flank.
struct PlaceOnRoller {
    double share = 0.0;
    int flank = 1;
};

struct PressureLimit {
    double angle = 0.0;
    int sign = 1;
    bool continued = false;  ///< of barrel cams: by tangents, as the limit itself is where it is convex
};

/// `cam`: its follower and its sense alone. The excess of the pressure angle; of a barrel cam, with u = φ ±
/// ψ, written as ±r ψ' cos φ − ρ sin u.
[[nodiscard]] RangeOver pressure_over(const SpatialCam& cam, const MechanismStateOver& state,
                                      const PlaceOnRoller& place, const PressureLimit& limit);

/// margin − g times W³/(r · lever · |V_b|), with the lever of s'' in A·u: linear in s''.
[[nodiscard]] RangeOver undercut_over(const SpatialCam& cam, const MechanismStateOver& state,
                                      const PlaceOnRoller& place, double margin);

/// Of a cam with its numbers, along a stretch of a motion.
[[nodiscard]] RangeAlong quantity_along(const SpatialCam& cam, const MechanismStateAlong& state,
                                        const RollerStation& station, SpatialQuantity which);

}  // namespace camopt::spatial_formulas
