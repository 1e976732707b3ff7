// SPDX-License-Identifier: MIT
// Curves of a view over the cam angle: one panel each, stacked, with limits dotted, the reference law dashed,
// the measured motion, extremes and set points marked: motion.svg, profile_diagrams.svg, pressure_angle.svg,
// curvature.svg, forces.svg and drive.svg. Amplitudes of harmonics: surge.svg.
#pragma once

#include "report/view/view.hpp"

namespace camopt {

struct CurvePicture {
    std::string title;
    std::vector<std::string> lines = {};  ///< below the title
    std::string angle_title;              ///< "cam angle (deg)"
    std::string line_title = {};          ///< of the curves, in the legend
};
/// All curves, a panel each.
[[nodiscard]] std::string curve_set_svg(const CurveSet& set, const CurvePicture& picture);

/// motion.svg: displacement, velocity, acceleration and jerk, the verdict below the title. Throws InputError
/// where the solution has no motion.
[[nodiscard]] std::string motion_svg(const View& view);

/// profile_diagrams.svg, pressure_angle.svg, curvature.svg: the curves of the cam whose keys begin with
/// `key`.
[[nodiscard]] std::string cam_diagrams_svg(const View& view, std::string_view key = {});

/// forces.svg: force or moment on the follower, camshaft torque, force along the normal, Hertz pressure.
/// Where the follower cannot touch the cam the last two do not exist. Throws InputError without forces.
[[nodiscard]] std::string force_diagrams_svg(const View& view);

/// drive.svg: torque and speed of the motor over the angle, and torque over speed with the curve of the
/// motor. The solution has a motor.
[[nodiscard]] std::string drive_svg(const View& view);
/// Of that the last panel alone.
[[nodiscard]] std::string torque_over_speed_svg(const View& view);

/// surge.svg: amplitude over harmonic of the lift, logarithmic, with the natural frequency of the spring and
/// the limit. The solution has them.
[[nodiscard]] std::string surge_svg(const View& view);

}  // namespace camopt
