// SPDX-License-Identifier: MIT
// Studies beside a solve for spreadsheets: elastic follower trains.
#pragma once

#include "studies/response/train_study.hpp"

namespace camopt {

// dynamics.csv: stroke by stroke, motion by motion, speed by speed; history.csv: instant by instant at the
// scene's speed.
[[nodiscard]] std::string dynamics_csv(const TrainStudy& study);
[[nodiscard]] std::string history_csv(const TrainStudy& study);

}  // namespace camopt
