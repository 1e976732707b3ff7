// SPDX-License-Identifier: MIT
// The same scene at another size, in other units, with other weights: the same answer.
#include "tests/soak/relations/change.hpp"
#include "tests/soak/relations/relation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace camopt::soak {

Finding compare_lift(Trial& trial) {
    const double factor = trial.draw().sized(0.01, 100.0);
    if (trial.numbers().swings && !trial.has_cam()) return no_case;
    SceneText scaled = trial.text();
    scale_lengths(scaled, factor);
    return same_answer(trial.base().outcome, trial.solve(scaled).outcome);
}

Finding compare_angle(Trial& trial) {
    const SceneNumbers& numbers = trial.numbers();
    if (trial.has_cam() || numbers.is_program() || numbers.speed > 0.0) return no_case;
    const double turn = 6.283185307179586;
    const double whole = numbers.rise * numbers.length();
    const double factor = trial.draw().between(0.1, 0.99 * turn / whole);
    SceneText scaled = trial.text();
    SceneTable& motion = scaled.at("motion");
    if (spelled(motion, "rise").empty()) motion.set("rise_deg", 180.0);
    scale_quantity(motion, "rise", factor);
    scale_quantity(motion, "return", factor);
    return same_answer(trial.base().outcome, trial.solve(scaled).outcome);
}

Finding compare_units(Trial& trial) {
    SceneText other = trial.text();
    const std::vector<std::string> lengths = {"_mm", "_in", "_m"};
    SceneTable& motion = other.at("motion");
    respell(motion, "lift",
            trial.numbers().swings ? trial.draw().one_of<std::string>({"_deg", "_rad"})
                                   : trial.draw().one_of(lengths));
    for (const char* angle : {"rise", "return"})
        respell(motion, angle, trial.draw().one_of<std::string>({"_deg", "_rad"}));
    respell(motion, "speed", trial.draw().one_of<std::string>({"_rpm", "_rad_s"}));
    if (trial.has_cam())
        for (const std::string& length : cam_lengths())
            respell(other.at("cam"), length, trial.draw().one_of(lengths));
    if (other.has("limits")) {
        SceneTable& limits = other.at("limits");
        for (const char* angle : {"pressure_angle", "rise_pressure_angle", "return_pressure_angle"})
            respell(limits, angle, trial.draw().one_of<std::string>({"_deg", "_rad"}));
        for (const char* radius : {"cam_radius_min", "concave_radius_min"})
            respell(limits, radius, trial.draw().one_of(lengths));
        respell(limits, "hertz_pressure_max", trial.draw().one_of<std::string>({"_mpa", "_gpa", "_pa"}));
    }
    if (other.text() == trial.text().text()) return no_case;
    return same_answer(trial.base().outcome, trial.solve(other).outcome);
}

Finding compare_weights(Trial& trial) {
    const double factor = trial.draw().sized(1e-3, 1e3);
    SceneText scaled = trial.text();
    for (auto& [key, value] : scaled.at("objective").members)
        if (key != "reference" && key != "tie_break")
            value = number_text(factor * std::strtod(value.c_str(), nullptr));
    return same_answer(trial.base().outcome, trial.solve(scaled).outcome, factor);
}

Finding compare_references(Trial& trial) {
    SceneText scaled = trial.text();
    SceneTable reference = numeric_reference(trial.numbers());
    SceneTable& objective = scaled.at("objective");
    for (auto& [term, value] : reference.members) {
        if (!objective.find(term)) continue;
        const double factor = trial.draw().sized(0.01, 100.0);
        value = number_text(factor * std::strtod(value.c_str(), nullptr));
        scale_quantity(objective, term, factor);
    }
    objective.set("reference", inline_text(reference));
    return same_answer(trial.base().outcome, trial.solve(scaled).outcome);
}

Finding compare_speed(Trial& trial) {
    if (trial.numbers().forces.empty()) return no_case;
    for (const auto& cap : trial.numbers().caps)
        if (cap && cap->in_time) return no_case;
    SceneText faster = trial.text();
    scale_quantity(faster.at("motion"), "speed", 2.0);
    SceneTable& forces = faster.at("forces");
    scale_quantity(forces, trial.numbers().swings ? "inertia" : "mass", 0.25);
    return same_answer(trial.base().outcome, trial.solve(faster).outcome);
}

}  // namespace camopt::soak
