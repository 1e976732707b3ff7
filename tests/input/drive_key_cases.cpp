// SPDX-License-Identifier: MIT
// [drive] and what needs it: every key in every unit.
#include "tests/input/scene_key_cases.hpp"

#include <numbers>

namespace camopt::input {
namespace drive_key_cases {

/// A scene with a motor, without one of its quantities; `angle`: the output swings.
std::string motor(bool angle, const std::string& except = "") {
    std::string toml = std::string(angle ? "motion.lift_rad = 0.5\n" : "motion.lift_mm = 20\n") +
                       "motion.speed_rad_s = 10\ndrive.motor_inertia_kg_m2 = 1e-4\n";
    if (except != "transmission")
        toml += angle ? "drive.transmission_deg_per_rev = 36\n" : "drive.transmission_mm_per_rev = 60\n";
    return toml;
}

}  // namespace drive_key_cases

std::vector<KeyCase> drive_cases() {
    using namespace drive_key_cases;
    constexpr double turn = 2.0 * std::numbers::pi, degree = std::numbers::pi / 180.0;
    const auto of = [](double DriveSpec::*member) {
        return [member](const Scene& s) { return s.drive.value().*member; };
    };
    const auto limit = [](std::optional<WrittenLimit> LimitSpec::*member) {
        return [member](const Scene& s) { return (s.limits.*member).value().value; };
    };
    const auto load = of(&DriveSpec::load), travel = of(&DriveSpec::transmission),
               force = of(&DriveSpec::force), friction = of(&DriveSpec::friction),
               viscous = of(&DriveSpec::viscous);
    const auto cycle = [](const Scene& s) { return s.drive.value().cycle.value(); };
    const std::string length = motor(false), angle = motor(true), bare = motor(false, "transmission"),
                      bare_angle = motor(true, "transmission"), monotone = "motion.monotone = true\n";
    const std::string rest =
        "drive.transmission_mm_per_rev = 60\nmotion.lift_mm = 20\nmotion.speed_rad_s = 10\n";
    return {
        {"drive.load_mass_kg", "8", 8, load, length},
        {"drive.load_mass_lb", "2", 0.90718474, load, length},
        {"drive.load_inertia_kg_m2", "0.25", 0.25, load, angle},
        {"drive.motor_inertia_kg_m2", "4e-4", 4e-4, of(&DriveSpec::motor_inertia), rest},
        {"drive.transmission_mm_per_rev", "60", 0.06 / turn, travel, bare},
        {"drive.transmission_in_per_rev", "2", 0.0508 / turn, travel, bare},
        {"drive.transmission_m_per_rev", "0.1", 0.1 / turn, travel, bare},
        {"drive.transmission_deg_per_rev", "36", 0.1, travel, bare_angle},
        {"drive.transmission_rad_per_rev", "0.5", 0.5 / turn, travel, bare_angle},
        {"drive.viscous_n_s_m", "40", 40, viscous, length},
        {"drive.viscous_nm_s_rad", "4", 4, viscous, angle},
        {"drive.force_n", "-30", -30, force, length},
        {"drive.force_lbf", "1", 4.4482216152605, force, length},
        {"drive.moment_nm", "3", 3, force, angle},
        {"drive.moment_lbf_in", "1", 0.1129848290276167, force, angle},
        {"drive.friction_n", "5", 5, friction, length + monotone},
        {"drive.friction_lbf", "1", 4.4482216152605, friction, length + monotone},
        {"drive.friction_nm", "5", 5, friction, angle + monotone},
        {"drive.friction_lbf_in", "1", 0.1129848290276167, friction, angle + monotone},
        {"drive.cycle_deg", "270", 270 * degree, cycle, length},
        {"drive.cycle_rad", "6", 6, cycle, length},
        {"drive.cycle_crank_deg", "720", turn, cycle, length},
        {"objective.motor_torque", "0.2", 0.2, [](const Scene& s) { return s.objective.motor_torque; },
         length},
        {"objective.motor_torque_rms", "0.3", 0.3,
         [](const Scene& s) { return s.objective.motor_torque_rms; }, length},
        {"objective.reference.motor_torque", "4", 4,
         [](const Scene& s) { return s.objective.reference.motor_torque.value(); }, length},
        {"objective.reference.motor_torque_rms", "2", 2,
         [](const Scene& s) { return s.objective.reference.motor_torque_rms.value(); }, length},
        {"limits.motor_torque_nm", "4", 4, limit(&LimitSpec::motor_torque), length},
        {"limits.motor_torque_nm", "{ min = -3, max = 4 }", -3, limit(&LimitSpec::motor_torque_min), length},
        {"limits.motor_torque_lbf_in", "{ max = 10 }", 1.129848290276167, limit(&LimitSpec::motor_torque_max),
         length},
        {"limits.motor_torque_rms_nm", "2", 2, limit(&LimitSpec::motor_torque_rms), length},
        {"limits.motor_torque_rms_lbf_in", "10", 1.129848290276167, limit(&LimitSpec::motor_torque_rms),
         length},
        {"limits.motor_speed_rpm", "3000", 100 * std::numbers::pi, limit(&LimitSpec::motor_speed), length},
        {"limits.motor_speed_rad_s", "300", 300, limit(&LimitSpec::motor_speed), length},
        {"limits.motor_curve", "[[0, 4.2], [3000, 2]]", 100 * std::numbers::pi,
         [](const Scene& s) { return s.limits.motor_curve.at(1)[0]; }, length},
    };
}

}  // namespace camopt::input
