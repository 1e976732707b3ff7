// SPDX-License-Identifier: MIT
// Contact force, camshaft torque and Hertz pressure, and the contact that the last two assume.
#include "objectives/rules/cam_limits.hpp"
#include "scene/limit_table.hpp"

namespace camopt::cam_limit_parts {

namespace {

using enum MechanismQuantity;

// Torque and pressure assume contact with a regular cam. Unless a limit of the scene ensures it, its
// regularity (1 − r κ; flat: radius/base radius) and the height of its contact over the cam centre (in units
// of the cam) stay above this: manufacturable cams are far inside, and round-off cannot cross it.
constexpr double least_contact = 1e-6;
// For forces far below the largest the pressure is ill-conditioned.
constexpr double least_force_share = 1e-2;
// A pressure is proportional to the square root of the force: twice this relative excess of the force is one
// of the pressure.
constexpr double pressure_scale = 2.0;

/// F = m ω² s'' + c ω s' + k s + F_0 + load (or the moment of an arm) where the load is one line:
/// constant + slope θ.
struct Force {
    ForceSpec spec;
    double nominal;  ///< the speed of the scene
    LoadSpeed at;
    int load_speed = 0;                                     ///< its place in Scene::load_speeds()
    double constant = 0.0, slope = 0.0;                     ///< with a fixed preload
    int preload = -1, spring_rate = -1;                     ///< CamVariables::spring
    std::array<double, 2> between = {-infinity, infinity};  ///< x

    [[nodiscard]] auto operator()(const auto& call) const {
        auto force = spec.mass * at.square * call.acceleration() + spec.damping * at.speed * call.velocity() +
                     constant;
        if (spring_rate < 0)
            force = force + spec.spring_rate * call.displacement();
        else
            force = force + call.dimension(spring_rate) * call.displacement();
        if (preload >= 0) force = force + call.dimension(preload);
        if (slope != 0.0) force = force + slope * call.angle();
        return force;
    }
    /// The magnitude of the inertia force and the load.
    [[nodiscard]] double swing(const MotionScale& scale) const {
        double largest = 0.0;
        for (const std::array<double, 2>& point : spec.load) largest = std::max(largest, std::abs(point[1]));
        return largest + spec.mass * nominal * nominal * scale.lift / (scale.unit_angle * scale.unit_angle);
    }
    /// Only on this part of the motion; linear in it, but not the same everywhere. `station`: "upper flank".
    void place(CamFormula& formula, const std::string& station = {}) const {
        if (load_speed > 0) formula.fields.which["load_speed"] = load_speed;
        formula.of_loads = true;
        if (spring_rate >= 0) formula.linear = false;
        formula.between = between;
        formula.remark = station.empty() || at.words.empty() ? station + at.words : station + ", " + at.words;
        if (slope == 0.0) return;
        if (formula.linear) formula.shape = [](double, double) { return Curvature::linear; };
        formula.linear = false;
    }
};

/// One for each line of the load.
std::vector<Force> forces_of(const Limits& limits, const LoadSpeed& at_speed, int load_speed) {
    const Scene& scene = limits.scene();
    const ForceSpec& spec = *scene.forces;
    Force force{spec, *scene.motion.speed, at_speed, load_speed};
    force.preload = limits.variables().spring[0];
    force.spring_rate = limits.variables().spring[1];
    const double fixed = force.preload < 0 ? spec.preload : 0.0;
    force.constant = fixed + spec.load_at(0.0).force;
    if (spec.load.size() < 2) return {force};
    const double unit = scene.motion.unit_angle(), end = unit * scene.motion.length();
    std::vector<double> joints = {0.0, end};
    for (const std::array<double, 2>& point : spec.load) {
        double at = point[0] - units::turn * std::floor(point[0] / units::turn);
        while (at < end) {
            if (at > 0.0) joints.push_back(at);
            at += units::turn;
        }
    }
    std::ranges::sort(joints);
    std::vector<Force> all;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        if (!(joints[i + 1] > joints[i])) continue;
        const ForceSpec::Load line = spec.load_at(joints[i]);
        force.constant = fixed + line.force - line.slope * joints[i];
        force.slope = line.slope;
        force.between = {joints[i] / unit, joints[i + 1] / unit};
        all.push_back(force);
    }
    return all;
}

void add_contact_force(Limits& limits, const WrittenLimit& limit, const Force& force) {
    const double least = limit.value;
    const double unit =
        std::max({std::abs(least), force.spec.preload, force.swing(limits.variables().scale), least_scale});
    CamFormula formula =
        cam_formula(limit.key, [=](const auto& call) { return -1.0 / unit * (force(call) + -least); });
    formula.linear = true;
    force.place(formula);
    limits.add(std::move(formula));
}

/// Of a cam that drives both ways, to either side.
void add_largest_force(Limits& limits, const WrittenLimit& limit, const Force& force) {
    for (int side = 0; side < limits.cam().sides(); ++side) {
        CamFormula formula =
            cam_formula(limit.key, [=, sense = side == 0 ? 1.0 : -1.0, most = limit.value](const auto& call) {
                return sense / most * force(call) + -1.0;
            });
        formula.linear = true;
        force.place(formula, limits.cam().side_name(side));
        if (limits.cam().sides() > 1) formula.fields.which["side"] = side;
        limits.add(std::move(formula));
    }
}

void add_torque(Limits& limits, const WrittenLimit& limit, const Force& force) {
    for (const int sign : {1, -1}) {
        CamFormula formula = cam_formula(limit.key, [=, most = limit.value](const auto& call) {
            return sign / most * (force(call) * call.velocity()) + -1.0;
        });
        formula.fields.which["torque"] = sign;
        force.place(formula);
        limits.add(std::move(formula));
    }
}

void refuse_hertz_pressure(const Limits& limits, const WrittenLimit& limit, const ForceSpec& forces) {
    if (limits.cam().contact() == ContactKind::edge) {
        throw InputError(limit.key +
                         ": found a limit on the Hertz pressure of a knife edge; allowed: a roller "
                         "or a flat face");
    }
    if (!forces.contact_width) {
        throw InputError(limit.key + ": found no contact width; allowed: together with forces.contact_width");
    }
}

/// p² = F/(lever π b R c) <= p_max², c the compliance, as F <= R · lever · π b p_max² c: without a division,
/// so that no sign changes where the cam's radius or the lever passes through zero. There is no pressure
/// where F is not positive. 1/R = 1/ρ_cam + 1/r = 1/(r · regularity) for a roller. In a groove with a
/// clearance the contact surface is not the pitch curve's offset by the roller radius: F (1 − (R − r) κ) <= r
/// (1 − R κ) · lever · … of disk_cam.hpp.
void add_hertz_pressure(Limits& limits, const WrittenLimit& limit, const Force& force, int station) {
    const double carried =
        force.spec.compliance() * std::numbers::pi * *force.spec.contact_width * limit.value * limit.value;
    const double unit = std::max(
        {force.spec.preload, least_force_share * force.swing(limits.variables().scale), least_scale});
    const double factor = -carried / unit, wider = limits.wider_by(station);
    const int roller = limits.cam().roller_radius_at(station);
    const bool planar = limits.cam().radius_quantity().has_value();
    const double sense = limits.cam().pressing_sense(station);
    CamFormula formula = cam_formula(limit.key, [=](const auto& call) {
        const auto press = sense / unit * force(call);
        const auto lever = call.quantity(normal_lever, station);
        if (!planar) return press + factor * (call.quantity(contact_radius, station) * lever);
        if (roller < 0) return press + factor * (call.quantity(cam_radius, station) * lever);
        const auto radius = call.quantity(regularity, station) * call.dimension(roller);
        if (!(wider > 0.0)) return press + factor * (radius * lever);
        return press * (-wider * call.quantity(pitch_curvature, station) + 1.0) + factor * (radius * lever);
    });
    formula.linear = limits.is_linear(cam_radius);
    formula.scale = pressure_scale;
    force.place(formula, limits.cam().station_name(station));
    if (limits.cam().stations() > 1) formula.fields.which["station"] = station;
    limits.add(std::move(formula));
}

/// The contact lies above the cam's centre, so that the force along the normal lifts the follower.
void add_height(Limits& limits, const std::string& key, int station) {
    const double length = limits.length();
    CamFormula formula = cam_formula(key + " (contact below the cam's centre)", [=](const auto& call) {
        return -1.0 / length * call.quantity(pressure_denominator, station) + least_contact;
    });
    formula.fields = {.key = key, .part = "contact_height"};
    formula.highest_order = 0;
    formula.linear = limits.is_linear(pressure_denominator);
    limits.add_at(std::move(formula), station);
}

void add_contact(Limits& limits, const std::string& key) {
    const LimitSpec& written = limits.scene().limits;
    // A limit of 0 allows a cusp, on which the pressure is infinite.
    const auto& radius = limit_on(written, LimitedFigure::convex_radius);
    const auto& margin = limit_on(written, LimitedFigure::regularity);
    const bool regular = (radius && radius->value > 0.0) || (margin && margin->value >= least_contact);
    const PressureLimits pressure = pressure_limits(written);
    // |N| cos φm <= D sin φm to both sides implies a positive height.
    const bool held = pressure.rise && pressure.back;
    for (int station = 0; station < limits.cam().stations(); ++station) {
        if (!regular) add_regularity(limits, {least_contact, key}, station, "undercut");
        if (!held && limits.structure().binds(pressure_numerator, station)) add_height(limits, key, station);
    }
}

}  // namespace

void add_forces(Limits& limits) {
    const Scene& scene = limits.scene();
    if (!scene.forces || !scene.motion.speed) return;
    const auto& torque = limit_on(scene.limits, LimitedFigure::torque);
    const auto& pressure = limit_on(scene.limits, LimitedFigure::hertz_pressure);
    if (pressure) refuse_hertz_pressure(limits, *pressure, *scene.forces);
    std::vector<Force> forces;
    int place = 0;
    for (const LoadSpeed& speed : scene.load_speeds()) {
        for (Force& force : forces_of(limits, speed, place)) forces.push_back(std::move(force));
        ++place;
    }
    for (const Force& force : forces) {
        if (const auto& least = limit_on(scene.limits, LimitedFigure::contact_force))
            add_contact_force(limits, *least, force);
        if (const auto& most = limit_on(scene.limits, LimitedFigure::contact_force_most))
            add_largest_force(limits, *most, force);
        if (torque) add_torque(limits, *torque, force);
        for (int station = 0; pressure && station < limits.cam().stations(); ++station)
            add_hertz_pressure(limits, *pressure, force, station);
    }
    const auto& of_contact = pressure ? pressure : torque;
    if (of_contact) add_contact(limits, of_contact->key);
}

}  // namespace camopt::cam_limit_parts
