// SPDX-License-Identifier: MIT
// The cams of MECHANISMS section 5's reference points: dwell to 60°, rise to 160°, dwell to 200°, fall to
// 360°.
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "profiles/sampling.hpp"
#include "splines/motion_chain.hpp"

#include <array>
#include <string>

namespace camopt::test {

inline constexpr std::array all_followers = {
    FollowerType::translating_roller, FollowerType::translating_knife, FollowerType::translating_flat,
    FollowerType::oscillating_roller, FollowerType::oscillating_flat};

/// x in rad, so the unit angle is 1.
[[nodiscard]] MotionChain turn_motion(const std::string& law);

/// e = 8, prime radius 45, roller radius 10; flat: base radius 60; a = 100, l = 80, ψ0 = 32° or, flat, 22°
/// with f = 4 mm.
[[nodiscard]] DiskCam sample_cam(FollowerType follower, Rotation rotation = Rotation::counterclockwise);

/// 25 mm, flat 14 mm, swing 22° or, flat, 6° (at the 10° of the reference points the clockwise cam is
/// undercut).
[[nodiscard]] MotionScale sample_scale(FollowerType follower);

}  // namespace camopt::test
