// SPDX-License-Identifier: MIT
// Contact force, camshaft torque and Hertz pressure, and the contact that the last two take for granted.
#include "core/errors.hpp"
#include "objectives/rules/cam_limit_parts.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "scene/limit_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt::cam_limit_parts {

namespace {

// Torque and pressure speak of a follower that touches a regular cam. Where no limit of the scene says so,
// its regularity (1 − r κ; flat: radius/base radius) and the height of its contact over the cam centre (in
// units of the cam) stay above this: any cam that a machine can make is far inside, and no rounding reaches
// through it.
constexpr double least_contact = 1e-6;
// Forces far below the largest say nothing of the size of a pressure.
constexpr double least_force_share = 1e-2;
// A pressure grows with the root of the force: twice this relative excess of the force is one of the
// pressure.
constexpr double pressure_scale = 2.0;

/// F = m ω² s'' + k s + F_0 (or the moment of an arm).
template <class State>
auto force_of(const ForceSpec& force, double speed, const State& state) {
    return shifted(
        sum(force.mass * speed * speed, acceleration(state), force.spring_rate, displacement(state)),
        force.preload);
}

/// The size of the inertia's force.
double swing_of(const ForceSpec& force, double speed, const MotionScale& scale) {
    return force.mass * speed * speed * scale.lift / (scale.unit_angle * scale.unit_angle);
}

void add_contact_force(Rules& rules, const WrittenLimit& limit, const ForceSpec& force, double speed,
                       const Shared& cam) {
    const double unit =
        std::max({std::abs(limit.value), force.preload, swing_of(force, speed, cam->scale), least_scale});
    CamFormula formula =
        cam_formula(limit.key, [force, speed, unit, least = limit.value](const DiskCam&, const auto& state) {
            return scaled(shifted(force_of(force, speed, state), -least), -1.0 / unit);
        });
    formula.linear = true;
    rules.push_back(std::make_shared<CamRule>(cam, std::move(formula)));
}

void add_torque(Rules& rules, const WrittenLimit& limit, const ForceSpec& force, double speed,
                const Shared& cam) {
    for (const int sign : {1, -1}) {
        rules.push_back(std::make_shared<CamRule>(
            cam, cam_formula(limit.key, [force, speed, sign, most = limit.value](const DiskCam&,
                                                                                 const auto& state) {
                return shifted(scaled(product(force_of(force, speed, state), velocity(state)), sign / most),
                               -1.0);
            })));
    }
}

/// p² = F/(lever π b R c) <= p_max², c the compliance, as F <= R · lever · π b p_max² c: no division, so that
/// nothing flips where the cam's radius or the lever passes through zero. Where F is not positive nothing
/// presses.
/// In a groove with a clearance the roller touches a surface that is not quite its pitch curve's offset by
/// its own radius: F (1 − (R − r) κ) <= r (1 − R κ) · lever · … of disk_sides.hpp.
struct Pressed {
    double carried = 0.0, unit = 1.0;
    int side = 0;
};

template <class State>
auto pressure_excess_on(const DiskCam& own, const State& state, const Pressed& pressed, const auto& press) {
    const int side = pressed.side;
    const auto radius =
        product(quantity(own, state, Quantity::regularity, side), roller_on(own, state, side));
    const double wider = surface_offset(own, side) - roller_radius_of(own, side);
    const auto curvature = quantity(own, state, Quantity::pitch_curvature, side);
    const auto pressing = wider > 0.0 ? product(press, shifted(scaled(curvature, -wider), 1.0)) : press;
    return sum(1.0, pressing, -pressed.carried / pressed.unit,
               product(radius, quantity(own, state, Quantity::normal_lever, side)));
}

void add_pressure_in_contact(Rules& rules, const WrittenLimit& limit, const ForceSpec& force, double speed,
                             const Shared& cam, int side) {
    const auto follower = cam->cam.follower;
    if (has_edge(follower)) {
        throw InputError(limit.key +
                         ": found a limit on the Hertz pressure of a knife edge; allowed: a roller "
                         "or a flat face");
    }
    if (!force.contact_width) {
        throw InputError(limit.key +
                         ": found no contact width; allowed: together with forces.contact_width_mm");
    }
    const double carried =
        force.compliance() * std::numbers::pi * *force.contact_width * limit.value * limit.value;
    const double unit =
        std::max({force.preload, least_force_share * swing_of(force, speed, cam->scale), least_scale});
    CamFormula formula =
        cam_formula(limit.key, [force, speed, carried, unit, side](const DiskCam& own, const auto& state) {
            const auto press = scaled(force_of(force, speed, state), pressing_sense(side) / unit);
            const double factor = -carried / unit;
            // 1/R = 1/ρ_cam + 1/r = 1/(r · regularity) for a roller.
            if (!has_roller(own.follower)) {
                const auto radius = quantity(own, state, Quantity::cam_radius);
                if (has_pushed_face(own.follower)) return sum(1.0, press, factor, radius);
                return sum(1.0, press, factor, product(radius, quantity(own, state, Quantity::normal_lever)));
            }
            return pressure_excess_on(own, state, {carried, unit, side}, press);
        });
    formula.linear = has_pushed_face(follower);
    formula.scale = pressure_scale;
    add_on_side(rules, cam, std::move(formula), side);
}

/// The contact lies above the cam's centre, so that the force along the normal lifts the follower.
void add_height(Rules& rules, const Shared& cam, const std::string& key, int side) {
    const auto follower = cam->cam.follower;
    if (has_pushed_face(follower)) return;
    const double length = length_of(cam->cam);
    CamFormula formula = cam_formula(key, [length, side](const DiskCam& own, const auto& state) {
        return shifted(scaled(quantity(own, state, Quantity::pressure_denominator, side), -1.0 / length),
                       least_contact);
    });
    formula.highest_order = 0;
    formula.linear = !is_oscillating(follower) && cam->variables.empty();
    add_on_side(rules, cam, std::move(formula), side);
}

void add_contact(Rules& rules, const Scene& scene, const Shared& cam, const std::string& key) {
    const LimitSpec& limits = scene.limits;
    // A limit of 0 leaves a cusp, on which nothing can press.
    const auto& radius = limit_on(limits, LimitedFigure::convex_radius);
    const auto& margin = limit_on(limits, LimitedFigure::regularity);
    const bool regular = (radius && radius->value > 0.0) || (margin && margin->value >= least_contact);
    const PressureLimits pressure = pressure_limits(limits);
    for (int side = 0; side < side_count(cam->cam); ++side) {
        if (!regular) add_regularity(rules, cam, {least_contact, key + " (undercut)"}, side);
        // |N| cos φm <= D sin φm to both sides holds the height up too; in a groove both flanks have one.
        const bool held = pressure.rise && pressure.back;
        if (!held && (side == 0 || cam->cam.form.is_conjugate()))
            add_height(rules, cam, key + " (contact below the cam's centre)", side);
    }
}

}  // namespace

void add_forces(Rules& rules, const Scene& scene, const Shared& cam) {
    if (!scene.forces || !scene.motion.speed) return;
    const ForceSpec& force = *scene.forces;
    const double speed = *scene.motion.speed;
    const auto& least_force = limit_on(scene.limits, LimitedFigure::contact_force);
    const auto& torque = limit_on(scene.limits, LimitedFigure::torque);
    const auto& pressure = limit_on(scene.limits, LimitedFigure::hertz_pressure);
    if (least_force) add_contact_force(rules, *least_force, force, speed, cam);
    if (torque) add_torque(rules, *torque, force, speed, cam);
    if (pressure)
        for (int side = 0; side < side_count(cam->cam); ++side)
            add_pressure_in_contact(rules, *pressure, force, speed, cam, side);
    const auto& of_contact = pressure ? pressure : torque;
    if (of_contact) add_contact(rules, scene, cam, of_contact->key);
}

}  // namespace camopt::cam_limit_parts
