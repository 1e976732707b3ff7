// SPDX-License-Identifier: MIT
// A figure of a paper's report as a picture: curves or points over two axes, with a legend.
#pragma once

#include "studies/compare/comparison.hpp"
#include "studies/papers/paper_report.hpp"
#include "studies/pareto/pareto_front.hpp"
#include "studies/response/train_study.hpp"

#include <string>
#include <utility>
#include <vector>

namespace camopt {

[[nodiscard]] std::string paper_figure_svg(const PaperFigure& figure);

// An elastic follower train as pictures: the response over the speed, and what happens over time at one
// speed.

/// File names and pictures: residual and acceleration over the speed, deflection and force over the cam
/// angle.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study);

// A comparison as a picture: one bar a law, sorted by the objective, with its peaks and its loss.
//
// Solid bars satisfy every limit; hatched ones break some, and the heaviest is named. Bars far longer than
// the optimum's are cut. Nothing throws.
[[nodiscard]] std::string comparison_svg(const Comparison& comparison);

// pareto.svg: a front of two goals, the laws beside it, the limit that no curve can pass, and
// what the other peaks come to along it. pareto_text: the same in a few lines for people.
struct ParetoPicture {
    const ParetoFront& front;
    const Scene& scene;
    const Comparison* laws = nullptr;  ///< null: none are drawn
};

[[nodiscard]] std::string pareto_svg(const ParetoPicture& picture);
[[nodiscard]] std::string pareto_text(const ParetoPicture& picture);

}  // namespace camopt
