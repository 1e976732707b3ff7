// SPDX-License-Identifier: MIT
#include "apps/studio/studio_page.hpp"

#include <fmt/format.h>

namespace camopt::apps {

StudioStart first_scene() {
    return {"new scene", R"(title = "A rise between two dwells"

[motion]
type = "DRD"
lift_mm = 10
rise_deg = 120
speed_rpm = 300

[spline]
degree = 3
segments = 32

[objective]
velocity = 0.4
acceleration = 0.4
jerk = 0.2
)"};
}

StudioAnswer studio_page(const StudioStart&) {
    return {.type = "text/html; charset=utf-8", .body = "<!doctype html>"};
}

}  // namespace camopt::apps
