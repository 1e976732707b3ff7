// SPDX-License-Identifier: MIT
// A motion measured on a cam, in every unit of its points: scenes with one key each.
#pragma once

#include <string>
#include <vector>

namespace camopt::input {

struct CamPointKey {
    std::string key;   ///< "measured.x_mm"
    std::string toml;  ///< 20 mm over 2 rad at a constant velocity, dwell, return
};

[[nodiscard]] std::vector<CamPointKey> cam_point_keys();

}  // namespace camopt::input
