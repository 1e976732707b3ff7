// SPDX-License-Identifier: MIT
// What an elastic follower train makes of motions, as JSON: the command's table, and the part of result.json.
#pragma once

#include "studies/response/train_study.hpp"

#include <string>

namespace camopt {

/// {"rows": [{"motion", "speed_rpm", "frequency_ratio", "residual", "peak_deflection", "peak_acceleration",
/// "lifts_off", …}], …}
[[nodiscard]] std::string dynamics_json(const TrainStudy& study);

}  // namespace camopt
