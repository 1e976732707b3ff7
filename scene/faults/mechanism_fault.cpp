// SPDX-License-Identifier: MIT
// A cam mechanism of a scene: its numbers, and, where its formulas are there, what they say of its reach.
#include "scene/cam_mechanism.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {
namespace {

Fault dimension_fault(const MechanismDimension& dimension) {
    const Dimension& value = dimension.value;
    const std::string member = value.key.empty() ? "mechanism." + dimension.name : value.key;
    for (const double number : {value.low, value.high})
        if (!std::isfinite(number)) return SceneFault{member, fmt::format("{}", number), "a finite number"};
    if (value.high < value.low)
        return SceneFault{member, fmt::format("a range from {} to {}", value.low, value.high),
                          "a range that ascends"};
    return std::nullopt;
}

/// Limits that a mechanism beside the disk cam does not know.
Fault foreign_limit(const Scene& scene) {
    const auto& formulas = scene.mechanism->formulas;
    const bool spatial = formulas && !formulas->planar();
    for (const LimitRow& row : limit_rows())
        if (row.in(scene.limits) &&
            (row.cams == LimitRow::Cams::disk || (spatial && row.cams == LimitRow::Cams::planar)))
            return SceneFault{fmt::format("limits.{}", row.name),
                              "a limit for a cam that is not of type \"disk\"",
                              "only with cam.type = \"disk\""};
    return std::nullopt;
}

/// Displacements given by the scene, SI.
std::pair<double, double> displacements(const MotionSpec& motion) {
    if (motion.type != MotionType::program) return {0.0, motion.lift};
    double least = 0.0, most = 0.0;
    for (const ProgramSegment& segment : motion.segments) {
        least = std::min(least, segment.to.value_or(0.0));
        most = std::max(most, segment.to.value_or(0.0));
    }
    return {motion.lift * least, motion.lift * most};
}

}  // namespace

Fault mechanism_fault(const Scene& scene) {
    if (!scene.mechanism) return std::nullopt;
    if (scene.cam) return SceneFault{"cam", "a disk cam beside another mechanism", "one of the two"};
    const MechanismSpec& spec = *scene.mechanism;
    for (const MechanismDimension& dimension : spec.dimensions)
        if (Fault fault = dimension_fault(dimension)) return fault;
    if (scene.forces)
        return SceneFault{"forces", "forces with a cam that is not of type \"disk\"",
                          "only with cam.type = \"disk\""};
    if (Fault fault = foreign_limit(scene)) return fault;
    if (!spec.formulas) return std::nullopt;
    if (spec.formulas->swings() != scene.motion.lift_is_angle)
        return SceneFault{"motion.lift", scene.motion.lift_is_angle ? "an angle" : "a length",
                          fmt::format("{} for this mechanism, whose output {}",
                                      spec.formulas->swings() ? "an angle" : "a length",
                                      spec.formulas->swings() ? "swings" : "slides")};
    const auto [least, most] = displacements(scene.motion);
    const std::vector<double> middle = spec.middle();
    if (std::string found = spec.formulas->fault(middle, least, most); !found.empty())
        return SceneFault{"cam", found,
                          "a mechanism that reaches (ranges: with every dimension in its middle)"};
    return std::nullopt;
}

}  // namespace camopt
