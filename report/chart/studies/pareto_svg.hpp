// SPDX-License-Identifier: MIT
// pareto.svg: a front of two goals, the laws beside it, the bound of all curves, and what the other peaks
// come to along it. Nothing throws.
#pragma once

#include "report/chart/chart.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/pareto/pareto_front.hpp"

namespace camopt {

struct ParetoPicture {
    const ParetoFront& front;
    const Scene& scene;
    const Comparison* laws = nullptr;  ///< null: none are drawn
};

[[nodiscard]] Chart pareto_chart(const ParetoPicture& picture);
[[nodiscard]] inline std::string pareto_svg(const ParetoPicture& picture) {
    return chart_svg(pareto_chart(picture));
}
/// "velocity v (mm/s)", and the value of a point in that unit.
[[nodiscard]] std::string goal_title(const ParetoPicture& picture, int goal);
[[nodiscard]] double shown_goal(const ParetoPicture& picture, const FrontPoint& point, int goal);
/// How many points, how even; how the front ends.
[[nodiscard]] std::string front_sentence(const ParetoFront& front);
[[nodiscard]] std::string end_sentence(const ParetoPicture& picture);

}  // namespace camopt
