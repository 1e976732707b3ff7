// SPDX-License-Identifier: MIT
// The rows of [forces], [dynamics] and [drive].
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;
using key_place::each;

const Range poisson_ratio = {.low = 0.0, .high = 0.5, .high_included = false};
const Range damping_ratios = Range::between(0.0, 2.0);

/// A number, or pairs of an angle and a number.
KeyPlace load_place() {
    const KeyPlace pairs = stored_in(&Scene::forces, &ForceSpec::load);
    KeyPlace place = pairs;
    place.first_unit = units::degree;
    place.assign = [pairs](Scene& scene, const KeyValue& value, const KeyAt& at) {
        const auto* const load = std::get_if<double>(&value);
        pairs.assign(scene, load != nullptr ? KeyPairs{{0.0, *load}} : value, at);
    };
    place.value = [](const Scene& scene, const KeyAt&) -> std::optional<KeyValue> {
        if (!scene.forces || scene.forces->load.empty()) return std::nullopt;
        const KeyPairs& load = scene.forces->load;
        return load.size() == 1 && load[0][0] == 0.0 ? KeyValue(load[0][1]) : KeyValue(load);
    };
    return place;
}

template <class Member>
KeyPlace of_stage(Member member) {
    return stored_in(&Scene::dynamics, &DynamicsSpec::stages, each, member);
}

/// A number, or the range that it is chosen from.
template <class Part>
KeyPlace chosen_place(std::optional<Part> Scene::*part, double Part::*number,
                      std::optional<std::array<double, 2>> Part::*range) {
    const KeyPlace one = stored_in(part, number);
    KeyPlace place = one;
    place.assign = [=](Scene& scene, const KeyValue& value, const KeyAt& at) {
        const auto* const both = std::get_if<KeyBounds>(&value);
        one.assign(scene, both != nullptr ? KeyValue(0.5 * (*both->least + *both->most)) : value, at);
        auto& own = (scene.*part).value().*range;
        own.reset();
        if (both != nullptr) own = {*both->least, *both->most};
    };
    place.value = [=](const Scene& scene, const KeyAt& at) -> std::optional<KeyValue> {
        if (!(scene.*part) || !((*(scene.*part)).*range)) return one.value(scene, at);
        const std::array<double, 2>& both = *((*(scene.*part)).*range);
        return KeyBounds{both[0], both[1]};
    };
    return place;
}

/// c = 2 ζ √(k m).
KeyPlace stage_damping_place() {
    KeyPlace place = of_stage(&TrainStage::damping);
    place.stored = [](const Scene& scene, const KeyAt& at, double ratio) {
        const TrainStage& stage = scene.dynamics.value().stages.at(at.entry[0]);
        return 2.0 * ratio * std::sqrt(stage.stiffness * stage.mass);
    };
    return place;
}

// A row is read as a row.
// clang-format off
Rows forces() {
    return {
        {"forces", "mass", number, mass, not_negative, {}, "0",
         "Mass that the cam accelerates; translating followers.", stored_in(&Scene::forces, &ForceSpec::mass)},
        {"forces", "inertia", number, inertia, not_negative, {}, "0",
         "Moment of inertia about the pivot; oscillating followers.",
         stored_in(&Scene::forces, &ForceSpec::mass), Availability::now, "mass"},
        {"forces", "spring_rate", number_or_range, spring_rate, not_negative, {}, "0",
         "Rate of the return spring: per length for translating, per angle for oscillating followers. A range: the optimizer "
         "chooses it for the limits on loads.",
         chosen_place(&Scene::forces, &ForceSpec::spring_rate, &ForceSpec::spring_rate_range)},
        {"forces", "preload", number_or_range, force_or_moment, any, {}, "0",
         "Force (translating) or moment (oscillating) that presses the follower against the cam at displacement 0, "
         "at rest: spring, weight, load. A range: the optimizer chooses it.",
         chosen_place(&Scene::forces, &ForceSpec::preload, &ForceSpec::preload_range)},
        {"forces", "damping", number, damper, not_negative, {}, "0",
         "Viscous damping of the follower: force by its velocity, moment by its angular velocity.",
         stored_in(&Scene::forces, &ForceSpec::damping)},
        {"forces", "load", number_or_points, force_or_moment, any, {}, "0",
         "A further force (translating) or moment (oscillating), positive where it presses the follower "
         "on the cam: a number, or pairs of a cam angle in deg from the start of the motion and the force there, "
         "linear between them; after the last one it goes on to the first of the next revolution.", load_place()},
        {"forces", "spring_frequency", number, frequency, positive, {}, "none",
         "Natural frequency of the return spring between fixed ends (surge): harmonics of the lift near it are "
         "reported, and may be limited. For an RR motion or a closed program.",
         stored_in(&Scene::forces, &ForceSpec::spring_frequency)},
        {"forces", "speed_range", numbers, speed, not_negative, {}, "motion.speed, or from 0",
         "Two speeds of the cam: limits of contact force, Hertz pressure and torque hold from the first to the second. "
         "Default: from 0 to the speed where a spring loads the cam and `limits.hertz_pressure_max` is given, else the speed.",
         stored_in(&Scene::forces, &ForceSpec::speed_range)},
        {"forces", "contact_width", number, length, positive, {}, "none",
         "Width of the line of contact; the Hertz pressure needs it.", stored_in(&Scene::forces, &ForceSpec::contact_width)},
        called("Young's modulus of the cam", {"forces", "cam_modulus", number, modulus, positive, {}, "210 GPa", "Young's modulus of the cam.",
         stored_in(&Scene::forces, &ForceSpec::cam_modulus)}),
        called("Young's modulus of the follower", {"forces", "follower_modulus", number, modulus, positive, {}, "210 GPa",
         "Young's modulus of the roller or the face.", stored_in(&Scene::forces, &ForceSpec::follower_modulus)}),
        called("Poisson's ratio of the cam", {"forces", "cam_poisson", number, plain, poisson_ratio, {}, "0.3", "Poisson's ratio of the cam.",
         stored_in(&Scene::forces, &ForceSpec::cam_poisson)}),
        called("Poisson's ratio of the follower", {"forces", "follower_poisson", number, plain, poisson_ratio, {}, "0.3",
         "Poisson's ratio of the roller or the face.", stored_in(&Scene::forces, &ForceSpec::follower_poisson)}),
    };
}

Rows dynamics() {
    return {
        {"dynamics", "mass", number, mass, positive, {}, "needed", "Moved at the output; of a lift that is a length.",
         stored_in(&Scene::dynamics, &DynamicsSpec::mass)},
        {"dynamics", "inertia", number, inertia, positive, {}, "needed",
         "The same where the lift is an angle.",
         stored_in(&Scene::dynamics, &DynamicsSpec::mass), Availability::now, "mass"},
        {"dynamics", "natural_frequency", number, frequency, positive, {}, "or a stiffness",
         "Of the output on its spring, with the cam (or the stage before it) held and the return spring on; undamped.",
         stored_in(&Scene::dynamics, &DynamicsSpec::natural_frequency)},
        {"dynamics", "stiffness", number, train_spring, positive, {}, "or a natural frequency",
         "Of the spring between the output and the mass or cam before it.",
         stored_in(&Scene::dynamics, &DynamicsSpec::stiffness), Availability::now, "natural_frequency"},
        {"dynamics", "damping_ratio", number, plain, damping_ratios, {}, "0",
         "Damping of the output in parts of critical.", stored_in(&Scene::dynamics, &DynamicsSpec::damping_ratio)},
        {"dynamics", "damping", number, damper, not_negative, {}, "0", "The same as a damper.",
         stored_in(&Scene::dynamics, &DynamicsSpec::damping),
         Availability::now, "damping_ratio"},
        {"dynamics", "return_spring", number, train_spring, not_negative, {}, "0",
         "Rate of the spring that presses the output back to the cam.",
         stored_in(&Scene::dynamics, &DynamicsSpec::return_stiffness)},
        {"dynamics", "preload", number, force_or_moment, not_negative, {}, "0",
         "What the return spring loads the cam with at displacement 0. Without spring and preload the cam guides the follower in both directions.",
         stored_in(&Scene::dynamics, &DynamicsSpec::preload)},
        {"dynamics", "ground_damping", number, damper, not_negative, {}, "0", "Of a damper between the output and ground.",
         stored_in(&Scene::dynamics, &DynamicsSpec::ground_damping)},
        {"dynamics", "prescribe", text, plain, any, {"cam", "output"}, "\"cam\"",
         "Whose motion the spline is. `\"output\"`: the output moves as the spline says, and the cam gives what the elastic train "
         "needs for it at `motion.speed` (polydyne, splinedyne); one mass, degree 5 or 7.",
         stored_in(&Scene::dynamics, &DynamicsSpec::prescribe)},
        {"dynamics", "speed_range", numbers, speed, positive, {}, "motion.speed",
         "Two speeds: terms and limits of the train hold from the first to the second.",
         stored_in(&Scene::dynamics, &DynamicsSpec::speed_range)},
        {"dynamics", "stage", tables, plain, any, {}, "none",
         "Masses between cam and output, at most three, from the cam on.", stored_in(&Scene::dynamics, &DynamicsSpec::stages)},
        {"dynamics.stage", "mass", number, mass, positive, {}, "needed", "Of this mass.", of_stage(&TrainStage::mass)},
        {"dynamics.stage", "inertia", number, inertia, positive, {}, "needed",
         "The same where the lift is an angle.", of_stage(&TrainStage::mass), Availability::now, "mass"},
        {"dynamics.stage", "stiffness", number, train_spring, positive, {}, "required",
         "Of the spring to the mass or cam before it.", of_stage(&TrainStage::stiffness)},
        {"dynamics.stage", "damping_ratio", number, plain, damping_ratios, {}, "0",
         "c / (2 sqrt(k m)) of this mass on this spring.", stage_damping_place()},
    };
}

Rows drive() {
    Rows rows = {
        {"drive", "load_mass", number, mass, not_negative, {}, "0",
         "Moved with the output; of a lift that is a length.", stored_in(&Scene::drive, &DriveSpec::load)},
        {"drive", "load_inertia", number, inertia, not_negative, {}, "0",
         "The same where the lift is an angle.", stored_in(&Scene::drive, &DriveSpec::load), Availability::now, "load_mass"},
        {"drive", "motor_inertia", number, inertia, not_negative, {}, "0",
         "Of motor, brake and gear, at the motor.", stored_in(&Scene::drive, &DriveSpec::motor_inertia)},
        {"drive", "transmission", number_or_range, travel_per_turn, positive, {}, "required",
         "Travel of the output a revolution of the motor. A range: the best transmission is searched.",
         chosen_place(&Scene::drive, &DriveSpec::transmission, &DriveSpec::transmission_range)},
        {"drive", "viscous", number, damper, not_negative, {}, "0",
         "Viscous friction of the output: force by its velocity, moment by its angular velocity.",
         stored_in(&Scene::drive, &DriveSpec::viscous)},
        {"drive", "force", number, force, any, {}, "0", "Constant force on the output, against positive motion.",
         stored_in(&Scene::drive, &DriveSpec::force)},
        {"drive", "moment", number, moment, any, {}, "0", "The same where the lift is an angle.",
         stored_in(&Scene::drive, &DriveSpec::force),
         Availability::now, "force"},
        {"drive", "friction", number, force_or_moment, not_negative, {}, "0",
         "Dry friction, against the motion in either direction, 0 at rest. The direction must be known: "
         "`motion.monotone`, and every displacement given.", stored_in(&Scene::drive, &DriveSpec::friction)},
        {"drive", "cycle", number, cam_angle, positive, {}, "360 deg",
         "Cam angle of the cycle that the root mean square is taken over; outside the motion the axis rests.",
         stored_in(&Scene::drive, &DriveSpec::cycle)},
    };
    for (KeyRow& row : rows)
        if (row.type == number)
            row.no_range = "of a drive only the transmission is searched: everything else belongs to the motor and the machine; "
                           "compare values by camopt sweep --vary";
    return rows;
}
// clang-format on

}  // namespace

Rows of_loads() {
    return joined(forces(), dynamics(), drive());
}

}  // namespace camopt::key_rows
