// SPDX-License-Identifier: MIT
// The files of a delivered inverse cam, as texts: its guide in the frame of its body (origin: the body's
// pivot; x axis: through the roller where the body stands at angle 0).
//
// guide.csv has the columns theta_deg, s_mm (the feeder's), middle_x_mm, middle_y_mm (the roller's centre),
// left_x_mm, left_y_mm, right_x_mm, right_y_mm (the walls, seen outwards), pressure_angle_deg,
// middle_radius_mm
// (> 0: bent to the left), regularity_left, regularity_right.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>

namespace camopt {

struct GuideTexts {
    std::string csv, svg, pressure_angle_svg;
};

/// points: of the table, evenly by cam angle; default one a tenth of a degree. Throws InputError where the
/// solution has no guide.
[[nodiscard]] GuideTexts guide_texts(const Solution& solution, std::optional<int> points = {});

}  // namespace camopt
