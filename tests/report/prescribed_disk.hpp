// SPDX-License-Identifier: MIT
#pragma once

namespace camopt::testing_support {

/// A disk cam of laws alone, which is solved at once; [cam] is its last table.
inline constexpr const char* prescribed_disk_toml = R"(
[motion]
type = "program"
lift_mm = 8
speed_rpm = 300
segments = [{ kind = "law", law = "cycloidal", angle_deg = 120, to_mm = 8 }, { kind = "dwell", angle_deg = 60 },
            { kind = "law", law = "cycloidal", angle_deg = 120, to_mm = 0 }, { kind = "dwell", angle_deg = 60 }]
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 20
roller_radius_mm = 6
)";

}  // namespace camopt::testing_support
