// SPDX-License-Identifier: MIT
// Whether any cam within the ranges of its dimensions can be built at rest. With p = base + roller radius:
//   translating roller, knife: |offset| < p            oscillating roller: |a − l| < p < a + l
//   oscillating flat: |base + face offset| < a         (a centre distance, l arm length)
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace {

using enum DimensionIndex;

/// In the unit the dimension was written in.
std::string length_text(double value, const Dimension& dimension) {
    const char* unit = "mm";
    double factor = 1e-3;
    if (dimension.unit == 0.0254) {
        unit = "in";
        factor = dimension.unit;
    } else if (dimension.unit == 1.0) {
        unit = "m";
        factor = 1.0;
    }
    return fmt::format("{:.6g} {}", value / factor, unit);
}

const char* prime_name(const CamSpec& cam) {
    return has_roller(cam.follower) ? "base radius + roller radius" : "base radius";
}

Fault offset_fault(const CamSpec& cam) {
    const Dimension& given = cam[offset];
    const double least = std::max({given.low, -given.high, 0.0});
    const double prime = cam[base_radius].high + cam[roller_radius].high;
    if (least < prime) return std::nullopt;
    return SceneFault{"cam.offset",
                      fmt::format("an offset of {}", length_text(given.low > 0.0 ? least : -least, given)),
                      fmt::format("less than {} to either side, the largest {}", length_text(prime, given),
                                  prime_name(cam))};
}

Fault arm_fault(const CamSpec& cam) {
    const Dimension& base = cam[base_radius];
    const Dimension& center = cam[center_distance];
    const Dimension& arm = cam[arm_length];
    const double difference = std::max({center.low - arm.high, arm.low - center.high, 0.0});
    const double largest = base.high + cam[roller_radius].high;
    if (!(largest > difference))
        return SceneFault{"cam.base_radius",
                          fmt::format("{} for {}", length_text(largest, base), prime_name(cam)),
                          fmt::format("more than {}, the difference of center distance and arm length",
                                      length_text(difference, base))};
    const double sum = center.high + arm.high;
    const double smallest = base.low + cam[roller_radius].low;
    if (!(smallest < sum))
        return SceneFault{
            "cam.base_radius", fmt::format("{} for {}", length_text(smallest, base), prime_name(cam)),
            fmt::format("less than {}, the sum of center distance and arm length", length_text(sum, base))};
    return std::nullopt;
}

Fault face_reach_fault(const CamSpec& cam) {
    const Dimension& base = cam[base_radius];
    const double center = cam[center_distance].high;
    const double smallest = base.low + cam[face_offset].low;
    const double largest = base.high + cam[face_offset].high;
    if (smallest < center && largest > -center) return std::nullopt;
    return SceneFault{
        "cam.base_radius",
        fmt::format("{} for base radius + face offset",
                    length_text(smallest < center ? largest : smallest, base)),
        fmt::format("less than {} to either side, the center distance", length_text(center, base))};
}

}  // namespace

Fault cam_geometry_fault(const CamSpec& cam) {
    if (has_dimension(cam.follower, offset)) return offset_fault(cam);
    if (has_dimension(cam.follower, arm_length)) return arm_fault(cam);
    if (has_dimension(cam.follower, face_offset)) return face_reach_fault(cam);
    return std::nullopt;
}

}  // namespace camopt
