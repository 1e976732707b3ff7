// SPDX-License-Identifier: MIT
// Inverse cams with a feeder, as scene files know them.
#pragma once

#include "scene/cam_kind.hpp"

namespace camopt {

[[nodiscard]] CamKind inverse_kind();

}  // namespace camopt
