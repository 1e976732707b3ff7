// SPDX-License-Identifier: MIT
// Studies beside a solve as JSON: elastic follower trains.
#pragma once

#include "studies/response/train_study.hpp"

namespace camopt {

// What an elastic follower train makes of motions.

/// {"rows": [{"motion", "speed_rpm", "frequency_ratio", "residual", "peak_deflection", "peak_acceleration",
/// "lifts_off", …}], …}
[[nodiscard]] std::string dynamics_json(const TrainStudy& study);

}  // namespace camopt
