// SPDX-License-Identifier: MIT
// An elastic follower train over speed, as people and programs see it: every motion at the scene's speed,
// where it lifts off, the response over the speed and over one stroke (docs/theory/elastic_follower.md).
#pragma once

#include "report/document/document.hpp"
#include "studies/response/train_study.hpp"

namespace camopt {

/// Files: dynamics.csv (stroke by stroke, motion by motion, speed by speed), history.csv (instant by instant
/// at the scene's speed), steady.csv, and a picture of each response.
[[nodiscard]] Document dynamics_document(const TrainStudy& study);

}  // namespace camopt
