// SPDX-License-Identifier: MIT
// What the page is told of a solve, as one JSON text.
//
// A change is answered in up to three stages, so that the picture waits for nothing it does not need:
// the curve (not proved, and its words say so), the proof with words and tables, the rest (the reference law
// in the scene's place; of a scene without a motion, which change would help).
//
//   stage     "curve", "proof", "rest"
//   more      the rest is worth asking for
//   data      as page_data (output/page/page_data.hpp)
//   laws      as page_laws, of the laws asked for
//   scene     the scene as solved, TOML
//   controls  as studio_controls
//   verdict, objective, seconds   of the solve, its own figures
#pragma once

#include "studies/delivered/solution.hpp"

#include <string>
#include <vector>

namespace camopt::apps {

enum class AnswerStage : unsigned char { curve, proof, rest };

struct AnswerWishes {
    std::vector<std::string> laws = {};
    AnswerStage stage = AnswerStage::rest;
};

/// Throws InputError for a law that is not in the catalogue.
[[nodiscard]] std::string studio_answer(const Solution& solution, const std::string& text,
                                        const AnswerWishes& wishes);

}  // namespace camopt::apps
