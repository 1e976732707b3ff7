// SPDX-License-Identifier: MIT
// The files of a delivered cam of any planar mechanism but the disk cam, as texts.
//
// profile.csv has the columns of profile_csv.hpp: theta_deg, s_mm (s_deg), pitch_x_mm, pitch_y_mm, cam_x_mm,
// cam_y_mm, normal_x, normal_y, pressure_angle_deg, pitch_radius_mm, cam_radius_mm, regularity; s is the
// output's.
#pragma once

#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>

namespace camopt {

struct MechanismTexts {
    std::string csv, svg, pressure_angle_svg, curvature_svg;
};

/// points: of the table, evenly by cam angle; default one a tenth of a degree. Throws InputError where the
/// solution has no planar mechanism.
[[nodiscard]] MechanismTexts mechanism_texts(const Solution& solution, std::optional<int> points = {});

}  // namespace camopt
