// SPDX-License-Identifier: MIT
// An elastic follower train as pictures: the response over the speed, and what happens over time at one
// speed.
#pragma once

#include "studies/response/train_study.hpp"

#include <string>
#include <utility>
#include <vector>

namespace camopt {

/// File names and pictures: residual and acceleration over the speed, deflection and force over the cam
/// angle.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study);

}  // namespace camopt
