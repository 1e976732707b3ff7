// SPDX-License-Identifier: MIT
// pareto.svg: a front of two goals, the laws beside it, the bound of all curves, and what the other peaks
// come to along it. pareto_text: the same in a few lines. Nothing throws.
#pragma once

#include "output/chart/chart.hpp"
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
[[nodiscard]] std::string pareto_text(const ParetoPicture& picture);

}  // namespace camopt
