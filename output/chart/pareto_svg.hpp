// SPDX-License-Identifier: MIT
// pareto.svg: a front of two goals, the laws beside it, the limit that no curve can pass, and
// what the other peaks come to along it. pareto_text: the same in a few lines for people.
#pragma once

#include "studies/compare/comparison.hpp"
#include "studies/pareto/pareto_front.hpp"

#include <string>

namespace camopt {

struct ParetoPicture {
    const ParetoFront& front;
    const Scene& scene;
    const Comparison* laws = nullptr;  ///< null: none are drawn
};

[[nodiscard]] std::string pareto_svg(const ParetoPicture& picture);
[[nodiscard]] std::string pareto_text(const ParetoPicture& picture);

}  // namespace camopt
