// SPDX-License-Identifier: MIT
// Which scenes have a bound over boxes of segment angles (free_angles.hpp).
#pragma once

#include "scene/scene.hpp"

namespace camopt {

/// Whether the least objective can only fall where an angle grows: boxes of angles can be bounded.
[[nodiscard]] bool bounds_by_angles(const Scene& scene);

}  // namespace camopt
