// SPDX-License-Identifier: MIT
// The disk cam with any of its followers as a CamMechanism, for reports, checks and files. The optimizer uses
// the formulas of disk_cam.hpp directly.
//
// Its dimensions are those of the follower, in the order of DimensionIndex, then the numbers of its form; a
// station is a side (disk_sides.hpp). m, rad.
#pragma once

#include "profiles/disk/disk_cam.hpp"
#include "profiles/disk/disk_spec.hpp"
#include "scene/cam_mechanism.hpp"

#include <memory>
#include <optional>

namespace camopt {

/// CamSpec::make of a disk cam. Throws InputError for an unknown follower or form.
[[nodiscard]] std::shared_ptr<const CamMechanism> disk_formulas(const CamSpec& spec);

/// The cam of a scene: type "disk", the choices "follower" and "form", a key for every dimension, and the
/// formulas. Throws SceneError for a number that this follower or form does not have.
[[nodiscard]] CamSpec disk_spec(const DiskSpec& cam);

[[nodiscard]] DrivenMechanism disk_mechanism(const DiskCam& cam);

/// The disk cam of these formulas and numbers; none: they are of another kind.
[[nodiscard]] std::optional<DiskCam> disk_cam(const DrivenMechanism& mechanism);

}  // namespace camopt
