// SPDX-License-Identifier: MIT
// The files of a delivered cam as texts: points, pictures, drawing.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>

namespace camopt {

struct CamProfileTexts {
    std::string csv, svg, diagrams_svg;
    std::optional<std::string> dxf;
};

struct CamProfileOptions {
    std::optional<int> points = {};  ///< of the table, evenly by cam angle; none: by the chord tolerance
    double chord_tolerance = 1e-6;   ///< m: a polyline through the table's points stays this close to the cam
    double dxf_tolerance = 1e-6;     ///< m: of the drawing's arcs
    bool dxf = false;
};

/// The whole cam: an RR motion is followed by its dwell, a DRD motion stays a sector. Throws InputError where
/// the solution has no cam.
[[nodiscard]] CamProfileTexts cam_profile(const Solution& solution, const CamProfileOptions& options = {});

}  // namespace camopt
