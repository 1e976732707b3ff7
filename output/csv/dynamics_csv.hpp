// SPDX-License-Identifier: MIT
// dynamics.csv: motion by motion, speed by speed; history.csv: instant by instant at the scene's speed.
#pragma once

#include "studies/response/train_study.hpp"

#include <string>

namespace camopt {

[[nodiscard]] std::string dynamics_csv(const TrainStudy& study);
[[nodiscard]] std::string history_csv(const TrainStudy& study);

}  // namespace camopt
