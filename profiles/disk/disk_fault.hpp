// SPDX-License-Identifier: MIT
// Whether a scene's disk cam can be built and moved. Internal to profiles/disk.
#pragma once

#include "profiles/disk/disk_spec.hpp"
#include "scene/scene.hpp"

#include <optional>

namespace camopt {

/// The first fault for every choice of its dimensions within their ranges; none: no fault.
[[nodiscard]] std::optional<SceneFault> disk_fault(const DiskSpec& cam, const MotionSpec& motion);

}  // namespace camopt
