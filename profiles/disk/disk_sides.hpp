// SPDX-License-Identifier: MIT
//
// The sides of a disk cam: the surfaces that its follower touches. An open cam has one; a groove has two
// flanks, a conjugate cam a disk on either side of the follower.
//
// Side 0 is that of an open cam of the same dimensions: the inner flank, the first disk. A force F > 0 along
// the lift acts on it, F < 0 on side 1: the cam drives both ways, and no closing force is needed.
//
// Groove. Both flanks are offsets of the pitch curve by R = roller radius + clearance/2. The outer flank is
// the surface of material outside: with the pitch curve's curvature κ it has the pitch curvature −κ, so
//   outward normal −n (towards the roller),  radius −1/κ − R (concave where the pitch curve is convex),
//   regularity 1 + R κ,  and the roller of radius r lies on either flank with the combined radius
//   R_eff = r (1 − R κ_side)/(1 − (R − r) κ_side).
//
// Conjugate. The second roller is carried by the same follower. Translating: its centre at
// (e2, s0 + s − D), D between the rollers' axes; oscillating: its arm below the line of centres by ψ2 = γ −
// ψ, γ between the arms. In the mirror image about the x axis it is an open cam whose follower moves
// by −s: second_disk(). Its points here are mirrored back. The disks are fixed to one shaft.
#pragma once

#include "core/numbers/enclosures.hpp"
#include "profiles/disk/disk_cam.hpp"

#include <string>

namespace camopt {

[[nodiscard]] int side_count(const DiskCam& cam);
[[nodiscard]] int side_count(const FormSpec& form);
/// "inner flank", "second disk"; empty: there is only one.
[[nodiscard]] std::string side_name(const FormSpec& form, int side);
/// Of the roller on this side, m; 0 without a roller.
[[nodiscard]] double roller_radius_of(const DiskCam& cam, int side);
/// From the roller's centre to the surface: R above; m.
[[nodiscard]] double surface_offset(const DiskCam& cam, int side);

/// The second disk of a conjugate cam in the mirror image about the x axis, as an open cam: driven by −s,
/// −s', −s''. A base radius that is not positive, or NaN: there is none.
[[nodiscard]] DiskCam second_disk(const DiskCam& cam);
[[nodiscard]] FollowerState second_state(const FollowerState& state);
/// The second roller's distance (m) or angle (rad) along the follower's path at s = 0: D − s0, γ − ψ0.
[[nodiscard]] double second_rest_position(const DiskCam& cam);

[[nodiscard]] ProfilePoint profile_point(const DiskCam& cam, double theta, const FollowerState& state,
                                         int side);

/// As quantity() of disk_cam.hpp and quantity_along.hpp, of one side; partials by the variables of the whole
/// cam. The pressure angle of the second disk has the sign of its mirror image.
[[nodiscard]] QuantityValue quantity(const DiskCam& cam, const FollowerState& state, MechanismQuantity which,
                                     int side);
[[nodiscard]] RangeAlong quantity(const DiskCam& cam, const StateAlong& state, MechanismQuantity which,
                                  int side);

}  // namespace camopt
