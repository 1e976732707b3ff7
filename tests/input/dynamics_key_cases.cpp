// SPDX-License-Identifier: MIT
#include "tests/input/scene_key_cases.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace camopt::input {
namespace dynamics_key_cases {

constexpr double rpm = std::numbers::pi / 30.0;

/// A scene with an elastic follower, without one of its quantities; `angle`: it swings.
std::string train(bool angle, const std::string& except = "") {
    std::string toml = std::string(angle ? "motion.lift_rad = 0.5\n" : "motion.lift_mm = 20\n") +
                       "motion.rise_rad = 2\nmotion.speed_rad_s = 10\n";
    const auto add = [&](const std::string& quantity, const std::string& line) {
        if (quantity != except) toml += "dynamics." + line + "\n";
    };
    add("mass", angle ? "inertia_kg_m2 = 4" : "mass_kg = 4");
    add("stiffness", angle ? "stiffness_n_m_rad = 100" : "stiffness_n_m = 100");
    return toml;
}

const DynamicsSpec& spec_of(const Scene& scene) {
    return scene.dynamics.value();
}

}  // namespace dynamics_key_cases

std::vector<KeyCase> dynamics_cases() {
    using namespace dynamics_key_cases;
    const auto mass = [](const Scene& s) { return spec_of(s).mass; };
    const auto frequency = [](const Scene& s) { return spec_of(s).natural_frequency.value(); };
    const auto stiffness = [](const Scene& s) { return spec_of(s).stiffness.value(); };
    const auto ratio = [](const Scene& s) { return spec_of(s).damping_ratio.value(); };
    const auto damping = [](const Scene& s) { return spec_of(s).damping.value(); };
    const auto spring = [](const Scene& s) { return spec_of(s).return_stiffness; };
    const auto preload = [](const Scene& s) { return spec_of(s).preload; };
    const auto fastest = [](const Scene& s) { return spec_of(s).speed_range.value()[1]; };
    const auto stage = [](double TrainStage::*member) {
        return [member](const Scene& s) { return spec_of(s).stages.at(0).*member; };
    };
    const auto limit = [](std::optional<WrittenLimit> LimitSpec::*member) {
        return [member](const Scene& s) { return (s.limits.*member).value().value; };
    };
    const auto residual = limit(&LimitSpec::residual), force = limit(&LimitSpec::dynamic_contact_force_min);
    const std::string length = train(false), angle = train(true);
    const std::string pressed = length + "dynamics.preload_n = 9\n",
                      turned = angle + "dynamics.preload_nm = 9\n";
    return {
        {"dynamics.mass_kg", "2.5", 2.5, mass, train(false, "mass")},
        {"dynamics.mass_lb", "2", 0.90718474, mass, train(false, "mass")},
        {"dynamics.stiffness_lbf_in", "1", 175.12683524647636, stiffness, train(false, "stiffness")},
        {"dynamics.return_spring_lbf_in", "1", 175.12683524647636, spring, length},
        {"dynamics.preload_lbf", "1", 4.4482216152605, preload, length},
        {"dynamics.preload_lbf_in", "1", 0.1129848290276167, preload, angle},
        {"dynamics.stage.mass_lb", "2", 0.90718474, stage(&TrainStage::mass), length},
        {"dynamics.stage.stiffness_lbf_in", "1", 175.12683524647636, stage(&TrainStage::stiffness), length},
        {"limits.dynamic_contact_force_min_lbf", "1", 4.4482216152605, force, pressed},
        {"limits.dynamic_contact_force_min_lbf_in", "1", 0.1129848290276167, force, turned},
        {"dynamics.inertia_kg_m2", "0.25", 0.25, mass, train(true, "mass")},
        {"dynamics.natural_frequency_hz", "50", 100.0 * std::numbers::pi, frequency,
         train(false, "stiffness")},
        {"dynamics.natural_frequency_rad_s", "300", 300, frequency, train(false, "stiffness")},
        {"dynamics.stiffness_n_mm", "8", 8000, stiffness, train(false, "stiffness")},
        {"dynamics.stiffness_n_m", "8", 8, stiffness, train(false, "stiffness")},
        {"dynamics.stiffness_n_m_rad", "8", 8, stiffness, train(true, "stiffness")},
        {"dynamics.stiffness_nm_rad", "8", 8, stiffness, train(true, "stiffness")},
        {"dynamics.damping_ratio", "0.02", 0.02, ratio, length},
        {"dynamics.damping_n_s_m", "7", 7, damping, length},
        {"dynamics.damping_nm_s_rad", "7", 7, damping, angle},
        {"dynamics.return_spring_n_mm", "8", 8000, spring, length},
        {"dynamics.return_spring_n_m", "8", 8, spring, length},
        {"dynamics.return_spring_n_m_rad", "8", 8, spring, angle},
        {"dynamics.return_spring_nm_rad", "8", 8, spring, angle},
        {"dynamics.preload_n", "150", 150, preload, length},
        {"dynamics.preload_nm", "15", 15, preload, angle},
        {"dynamics.speed_range_rpm", "[60, 120]", 120 * rpm, fastest, length},
        {"dynamics.speed_range_rad_s", "[8, 12]", 12, fastest, length},
        {"dynamics.stage", "[{ mass_kg = 1, stiffness_n_mm = 2 }]", 1, stage(&TrainStage::mass), length},
        {"dynamics.stage.mass_kg", "2.5", 2.5, stage(&TrainStage::mass), length},
        {"dynamics.stage.inertia_kg_m2", "0.25", 0.25, stage(&TrainStage::mass), angle},
        {"dynamics.stage.stiffness_n_mm", "8", 8000, stage(&TrainStage::stiffness), length},
        {"dynamics.stage.stiffness_n_m", "8", 8, stage(&TrainStage::stiffness), length},
        {"dynamics.stage.stiffness_n_m_rad", "8", 8, stage(&TrainStage::stiffness), angle},
        {"dynamics.stage.stiffness_nm_rad", "8", 8, stage(&TrainStage::stiffness), angle},
        // 2 ζ √(k m), of 1 kg on 4 N/m
        {"dynamics.stage.damping_ratio", "0.25", 1.0, stage(&TrainStage::damping), length},
        {"objective.residual", "0.2", 0.2, [](const Scene& s) { return s.objective.residual; }, length},
        {"objective.dynamic_acceleration", "0.3", 0.3,
         [](const Scene& s) { return s.objective.dynamic_acceleration; }, length},
        {"objective.reference.residual", "0.4", 0.4,
         [](const Scene& s) { return s.objective.reference.residual.value(); }, length},
        {"objective.reference.dynamic_acceleration", "6", 6,
         [](const Scene& s) { return s.objective.reference.dynamic_acceleration.value(); }, length},
        {"limits.residual_um", "20", 2e-5, residual, length},
        {"limits.residual_mm", "0.02", 2e-5, residual, length},
        {"limits.residual_in", "0.001", 2.54e-5, residual, length},
        {"limits.residual_deg", "0.9", 0.9 * std::numbers::pi / 180.0, residual, angle},
        {"limits.residual_rad", "0.01", 0.01, residual, angle},
        {"limits.dynamic_contact_force_min_n", "5", 5, force, pressed},
        {"limits.dynamic_contact_force_min_nm", "5", 5, force, turned},
    };
}

}  // namespace camopt::input
