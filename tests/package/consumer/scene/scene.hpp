// SPDX-License-Identifier: MIT
// A header of the host's own.
#pragma once

inline constexpr const char* host_scene_text = R"(
[motion]
type = "DRD"
lift_mm = 10
rise_deg = 90
[spline]
segments = 10
[objective]
velocity = 0.5
acceleration = 0.5
reference = "smoothstep"
[solver]
name = "telling"
)";
