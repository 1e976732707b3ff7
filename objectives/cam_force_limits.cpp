// SPDX-License-Identifier: MIT
// Contact force, camshaft torque and Hertz pressure.
#include "core/errors.hpp"
#include "objectives/cam_limit_parts.hpp"
#include "profiles/quantity_algebra.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt::cam_limit_parts {

namespace {

/// F = m ω² s'' + k s + F_0 (or the moment of an arm).
QuantityValue force_of(const ForceSpec& force, double speed, const FollowerState& state) {
    QuantityValue value = constant_quantity(force.force(speed, state.s, state.acceleration));
    value.gradient[0] = force.spring_rate;
    value.gradient[2] = force.mass * speed * speed;
    return value;
}

}  // namespace

void add_forces(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!scene.forces || !scene.motion.speed) return;
    const ForceSpec force = *scene.forces;
    const double speed = *scene.motion.speed;
    const LimitSpec& limits = scene.limits;
    if (const auto& least = limits.contact_force_min) {
        const double swing =
            force.mass * speed * speed * cam->scale.lift / (cam->scale.unit_angle * cam->scale.unit_angle);
        const double unit = std::max({std::abs(least->value), force.preload, swing, least_scale});
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{
                     least->key,
                     [force, speed, unit, least = least->value](const DiskCam&, const FollowerState& state) {
                         return scaled(shifted(force_of(force, speed, state), -least), -1.0 / unit);
                     },
                     2,
                     true,
                     1.0,
                     {}}));
    }
    if (const auto& most = limits.torque_max) {
        for (const int sign : {1, -1}) {
            rules.push_back(std::make_shared<CamRule>(
                cam, CamFormula{most->key,
                                [force, speed, sign, most = most->value](const DiskCam&,
                                                                         const FollowerState& state) {
                                    return shifted(scaled(product(force_of(force, speed, state),
                                                                  variable_quantity(state.velocity, 1)),
                                                          sign / most),
                                                   -1.0);
                                },
                                2,
                                false,
                                1.0,
                                {}}));
        }
    }
    if (const auto& most = limits.hertz_pressure_max) {
        if (cam->cam.follower == FollowerType::translating_knife) {
            throw InputError(most->key +
                             ": found a limit on the Hertz pressure of a knife edge; allowed: a roller "
                             "or a flat face");
        }
        if (!force.contact_width) {
            throw InputError(most->key +
                             ": found no contact width; allowed: together with forces.contact_width_mm");
        }
        const double factor =
            1.0 / (force.compliance() * std::numbers::pi * *force.contact_width * most->value * most->value);
        rules.push_back(std::make_shared<CamRule>(
            cam, CamFormula{
                     most->key,
                     [force, speed, factor](const DiskCam& own, const FollowerState& state) {
                         // 1/ρ_cam + 1/r = 1/(r · regularity) for a roller.
                         const bool roller = has_roller(own.follower);
                         QuantityValue radius =
                             quantity(own, state, roller ? Quantity::regularity : Quantity::cam_radius);
                         if (roller) {
                             radius =
                                 product(radius, variable_quantity(own[DimensionIndex::roller_radius],
                                                                   column_of(DimensionIndex::roller_radius)));
                         }
                         const QuantityValue lever = quantity(own, state, Quantity::normal_lever);
                         return shifted(
                             scaled(quotient(force_of(force, speed, state), product(radius, lever)), factor),
                             -1.0);
                     },
                     2,
                     false,
                     2.0,
                     {}}));  // a pressure grows with the root of the force
    }
}

}  // namespace camopt::cam_limit_parts
