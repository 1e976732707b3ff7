// SPDX-License-Identifier: MIT
// Larger sets of motions hold no worse optimum; smaller ones no better.
#include "tests/soak/relations/change.hpp"
#include "tests/soak/relations/relation.hpp"

#include <algorithm>
#include <functional>

namespace camopt::soak {

namespace {

/// The vector design fits every continuity; ordinates do not.
void free_design(SceneText& scene) {
    scene.at("spline").erase("design");
}

bool has_own_pressure(const SceneTable& limits) {
    return !spelled(limits, "rise_pressure_angle").empty() ||
           !spelled(limits, "return_pressure_angle").empty();
}

}  // namespace

Finding compare_refined(Trial& trial) {
    if (trial.numbers().free_knots || trial.numbers().spline_segments > 40) return no_case;
    SceneText finer = trial.text();
    SceneTable& spline = finer.at("spline");
    std::vector<double> breakpoints = trial.numbers().breakpoints;
    if (breakpoints.empty()) {
        spline.set("segments", std::to_string(2 * trial.numbers().spline_segments));
    } else {
        const int at = trial.draw().whole(0, static_cast<int>(breakpoints.size()) - 2);
        const auto left = breakpoints.begin() + at;
        breakpoints.insert(left + 1, (*left + *(left + 1)) / 2);
        spline.set("breakpoints", list_text(breakpoints));
    }
    const Solved solved = trial.solve(finer);
    return never_worse(solved.outcome, trial.base().outcome);
}

Finding compare_smoothness(Trial& trial) {
    const SceneNumbers& numbers = trial.numbers();
    if (numbers.free_knots) return no_case;
    SceneText rougher = trial.text();
    free_design(rougher);
    SceneTable& spline = rougher.at("spline");
    if (numbers.degree == 3) {
        spline.set("degree", "5");
        spline.set("continuity", "2");
    } else if (numbers.continuity > (numbers.degree == 7 ? 3 : 2)) {
        spline.set("continuity", std::to_string(numbers.continuity - 1));
    } else {
        return no_case;
    }
    const Solved solved = trial.solve(rougher);
    return never_worse(solved.outcome, trial.base().outcome);
}

Finding compare_freed(Trial& trial) {
    const SceneNumbers& numbers = trial.numbers();
    const bool small = numbers.breakpoints.size() <= 9 && numbers.spline_segments <= 8;
    if (numbers.free_knots || !small || trial.has_cam()) return no_case;
    SceneText freed = trial.text();
    freed.at("spline").set("knots", quoted("free"));
    freed.at("solver").set("starts", "1");
    return never_worse(trial.solve(freed).outcome, trial.base().outcome);
}

Finding compare_hurried(Trial& trial) {
    const SceneNumbers& numbers = trial.numbers();
    if (numbers.free_knots || !numbers.breakpoints.empty() || numbers.is_program()) return no_case;
    SceneText large = trial.text();
    large.at("spline").set("segments", std::to_string(trial.draw().whole(5, 12) * numbers.spline_segments));
    large.at("spline").erase("design");
    large.at("solver").set("max_seconds", trial.draw().sized(0.1, 0.6));
    return never_worse(trial.solve(large).outcome, trial.base().outcome);
}

Finding compare_dropped_condition(Trial& trial) {
    std::vector<SceneText> looser;
    const auto add = [&](const std::function<void(SceneText&)>& change) {
        looser.push_back(trial.text());
        change(looser.back());
    };
    if (trial.numbers().symmetric) add([](SceneText& scene) { scene.at("motion").erase("symmetric"); });
    if (!trial.numbers().via.empty()) add([](SceneText& scene) { scene.at("motion").erase("via"); });
    if (trial.numbers().end_jerk_zero) add([](SceneText& scene) { scene.at("spline").erase("end_jerk"); });
    if (trial.numbers().face_half_width)
        add([](SceneText& scene) {
            SceneTable& cam = scene.at("cam");
            cam.erase(spelled(cam, "face_half_width"));
        });
    if (const SceneTable* limits = trial.text().find("limits"))
        for (const auto& [key, value] : limits->members) {
            // Where rise or return have their own limit, it replaces the general one: it cannot be left out
            // alone.
            if (has_own_pressure(*limits) && key.find("pressure_angle") != std::string::npos) continue;
            add([limit = key](SceneText& scene) { scene.at("limits").erase(limit); });
        }
    if (looser.empty()) return no_case;
    const Solved solved = trial.solve(trial.draw().one_of(looser));
    return never_worse(solved.outcome, trial.base().outcome);
}

Finding compare_loosened(Trial& trial) {
    const std::vector<LooseEnd> limits = loose_ends(trial.text());
    if (limits.empty()) return no_case;
    SceneText looser = trial.text();
    loosen(looser, trial.draw().one_of(limits), trial.draw().sized(1.0001, 1.6));
    const Solved solved = trial.solve(looser);
    return never_worse(solved.outcome, trial.base().outcome);
}

Finding compare_tightened(Trial& trial) {
    const std::vector<LooseEnd> limits = loose_ends(trial.text());
    if (limits.empty()) return no_case;
    SceneText tighter = trial.text();
    loosen(tighter, trial.draw().one_of(limits), 1.0 / trial.draw().sized(1.0001, 1.3));
    const Solved solved = trial.solve(tighter);
    return never_worse(trial.base().outcome, solved.outcome);
}

Finding compare_dimension_ranges(Trial& trial) {
    SceneText changed = trial.text();
    std::vector<std::string> variable;
    for (const auto& [name, range] : trial.numbers().dimensions)
        // The middle of the centre distance measures the others: fixed elsewhere, it would change the
        // objective.
        if (range.is_variable() && name != "center_distance") variable.push_back(name);
    if (variable.empty() || !trial.base().motion) return no_case;
    const std::string name = trial.draw().one_of(variable);
    const Range range = trial.numbers().dimensions.at(name);
    SceneTable& cam = changed.at("cam");
    const std::string key = spelled(cam, name);
    if (trial.draw().chance(0.5)) {
        // Wider by a tenth to either side.
        const double more = 0.1 * std::min(range.high - range.low, std::abs(range.low));
        SceneTable wider;
        wider.set("min", (range.low - more) / unit_of(key));
        wider.set("max", (range.high + more) / unit_of(key));
        cam.set(key, inline_text(wider));
        return never_worse(trial.solve(changed).outcome, trial.base().outcome);
    }
    cam.set(key, trial.base().dimensions.at(name) / unit_of(key));
    return same_answer(trial.base().outcome, trial.solve(changed).outcome);
}

}  // namespace camopt::soak
