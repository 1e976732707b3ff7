// SPDX-License-Identifier: MIT
// The cam of a scene, the load of its follower, and the limits that a cam of this kind cannot have.
#include "scene/cam_mechanism.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {
namespace {

Fault dimension_fault(const CamDimension& dimension) {
    const Dimension& value = dimension.value;
    const std::string member = value.key.empty() ? "mechanism." + dimension.name : value.key;
    for (const double number : {value.low, value.high})
        if (!std::isfinite(number)) return SceneFault{member, fmt::format("{}", number), "a finite number"};
    if (value.high < value.low)
        return SceneFault{member, fmt::format("a range from {} to {}", value.low, value.high),
                          "a range that ascends"};
    return std::nullopt;
}

constexpr const char* direct_only = "only with a cam that touches the output itself";
constexpr const char* plane_only = "only with a cam that is a plane outline";

/// Limits that only a cam which touches the output itself can have, or a plane one.
Fault foreign_limit(const Scene& scene, const CamMechanism& cam) {
    for (const LimitRow& row : limit_rows())
        if (row.in(scene.limits) && ((!cam.is_direct() && row.cams == LimitRow::Cams::disk) ||
                                     (!cam.planar() && row.cams == LimitRow::Cams::planar)))
            return SceneFault{fmt::format("limits.{}", row.name),
                              fmt::format("a limit that a cam of type \"{}\" does not have", cam.type()),
                              row.cams == LimitRow::Cams::planar ? plane_only : direct_only};
    return std::nullopt;
}

}  // namespace

std::optional<SceneFault> CamMechanism::find_fault(const CamSpec& spec, const MotionSpec& motion) const {
    for (const CamDimension& dimension : spec.dimensions)
        if (Fault fault = dimension_fault(dimension)) return fault;
    if (swings() != motion.lift_is_angle)
        return SceneFault{"motion.lift", motion.lift_is_angle ? "an angle" : "a length",
                          fmt::format("{} for this mechanism, whose output {}",
                                      swings() ? "an angle" : "a length", swings() ? "swings" : "slides")};
    const auto [least, most] = motion.displacements();
    if (std::string found = fault(spec.middle(), least, most); !found.empty())
        return SceneFault{"cam", found,
                          "a mechanism that reaches (ranges: with every dimension in its middle)"};
    return std::nullopt;
}

Fault cam_fault(const Scene& scene) {
    if (!scene.cam) return std::nullopt;
    const auto formulas = scene.cam->formulas();
    if (scene.forces && !formulas->is_direct())
        return SceneFault{"forces", fmt::format("forces with a cam of type \"{}\"", formulas->type()),
                          direct_only};
    if (Fault fault = foreign_limit(scene, *formulas)) return fault;
    return formulas->find_fault(*scene.cam, scene.motion);
}

Fault force_fault(const Scene& scene) {
    if (!scene.forces) return std::nullopt;
    if (!scene.cam) return SceneFault{"forces", "forces without a cam", "only together with a [cam] table"};
    if (!scene.motion.speed)
        return SceneFault{"forces", "forces without a speed", "only where motion.speed is given"};
    return std::nullopt;
}

}  // namespace camopt
