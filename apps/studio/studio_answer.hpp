// SPDX-License-Identifier: MIT
// What the page is told of a solve, as one JSON text.
//
//   data      as page_data (output/page/page_data.hpp)
//   laws      as page_laws, of the laws asked for
//   scene     the scene as solved, TOML
//   controls  as studio_controls
//   verdict, objective, seconds   of the solve, its own figures
#pragma once

#include "studies/delivered/solution.hpp"

#include <span>
#include <string>

namespace camopt::apps {

struct AnswerWishes {
    std::vector<std::string> laws = {};
    bool quick = false;  ///< while a slider moves: without the comparison with the reference law
};

/// Throws InputError for a law that is not in the catalogue.
[[nodiscard]] std::string studio_answer(const Solution& solution, const std::string& text,
                                        const AnswerWishes& wishes);

}  // namespace camopt::apps
