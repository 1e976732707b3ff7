// SPDX-License-Identifier: MIT
// What a motion does to what it drives, and the program's own terms: a sentence a figure.
#pragma once

#include "studies/delivered/solution.hpp"

namespace camopt {

/// "speed reaches 1.7, 0.4 in the objective (weight …)"
[[nodiscard]] std::string own_term_sentence(const OwnTermReport& term);
/// Of the elastic follower train; empty without one.
[[nodiscard]] std::vector<std::string> train_sentences(const Solution& solution);
/// What the motion asks of the motor; empty without one.
[[nodiscard]] std::vector<std::string> drive_sentences(const Solution& solution);

}  // namespace camopt
