// SPDX-License-Identifier: MIT
#include "profiles/scene_cam.hpp"

#include "profiles/disk/disk_mechanism.hpp"

namespace camopt {

std::optional<MechanismSpec> cam_of(const Scene& scene) {
    if (scene.cam) return disk_spec(*scene.cam);
    return scene.mechanism;
}

}  // namespace camopt
