// SPDX-License-Identifier: MIT
// The disk cam with any of its followers as a CamMechanism: what reports, checks and files see of it, as they
// see every other cam. The optimizer takes the formulas of disk_cam.hpp themselves.
//
// Its dimensions are those the follower has, in the order of DimensionIndex, then the numbers of its form; a
// station is a side (disk_sides.hpp). m, rad.
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "scene/cam_mechanism.hpp"

#include <memory>
#include <optional>

namespace camopt {

/// What CamSpec::make is of a disk cam. Throws InputError for a follower or a form that does not exist.
[[nodiscard]] std::shared_ptr<const CamMechanism> disk_formulas(const CamSpec& spec);

/// The cam of a scene: type "disk", the choices "follower" and "form", a key for every dimension, and the
/// formulas. Throws SceneError for a number that this follower or this form has not.
[[nodiscard]] CamSpec disk_spec(const DiskSpec& cam);

[[nodiscard]] DrivenMechanism disk_mechanism(const DiskCam& cam);

/// The disk cam that these formulas and numbers are; none: they are of another kind.
[[nodiscard]] std::optional<DiskCam> disk_cam(const DrivenMechanism& mechanism);

}  // namespace camopt
