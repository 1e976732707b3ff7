// SPDX-License-Identifier: MIT
// An elastic follower train in words and tables for people.
#pragma once

#include "studies/response/train_study.hpp"

#include <string>
#include <vector>

namespace camopt {

/// What the command prints: the train, every motion at the scene's speed, where it lifts off.
[[nodiscard]] std::string dynamics_text(const TrainStudy& study);
/// A sentence a figure: of result reports.
[[nodiscard]] std::vector<std::string> train_sentences(const Solution& solution);

}  // namespace camopt
