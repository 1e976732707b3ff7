// SPDX-License-Identifier: MIT
// Barrel and cylindrical cams, as scene files know them.
#pragma once

#include "scene/cam_kind.hpp"

namespace camopt {

[[nodiscard]] CamKind barrel_kind();
[[nodiscard]] CamKind cylindrical_kind();

}  // namespace camopt
