// SPDX-License-Identifier: MIT
// Disk cams with their followers, as scene files know them.
#pragma once

#include "scene/cam_kind.hpp"

namespace camopt {

/// cam.type of a disk cam.
inline constexpr const char* disk_type = "disk";

[[nodiscard]] CamKind disk_kind();

}  // namespace camopt
