// SPDX-License-Identifier: MIT
// Disk cams with their followers, as scene files know them.
#pragma once

#include "scene/cam_kind.hpp"

namespace camopt {

[[nodiscard]] CamKind disk_kind();

}  // namespace camopt
