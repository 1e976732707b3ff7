// SPDX-License-Identifier: MIT
// The disk cam with any of its followers as a CamMechanism: what reports, checks and files see of it, as they
// see every other cam. The optimizer takes the formulas of disk_cam.hpp themselves.
//
// Its dimensions are those the follower has, in the order of DimensionIndex, then the numbers of its form; a
// station is a side (disk_sides.hpp). m, rad.
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "scene/cam_mechanism.hpp"
#include "scene/mechanism_spec.hpp"

#include <optional>
#include <vector>

namespace camopt {

/// The dimensions a follower has, in the order in which they stand here.
[[nodiscard]] std::vector<DimensionIndex> dimensions_of(FollowerType follower);

/// The numbers of the form that are given, as fixed dimensions with their keys.
[[nodiscard]] std::vector<MechanismDimension> form_dimensions(FollowerType follower, const FormSpec& form);

/// The cam of a scene: type "disk", its follower as the choice "follower", a key for every dimension, and the
/// formulas.
[[nodiscard]] MechanismSpec disk_spec(const CamSpec& cam);

[[nodiscard]] DrivenMechanism disk_mechanism(const DiskCam& cam);

/// The disk cam that these formulas and numbers are; none: they are of another kind.
[[nodiscard]] std::optional<DiskCam> disk_cam(const DrivenMechanism& mechanism);

}  // namespace camopt
