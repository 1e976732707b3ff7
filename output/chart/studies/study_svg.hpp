// SPDX-License-Identifier: MIT
// The pictures of studies: each fills a Chart (output/chart/chart.hpp) from its study. Nothing throws.
#pragma once

#include "studies/compare/comparison.hpp"
#include "studies/pareto/pareto_front.hpp"
#include "studies/response/train_study.hpp"

namespace camopt {

/// An elastic follower train: the response over the speed, and what happens over time at one speed. File
/// names and pictures: residual and acceleration over the speed, deflection and force over the cam angle.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study);

/// A comparison: one bar a law, sorted by the objective, with its peaks and its loss. Solid bars satisfy
/// every limit; hatched ones violate some, and the worst is named. Bars far longer than the optimum's are
/// cut.
[[nodiscard]] std::string comparison_svg(const Comparison& comparison);

/// pareto.svg: a front of two goals, the laws beside it, the bound of all curves, and what the other peaks
/// come to along it. pareto_text: the same in a few lines.
struct ParetoPicture {
    const ParetoFront& front;
    const Scene& scene;
    const Comparison* laws = nullptr;  ///< null: none are drawn
};

[[nodiscard]] std::string pareto_svg(const ParetoPicture& picture);
[[nodiscard]] std::string pareto_text(const ParetoPicture& picture);

}  // namespace camopt
