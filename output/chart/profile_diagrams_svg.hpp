// SPDX-License-Identifier: MIT
// profile_diagrams.svg: pressure angle and curvature of the cam over the cam angle, with their limits dotted
// and their extremes marked. Curvature in 1/mm (1/in where the scene is written in inches), > 0 convex; where
// it grows beyond all bounds the curve leaves the frame.
#pragma once

#include "core/motion.hpp"
#include "output/chart/limit_spans.hpp"
#include "output/drawing/profile_shape.hpp"
#include "studies/delivered/solution.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct ProfileDiagramLimits {
    std::vector<PressureLimit> pressure;
    std::optional<double> convex_radius_min, concave_radius_min;  ///< m; 0 is no line
};

struct ProfileMark {
    double theta = 0.0;  ///< rad
    double value = 0.0;  ///< signed: pressure angle in rad, curvature in 1/m
};
struct ProfileDiagramMarks {
    std::vector<ProfileMark> pressure, curvature;
};

/// marks: the extremes to name, from where the report has them too; none: those of the drawn points, an
/// eighth of a degree apart.
[[nodiscard]] std::string profile_diagrams_svg(const ProfileShape& shape, const ProfileDiagramLimits& limits,
                                               std::string_view title,
                                               const std::optional<ProfileDiagramMarks>& marks = {});

// forces.svg: what the follower of a direct cam and its contact carry over the cam angle: the force
// (swinging: moment) on the follower, the force along the normal, the torque of the camshaft and the Hertz
// pressure, with their limits dotted and their extremes marked where the report names them. Where the
// follower cannot touch the cam as designed the normal force and the pressure are left out: they do not
// exist.

/// motion: of the whole cam (cam_motion of studies/check/check_cam.hpp). Throws InputError where the solution
/// has no forces.
[[nodiscard]] std::string force_diagrams_svg(const Solution& solution, const Motion& motion);

}  // namespace camopt
