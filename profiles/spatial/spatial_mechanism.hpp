// SPDX-License-Identifier: MIT
// Barrel and cylindrical cams as a CamMechanism, for the optimizer.
//
// Stations are heights along the roller, uniformly from its near to its far end, each on both flanks: station
// 2 k is flank +1, station 2 k + 1 flank −1 of height k. The pressure angle is the same on both flanks, and
// cos φm V_u − sin φm |V_b| is linear in h, so that its limit holds everywhere if it holds at both ends: it
// binds at two stations only. g binds at every station. Dimensions in the order of SpatialNumber
// (profiles/spatial/spatial_spec.hpp); m, rad.
#pragma once

#include "profiles/spatial/spatial_cam.hpp"
#include "profiles/spatial/spatial_spec.hpp"
#include "scene/cam_mechanism.hpp"

#include <memory>
#include <span>

namespace camopt {

/// Heights at which g is enforced; g is smooth over a roller (its extremes have always been found at its
/// ends).
inline constexpr int mechanism_heights = 3;

/// CamSpec::make of the types "barrel" and "cylindrical". Throws InputError for another.
[[nodiscard]] std::shared_ptr<const CamMechanism> spatial_mechanism(const CamSpec& spec);

/// A scene's cam of this kind with every number at 0, complete: type "barrel" or "cylindrical", the latter
/// with the choice "follower" = "rotating" or "translating".
[[nodiscard]] CamSpec spatial_spec(SpatialFollower follower);

/// The cam with these numbers, in the order of SpatialNumber.
[[nodiscard]] SpatialCam spatial_cam(SpatialFollower follower, Rotation rotation,
                                     std::span<const double> numbers);
/// The same of a scene's cam; throws InputError for one of another type.
[[nodiscard]] SpatialCam spatial_cam(const CamSpec& spec, std::span<const double> numbers);

}  // namespace camopt
