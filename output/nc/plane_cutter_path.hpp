// SPDX-License-Identifier: MIT
// The path of an end mill around a plane cam: its axis stands off the contour by its radius and the stock.
//
//   tip = (P + (T_D / 2 + λ) n, bottom),  axis −z
// P a point of the cam, n its outward normal. A cutter larger than a hollow of the cam cuts into it: the
// check (nc_check.hpp) tells. Frame of tool_pose.hpp; m.
#pragma once

#include "output/nc/tool_pose.hpp"

#include <Eigen/Core>

#include <functional>

namespace camopt {

struct ContourPoint {
    Eigen::Vector2d position;  ///< m
    Eigen::Vector2d normal;    ///< unit, out of the material
};
using PlaneContour = std::function<ContourPoint(double theta)>;

struct PlaneCutter {
    double diameter = 0.0;  ///< m, > 0
    double stock = 0.0;     ///< λ, m, >= 0
    double bottom = 0.0;    ///< z of the tip, m: at or below the cam's underside

    void validate() const;  ///< throws InputError
};

/// Throws InputError for a cutter that is not valid.
[[nodiscard]] ToolPath plane_cutter_path(PlaneContour contour, const PlaneCutter& cutter);

}  // namespace camopt
