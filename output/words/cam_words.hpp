// SPDX-License-Identifier: MIT
// The cam of a solution in words: dimensions, figures, and what an engineer must know about it. mm, deg, N.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>
#include <vector>

namespace camopt {

/// Name, value and unit of a dimension, as shown: mm.
struct DimensionValue {
    std::string name;                   ///< "base_radius"
    std::optional<double> millimetres;  ///< none: free, and nothing was delivered
};

/// The dimensions this follower has, then the prime radius (rollers: base + roller). For a scene with a cam.
[[nodiscard]] std::vector<DimensionValue> cam_dimensions(const Solution& solution);

/// "base radius 30 mm, roller radius 10 mm, offset 0 mm, prime radius 40 mm"
[[nodiscard]] std::string dimensions_text(const Solution& solution);

/// "translating roller, turning counterclockwise"
[[nodiscard]] std::string follower_text(const CamSpec& cam);

/// The least convex radius of the cam; none where it is nowhere convex, or straight where it is most so.
[[nodiscard]] std::optional<CamExtreme> convex_radius(const CamSummary& summary);

/// One extreme of the cam: "largest pressure angle", "29.99 deg", "23.4".
struct CamFigure {
    std::string name, value;
    std::string degrees;  ///< where, counted from the start of the scene
};

/// Pressure angles, radii, contact, forces: what exists. For a solution with a cam.
[[nodiscard]] std::vector<CamFigure> cam_figures(const Solution& solution);

}  // namespace camopt
