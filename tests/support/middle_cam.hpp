// SPDX-License-Identifier: MIT
// A disk cam of a scene with ranges, as one cam.
#pragma once

#include "profiles/disk/disk_cam.hpp"

namespace camopt {

/// The cam of a scene with each variable dimension in the middle of its range.
[[nodiscard]] inline DiskCam middle_cam(const DiskSpec& spec) {
    DiskCam cam{spec.follower, spec.rotation, {}, spec.form};
    for (std::size_t i = 0; i < cam.dimensions.size(); ++i) cam.dimensions[i] = spec.dimensions[i].middle();
    return cam;
}

}  // namespace camopt
