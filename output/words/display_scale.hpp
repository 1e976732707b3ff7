// SPDX-License-Identifier: MIT
// From the normalised motion back to the units on the drawing.
//
//     θ = rise · x,   dʳs/dθʳ = lift / riseʳ · y⁽ʳ⁾,   dʳs/dtʳ = lift (ω / rise)ʳ · y⁽ʳ⁾
//
// A translating output is shown in mm and mm/radʳ, a swinging one in deg and deg/degʳ; the cam angle always
// in degrees.
#pragma once

#include "scene/scene.hpp"

#include <array>
#include <optional>
#include <string>

namespace camopt {

/// One scale a derivative: shown value = factor[r] · y⁽ʳ⁾.
struct DerivativeScale {
    std::array<double, 4> factor{};
    std::array<std::string, 4> unit;    ///< for people: "mm", "mm/rad", "mm/rad²", "mm/rad³"
    std::array<std::string, 4> column;  ///< for files: "s_mm", "ds_mm_rad", "dds_mm_rad2", "ddds_mm_rad3"
};

struct DisplayScale {
    double degrees_per_x = 0.0;  ///< θ in degrees = degrees_per_x · x
    DerivativeScale by_angle;
    double seconds_per_x = 0.0;              ///< 0 where the scene has no speed
    std::optional<DerivativeScale> by_time;  ///< where the scene has a speed
};

[[nodiscard]] DisplayScale display_scale(const MotionSpec& motion);

}  // namespace camopt
