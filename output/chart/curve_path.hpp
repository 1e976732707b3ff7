// SPDX-License-Identifier: MIT
// A derivative of a motion as SVG path data.
//
// Between breakpoints the value and its slope (the next derivative, exact) give cubic Bézier pieces: for a
// cubic spline they are the curve itself. The jerk is drawn through dense points, its steps as steps. Where a
// derivative is infinite the path is broken.
#pragma once

#include "core/motion.hpp"
#include "output/chart/value_range.hpp"

#include <functional>
#include <string>

namespace camopt {

/// From (x, y⁽ʳ⁾) to px.
struct PlotMap {
    std::function<double(double x)> horizontal;
    std::function<double(double value)> vertical;
};

/// order: 0 … 3. Motions of very many pieces are thinned out to what a screen can show.
[[nodiscard]] std::string curve_path(const Motion& motion, int order, const PlotMap& map);

/// Of 0 and the finite values of the derivative on the points the path goes through.
[[nodiscard]] ValueRange value_range(const Motion& motion, int order);

}  // namespace camopt
