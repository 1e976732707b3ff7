// SPDX-License-Identifier: MIT
// Studies beside a solve for spreadsheets: elastic follower trains, comparisons.
#pragma once

#include "studies/compare/comparison.hpp"
#include "studies/response/train_study.hpp"

namespace camopt {

// dynamics.csv: stroke by stroke, motion by motion, speed by speed; history.csv: instant by instant at the
// scene's speed.
[[nodiscard]] std::string dynamics_csv(const TrainStudy& study);
[[nodiscard]] std::string history_csv(const TrainStudy& study);

// A comparison for spreadsheets: one line a law, the optimum among them with an empty key.
//
// Peaks are normalised. One column a limit holds what the motion reaches, in the unit of its key. Numbers
// read back as the same double; what is infinite or absent is an empty cell. Nothing throws.
[[nodiscard]] std::string comparison_csv(const Comparison& comparison);

}  // namespace camopt
