// SPDX-License-Identifier: MIT
// STEP (AP214): B-spline surfaces as faces for CAD systems, in mm. Written by Open CASCADE where this build
// has it.
#pragma once

#include "report/surface/bspline_surface.hpp"

#include <filesystem>

namespace camopt {

/// False in a build without Open CASCADE.
[[nodiscard]] bool step_available();

/// One face a surface, its knots and poles as they are, its name on it; `part` in the header. The file is
/// there whole or not at all. Throws UnavailableError in a build without Open CASCADE, InputError where the
/// file cannot be written or a surface is not one that the library takes.
void write_step_file(const std::filesystem::path& path, std::span<const BsplineSurface> surfaces,
                     const std::string& part = {});

}  // namespace camopt
