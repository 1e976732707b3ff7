// SPDX-License-Identifier: MIT
// Numbers of a scene against their ranges, one table.
#include "core/range.hpp"
#include "scene/scene_faults.hpp"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace camopt {
namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
const Range positive = Range::above(0.0);
const Range not_negative = Range::at_least(0.0);
const Range right_angle = {
    .low = 0.0, .high = 0.5 * std::numbers::pi, .low_included = false, .high_included = false};
const Range poisson_ratio = {.low = 0.0, .high = 0.5, .high_included = false};
const Range below_one = {.low = 0.0, .high = 1.0, .high_included = false};

using Number = std::optional<double>;

struct NumberRule {
    const char* member;
    Number (*value)(const Scene&);
    Range range;
};

Number normalised(const std::optional<PeakLimit>& limit) {
    return limit ? Number(limit->normalised) : std::nullopt;
}

Number value_of(const std::optional<WrittenLimit>& limit) {
    return limit ? Number(limit->value) : std::nullopt;
}

Number of_forces(const Scene& scene, double ForceSpec::*member) {
    return scene.forces ? Number((*scene.forces).*member) : std::nullopt;
}

Number weight(const Scene& scene, DimensionIndex index) {
    return scene.objective.dimensions[static_cast<std::size_t>(index)];
}

const std::array number_rules = {
    NumberRule{"motion.lift", [](const Scene& s) { return Number(s.motion.lift); }, positive},
    NumberRule{"motion.rise", [](const Scene& s) { return Number(s.motion.rise); },
               Range::above_up_to(0.0, full_turn)},
    NumberRule{"motion.return_angle", [](const Scene& s) { return s.motion.return_angle; },
               Range::above_up_to(0.0, full_turn)},
    NumberRule{"motion.speed", [](const Scene& s) { return s.motion.speed; }, positive},
    NumberRule{"objective.velocity", [](const Scene& s) { return Number(s.objective.velocity); },
               not_negative},
    NumberRule{"objective.acceleration", [](const Scene& s) { return Number(s.objective.acceleration); },
               not_negative},
    NumberRule{"objective.jerk", [](const Scene& s) { return Number(s.objective.jerk); }, not_negative},
    NumberRule{"objective.torque", [](const Scene& s) { return Number(s.objective.torque); }, not_negative},
    NumberRule{"objective.rms_acceleration",
               [](const Scene& s) { return Number(s.objective.rms_acceleration); }, not_negative},
    NumberRule{"objective.rms_jerk", [](const Scene& s) { return Number(s.objective.rms_jerk); },
               not_negative},
    NumberRule{"objective.base_radius", [](const Scene& s) { return weight(s, DimensionIndex::base_radius); },
               not_negative},
    NumberRule{"objective.roller_radius",
               [](const Scene& s) { return weight(s, DimensionIndex::roller_radius); }, not_negative},
    NumberRule{"objective.offset", [](const Scene& s) { return weight(s, DimensionIndex::offset); },
               not_negative},
    NumberRule{"objective.center_distance",
               [](const Scene& s) { return weight(s, DimensionIndex::center_distance); }, not_negative},
    NumberRule{"objective.arm_length", [](const Scene& s) { return weight(s, DimensionIndex::arm_length); },
               not_negative},
    NumberRule{"objective.face_offset", [](const Scene& s) { return weight(s, DimensionIndex::face_offset); },
               not_negative},
    NumberRule{"objective.reference.velocity", [](const Scene& s) { return s.objective.reference.velocity; },
               positive},
    NumberRule{"objective.reference.acceleration",
               [](const Scene& s) { return s.objective.reference.acceleration; }, positive},
    NumberRule{"objective.reference.jerk", [](const Scene& s) { return s.objective.reference.jerk; },
               positive},
    NumberRule{"objective.reference.torque", [](const Scene& s) { return s.objective.reference.torque; },
               positive},
    NumberRule{"objective.reference.rms_acceleration",
               [](const Scene& s) { return s.objective.reference.rms_acceleration; }, positive},
    NumberRule{"objective.reference.rms_jerk", [](const Scene& s) { return s.objective.reference.rms_jerk; },
               positive},
    NumberRule{"forces.mass", [](const Scene& s) { return of_forces(s, &ForceSpec::mass); }, not_negative},
    NumberRule{"forces.spring_rate", [](const Scene& s) { return of_forces(s, &ForceSpec::spring_rate); },
               not_negative},
    NumberRule{"forces.preload", [](const Scene& s) { return of_forces(s, &ForceSpec::preload); }, Range{}},
    NumberRule{"forces.contact_width",
               [](const Scene& s) { return s.forces ? s.forces->contact_width : std::nullopt; }, positive},
    NumberRule{"forces.cam_modulus", [](const Scene& s) { return of_forces(s, &ForceSpec::cam_modulus); },
               positive},
    NumberRule{"forces.follower_modulus",
               [](const Scene& s) { return of_forces(s, &ForceSpec::follower_modulus); }, positive},
    NumberRule{"forces.cam_poisson", [](const Scene& s) { return of_forces(s, &ForceSpec::cam_poisson); },
               poisson_ratio},
    NumberRule{"forces.follower_poisson",
               [](const Scene& s) { return of_forces(s, &ForceSpec::follower_poisson); }, poisson_ratio},
    NumberRule{"limits.velocity", [](const Scene& s) { return normalised(s.limits.velocity); }, positive},
    NumberRule{"limits.acceleration", [](const Scene& s) { return normalised(s.limits.acceleration); },
               positive},
    NumberRule{"limits.jerk", [](const Scene& s) { return normalised(s.limits.jerk); }, positive},
    NumberRule{"limits.pressure_angle", [](const Scene& s) { return value_of(s.limits.pressure_angle); },
               right_angle},
    NumberRule{"limits.rise_pressure_angle",
               [](const Scene& s) { return value_of(s.limits.rise_pressure_angle); }, right_angle},
    NumberRule{"limits.return_pressure_angle",
               [](const Scene& s) { return value_of(s.limits.return_pressure_angle); }, right_angle},
    NumberRule{"limits.cam_radius_min", [](const Scene& s) { return value_of(s.limits.cam_radius_min); },
               not_negative},
    NumberRule{"limits.concave_radius_min",
               [](const Scene& s) { return value_of(s.limits.concave_radius_min); }, not_negative},
    NumberRule{"limits.undercut_margin", [](const Scene& s) { return value_of(s.limits.undercut_margin); },
               below_one},
    NumberRule{"limits.contact_force_min",
               [](const Scene& s) { return value_of(s.limits.contact_force_min); }, not_negative},
    NumberRule{"limits.torque_max", [](const Scene& s) { return value_of(s.limits.torque_max); }, positive},
    NumberRule{"limits.hertz_pressure_max",
               [](const Scene& s) { return value_of(s.limits.hertz_pressure_max); }, positive},
    NumberRule{"solver.tolerance", [](const Scene& s) { return Number(s.solver.tolerance); },
               Range::between(1e-12, 1e-2)},
    NumberRule{"solver.gap", [](const Scene& s) { return Number(s.solver.gap); },
               Range::between(1e-12, 1e-2)},
    NumberRule{"solver.max_seconds", [](const Scene& s) { return Number(s.solver.max_seconds); }, positive},
};

}  // namespace

Fault number_fault(const Scene& scene) {
    for (const NumberRule& rule : number_rules) {
        const Number value = rule.value(scene);
        if (value && !rule.range.contains(*value))
            return SceneFault{rule.member, fmt::format("{}", *value), rule.range.number_text()};
    }
    if (scene.solver.starts && *scene.solver.starts < 1)
        return SceneFault{"solver.starts", fmt::to_string(*scene.solver.starts),
                          Range::at_least(1).integer_text()};
    return std::nullopt;
}

}  // namespace camopt
