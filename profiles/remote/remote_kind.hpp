// SPDX-License-Identifier: MIT
// Disk cams with a remote follower, as scene files know them.
#pragma once

#include "scene/cam_kind.hpp"

namespace camopt {

[[nodiscard]] CamKind remote_kind();

}  // namespace camopt
