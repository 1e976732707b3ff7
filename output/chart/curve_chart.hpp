// SPDX-License-Identifier: MIT
// Curves of a view over the cam angle: one panel each, stacked, with limits dotted, the reference law dashed,
// the measured motion, extremes and set points marked. One renderer for motion.svg, profile_diagrams.svg,
// pressure_angle.svg, curvature.svg and forces.svg.
#pragma once

#include "output/view/view.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace camopt {

struct CurveChart {
    std::string title;
    std::vector<std::string> lines = {};  ///< below the title
    bool legend = false;
    bool closed = true;                     ///< over the whole cam, not only over its motion
    std::vector<const Curve*> panels = {};  ///< of the view
};

[[nodiscard]] std::string curve_chart_svg(const View& view, const CurveChart& chart);

/// The curves of a group ("motion", "cam", "forces") whose keys begin with `key`; in their order.
[[nodiscard]] std::vector<const Curve*> curves_of(const View& view, std::string_view group,
                                                  std::string_view key = {});

/// motion.svg: displacement, velocity, acceleration and jerk, the verdict below the title. Throws InputError
/// where the solution has no motion.
[[nodiscard]] std::string motion_svg(const View& view);

/// profile_diagrams.svg, pressure_angle.svg, curvature.svg: the curves of the cam whose keys begin with
/// `key`.
[[nodiscard]] std::string cam_diagrams_svg(const View& view, std::string_view key = {});

/// forces.svg: force or moment on the follower, camshaft torque, force along the normal, Hertz pressure.
/// Where the follower cannot touch the cam the last two do not exist. Throws InputError without forces.
[[nodiscard]] std::string force_diagrams_svg(const View& view);

}  // namespace camopt
