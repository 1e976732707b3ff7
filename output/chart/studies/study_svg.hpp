// SPDX-License-Identifier: MIT
// The pictures of studies: each fills a Chart (output/chart/chart.hpp) from its study. Nothing throws.
#pragma once

#include "output/chart/chart.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/pareto/pareto_front.hpp"
#include "studies/response/train_study.hpp"

namespace camopt {

/// An elastic follower train: the response over the speed, and what happens over time at one speed. File
/// names and pictures: residual and acceleration over the speed, deflection and force over the cam angle.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study);

/// pareto.svg: a front of two goals, the laws beside it, the bound of all curves, and what the other peaks
/// come to along it. pareto_text: the same in a few lines.
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
