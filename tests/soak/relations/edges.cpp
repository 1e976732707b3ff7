// SPDX-License-Identifier: MIT
// Caps about the edge of the possible, and the relaxations that infeasible scenes are offered.
#include "tests/soak/relations/change.hpp"
#include "tests/soak/relations/relation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

bool delivers(const Outcome& outcome) {
    return outcome.has_motion() && outcome.verdict != "failed" && outcome.verdict != "infeasible";
}

/// One end of a range: "cam.base_radius_mm" with "min" or "max".
bool set_end(SceneText& scene, const std::string& path, const std::pair<std::string, std::string>& end) {
    const auto dot = path.rfind('.');
    if (dot == std::string::npos) return false;
    SceneTable& table = scene.at(path.substr(0, dot));
    const std::string key = path.substr(dot + 1);
    const auto written = table.find(key);
    if (!written || !written->starts_with('{')) return false;
    SceneTable range = inline_table(*written);
    range.set(end.first, end.second);
    table.set(key, inline_text(range));
    return true;
}

/// Sets "table.quantity_unit" in place of every spelling of the quantity. False: not a plain place of a
/// scene.
bool set_path(SceneText& scene, const std::string& path, const std::string& value) {
    const auto dot = path.rfind('.');
    if (dot == std::string::npos || path.find('[') != std::string::npos) return false;
    const std::string key = path.substr(dot + 1);
    if (key == "min" || key == "max") return set_end(scene, path.substr(0, dot), {key, value});
    SceneTable& table = scene.at(path.substr(0, dot));
    std::string quantity = key;
    if (unit_of(key) != 1.0 || !table.find(key)) {
        // The longest beginning that the table spells.
        for (auto end = key.rfind('_'); end != std::string::npos && end > 0; end = key.rfind('_', end - 1)) {
            quantity = key.substr(0, end);
            if (!spelled(table, quantity).empty()) break;
        }
    }
    if (const std::string old = spelled(table, quantity); !old.empty()) table.erase(old);
    table.set(key, value);
    return true;
}

/// Every interval cut into two, four …, as a row of breakpoints says.
void cut_intervals(SceneText& scene, std::vector<double> breakpoints, std::size_t segments) {
    while (breakpoints.size() <= segments) {
        std::vector<double> halved = {breakpoints.front()};
        for (std::size_t k = 1; k < breakpoints.size(); ++k) {
            halved.push_back(0.5 * (breakpoints[k - 1] + breakpoints[k]));
            halved.push_back(breakpoints[k]);
        }
        breakpoints = std::move(halved);
    }
    scene.at("spline").set("breakpoints", list_text(breakpoints));
}

/// The value of a relaxation with a margin towards `given` (< 0) or away from it (> 0).
double moved(const PublishedRelaxation& row, double margin) {
    const double way = *row.needed >= row.given ? 1.0 : -1.0;
    return *row.needed + way * margin;
}

}  // namespace

Finding compare_own_figures_as_caps(Trial& trial) {
    const Solved& base = trial.base();
    if (!base.motion || !base.outcome.is_proved()) return no_case;
    SceneText capped = trial.text();
    SceneTable& limits = capped.at("limits");
    // As they are, or by rounding or by a part in a million above.
    const double factor = 1.0 + trial.draw().one_of<double>({0.0, 0.0, 1e-10, 1e-6});
    bool any = false;
    for (std::size_t order = 1; order <= 3; ++order) {
        if (trial.numbers().caps[order] || trial.draw().chance(0.5)) continue;
        const double peak = base.outcome.peaks.at(peak_names[order]);
        if (!(peak > 0.0)) continue;  // a standstill: no cap may be 0
        limits.set(peak_names[order], peak * factor);
        any = true;
    }
    if (!any) return no_case;
    return same_answer(base.outcome, trial.solve(capped).outcome);
}

Finding compare_least_caps(Trial& trial) {
    if (trial.has_cam() || trial.base().outcome.verdict == "infeasible") return no_case;
    const auto order = static_cast<std::size_t>(trial.draw().whole(1, 3));
    if (trial.numbers().caps[order]) return no_case;
    SceneText alone = trial.text();
    alone.erase("objective");
    SceneTable& objective = alone.at("objective");
    objective.set(peak_names[order], 1.0);
    SceneTable reference;
    reference.set(peak_names[order], 1.0);
    objective.set("reference", inline_text(reference));
    const Solved least = trial.solve(alone);
    if (!least.outcome.is_proved() || !least.outcome.objective) return no_case;
    if (!(*least.outcome.objective > 0.0)) return no_case;  // a standstill: no cap may be 0
    const double beside = trial.draw().one_of<double>({0.0, 1e-10, -1e-10, 1e-6, 1e-4, -1e-4});
    SceneText capped = trial.text();
    capped.at("limits").set(peak_names[order], *least.outcome.objective * (1.0 + beside));
    const Solved solved = trial.solve(capped);
    const std::string& verdict = solved.outcome.verdict;
    if (!solved.outcome.refusal.empty() || ended_early(solved.outcome)) return no_case;
    if (beside <= -1e-5 && delivers(solved.outcome))
        return fmt::format("{} cap {:.1g} below the least possible: {}", peak_names[order], -beside, verdict);
    if (beside >= 1e-7 && !delivers(solved.outcome))
        return fmt::format("{} cap {:.1g} above the least possible: {} ({})", peak_names[order], beside,
                           verdict, solved.outcome.reason);
    return holds;
}

Finding compare_relaxed(Trial& trial) {
    if (trial.base().outcome.verdict != "infeasible") return no_case;
    std::vector<PublishedRelaxation> rows;
    for (const PublishedRelaxation& row : trial.base().outcome.relaxation)
        if (row.needed && *row.needed != row.given) rows.push_back(row);
    if (rows.empty()) return no_case;
    const PublishedRelaxation row = trial.draw().one_of(rows);
    const bool cut = row.key == "spline.breakpoints";
    const bool whole = cut || row.key == "spline.segments";
    const double size = std::abs(*row.needed);
    const auto solve_at = [&](double margin) -> std::optional<Solved> {
        SceneText changed = trial.text();
        const double value = moved(row, margin);
        if (cut)
            cut_intervals(changed, trial.numbers().breakpoints, static_cast<std::size_t>(std::lround(value)));
        else if (!set_path(changed, row.key, whole ? std::to_string(std::lround(value)) : number_text(value)))
            return std::nullopt;
        const double part = (value - row.given) / (row.solved - row.given);  // what changes with it is linear
        for (const auto& [key, given, solved] : row.also)
            if (!set_path(changed, key, number_text(given + part * (solved - given)))) return std::nullopt;
        return trial.solve(changed);
    };
    const auto with = solve_at(whole ? 0.0 : 1e-6 * size);
    if (!with || ended_early(with->outcome)) return no_case;
    if (!delivers(with->outcome))
        return fmt::format("{} = {:.12g} and a margin of 1e-6: {} ({})", row.key, *row.needed,
                           with->outcome.verdict, with->outcome.reason);
    // A search that the time ended tells a value that does, but may not be the nearest.
    if (whole || !trial.base().outcome.unsettled.empty()) return holds;
    const auto less = solve_at(-std::max(1e-3 * std::abs(*row.needed - row.given), 1e-5 * size));
    if (less && delivers(less->outcome))
        return fmt::format("{} = {:.12g} is needed, but with less there is a motion: {}", row.key,
                           *row.needed, less->outcome.verdict);
    return holds;
}

}  // namespace camopt::soak
