// SPDX-License-Identifier: MIT
// The cam of a scene, of whatever kind: who reports, checks, writes or compares cams asks for it here and
// knows no kind.
#pragma once

#include "scene/mechanism_spec.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace camopt {

[[nodiscard]] inline bool has_cam(const Scene& scene) {
    return scene.cam || scene.mechanism;
}

/// Its type, choices, numbers and formulas; a disk cam as disk/disk_mechanism.hpp presents it. None: the
/// scene has no cam.
[[nodiscard]] std::optional<MechanismSpec> cam_of(const Scene& scene);

}  // namespace camopt
