// SPDX-License-Identifier: MIT
// Limits that need a speed, a cam or forces, and those that a follower cannot have.
#include "scene/scene_faults.hpp"

#include <fmt/format.h>

#include <array>

namespace camopt {
namespace {

struct CamLimit {
    const char* name;
    const std::optional<WrittenLimit> LimitSpec::*limit;
    bool needs_forces;
};

constexpr std::array cam_limits = {
    CamLimit{"pressure_angle", &LimitSpec::pressure_angle, false},
    CamLimit{"rise_pressure_angle", &LimitSpec::rise_pressure_angle, false},
    CamLimit{"return_pressure_angle", &LimitSpec::return_pressure_angle, false},
    CamLimit{"cam_radius_min", &LimitSpec::cam_radius_min, false},
    CamLimit{"concave_radius_min", &LimitSpec::concave_radius_min, false},
    CamLimit{"undercut_margin", &LimitSpec::undercut_margin, false},
    CamLimit{"contact_force_min", &LimitSpec::contact_force_min, true},
    CamLimit{"torque_max", &LimitSpec::torque_max, true},
    CamLimit{"hertz_pressure_max", &LimitSpec::hertz_pressure_max, true},
};

Fault time_fault(const Scene& scene) {
    for (const auto& [name, limit] :
         {std::pair{"velocity", &scene.limits.velocity},
          std::pair{"acceleration", &scene.limits.acceleration}, std::pair{"jerk", &scene.limits.jerk}})
        if (*limit && !(*limit)->unit.empty() && !scene.motion.speed)
            return SceneFault{fmt::format("limits.{}", name),
                              fmt::format("a limit in {} without a speed", (*limit)->unit),
                              "a limit in time only where motion.speed is given"};
    return std::nullopt;
}

Fault missing_table_fault(const Scene& scene) {
    for (const CamLimit& row : cam_limits) {
        if (!(scene.limits.*row.limit)) continue;
        const std::string member = fmt::format("limits.{}", row.name);
        if (!scene.cam && !scene.mechanism)
            return SceneFault{member, "a limit of a cam without a cam", "only together with a [cam] table"};
        if (row.needs_forces && !scene.forces)
            return SceneFault{member, "a limit of a force without forces",
                              "only together with a [forces] table"};
    }
    return std::nullopt;
}

/// The cam is there.
Fault follower_fault(const Scene& scene) {
    const LimitSpec& limits = scene.limits;
    const auto follower = scene.cam->follower;
    if (limits.concave_radius_min && has_flat_face(follower))
        return SceneFault{"limits.concave_radius_min",
                          fmt::format("a concave radius for the follower \"{}\"", name_of(follower)),
                          "only with rollers and knife edges: a flat face touches no concave cam"};
    if (!limits.hertz_pressure_max) return std::nullopt;
    if (has_edge(follower))
        return SceneFault{"limits.hertz_pressure_max",
                          fmt::format("a pressure for the follower \"{}\"", name_of(follower)),
                          "only with rollers and flat faces: under an edge it is infinite"};
    if (!scene.forces->contact_width)
        return SceneFault{"limits.hertz_pressure_max", "a pressure without a contact width",
                          "only where forces.contact_width is given"};
    return std::nullopt;
}

}  // namespace

Fault limit_fault(const Scene& scene) {
    if (Fault fault = time_fault(scene)) return fault;
    if (Fault fault = missing_table_fault(scene)) return fault;
    return scene.cam ? follower_fault(scene) : std::nullopt;
}

}  // namespace camopt
