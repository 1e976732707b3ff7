// SPDX-License-Identifier: MIT
#include "studies/explain/explain.hpp"

#include "objectives/motion_bounds.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/smallest_of_any_motion.hpp"
#include "studies/explain/solved_changes.hpp"
#include "studies/least/feasible_edge.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Parts of the time that is left: for set points, for more segments, for naming what is impossible without
// the others; for one change equal shares of what is left, but never less than least_share, and more until
// something useful is found. Of these a part for the search, the rest for the solve of what it found.
constexpr double part_of_set_points = 0.5, part_of_segments = 0.25, part_of_conflict = 0.3;
constexpr double shares_of_one = 2.0, least_share = 0.3, first_share = 0.6, part_of_search = 0.6;
// A spline of so many segments is rarely too coarse, and takes long to refine: that comes last.
constexpr int many_segments = 48;
constexpr int most_set_points = 2, most_quick_segments = 16;

/// The scene with these of its limits alone.
Scene only_limits(const Scene& scene, const std::vector<std::string>& keys) {
    const auto stays = [&](const std::string& key) { return std::ranges::find(keys, key) != keys.end(); };
    Scene only = scene;
    LimitSpec& limits = only.limits;
    const auto drop = [&](auto& limit) {
        if (limit && !stays(limit->key)) limit.reset();
    };
    for (const PeakLimitRow& row : peak_limit_rows()) drop(row.in(limits));
    for (const LimitRow& row : limit_rows()) drop(row.in(limits));
    if (!stays("limits.motor_curve")) limits.motor_curve.clear();
    std::erase_if(only.own_limits, [&](const OwnLimit& limit) { return !stays(limit.key()); });
    const auto of_face = [&](const std::string& key) {
        return key.starts_with(std::string(only.cam->face_key()) + "_");
    };
    if (only.cam && std::ranges::none_of(keys, of_face)) only.cam->face_half_width.reset();
    for (const WrittenBound& bound : motion_bounds(scene)) {
        if (bound.corridor < 0 || stays(bound.key)) continue;
        Corridor::Bounds& bounds = only.motion.corridors[static_cast<std::size_t>(bound.corridor)]
                                       .bounds[static_cast<std::size_t>(bound.order)];
        (bound.sign < 0 ? bounds.least : bounds.most).reset();
    }
    std::erase_if(only.motion.corridors, [](const Corridor& corridor) {
        return std::ranges::none_of(
            corridor.bounds, [](const Corridor::Bounds& bounds) { return bounds.least || bounds.most; });
    });
    return only;
}

/// Every limit, corridors too.
std::vector<Adjustment> limit_changes(const Scene& scene) {
    std::vector<Adjustment> limits = adjustments(scene);
    std::erase_if(limits, [](const Adjustment& one) { return !one.limit; });
    return limits;
}

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();  ///< of a proof without rows

/// The conflict of these limits alone, where they are proved infeasible; else empty.
std::vector<ConflictReport> conflict_of(const Scene& scene, const std::vector<std::string>& keys,
                                        const Budget& budget) {
    const Scene only = only_limits(scene, keys);
    if (budget.spent() || find_fault(only) || least_violation(only, budget) <= 0.0) return {};
    std::optional<std::vector<ConflictReport>> rows = proved_conflict(only, budget);
    if (!rows) return {};
    if (rows->empty())
        for (const std::string& key : keys)
            rows->push_back({key, nowhere, 1.0 / static_cast<double>(keys.size())});
    return *rows;
}

/// The limits that the proof of infeasibility rests on, each once.
std::vector<std::string> fighting_keys(const Solution& solution) {
    std::vector<std::string> keys;
    for (const ConflictReport& row : solution.conflict)
        if (std::ranges::find(keys, row.key) == keys.end()) keys.push_back(row.key);
    return keys;
}

/// A scene that is not convex, with so few segments that its searches are quick. Each of them is made of
/// whole segments of the given spline, so that its motions are motions of that spline too. None where the
/// scene is quick already, or its breakpoints are not uniform.
std::optional<Scene> coarse_scene(const Scene& scene) {
    int segments = scene.spline.segments;
    while (segments > most_quick_segments && segments % 2 == 0) segments /= 2;
    const bool uniform = scene.spline.breakpoints.empty() && placed_points(scene.motion).empty();
    if (!uniform || segments == scene.spline.segments || scene.spline.free_knots || scene.motion.prescribed())
        return {};
    if (!needs_starts(scene_model(scene, DesignKind::states, reference_peaks(scene)))) return {};
    return with_segments(scene, segments);
}

/// At most twice the given value, at least half of it. From 0 any value is useful, and so are more segments.
bool is_useful(const Relaxation& row) {
    if (!row.needed) return false;
    if (row.given == 0.0 || row.key.starts_with("spline.")) return true;
    const double ratio = *row.needed / row.given;
    return ratio >= 0.5 && ratio <= 2.0;
}

class Explainer {
 public:
    Explainer(Solution& solution, const Budget& budget)
        : solution_(solution), scene_(solution.scene), budget_(budget) {
        found_.allowed = budget.left();
    }

    void run() {
        found_.any_motion = kept_by_no_motion(scene_);
        if (solution_.certificate.reason == Reason::limit_broken_at_rest)
            found_.any_motion = fighting_keys(solution_);
        reduce_conflict();
        change_set_points();
        coarse_ = coarse_scene(scene_);
        if (!contradictory())
            change_each();
        else if (!has_enough())
            try_segments();
        std::stable_partition(solution_.relaxation.begin(), solution_.relaxation.end(),
                              [](const Relaxation& row) { return row.needed.has_value(); });
        std::stable_partition(solution_.relaxation.begin(), solution_.relaxation.end(), is_useful);
        relax_together();
        name_all_limits();
        found_.seconds = watch_.seconds();
        found_.end = end();
        solution_.explanation = std::move(found_);
    }

 private:
    Solution& solution_;
    const Scene& scene_;
    const Budget& budget_;
    Stopwatch watch_;
    Explanation found_;
    bool over_ = false, conflict_cut_ = false, segments_tried_ = false;
    std::optional<Scene> coarse_;

    /// Once over, the clock is asked no more.
    [[nodiscard]] bool is_over() { return over_ = over_ || budget_.spent(); }

    [[nodiscard]] bool has_enough() const {
        return std::ranges::count_if(solution_.relaxation, is_useful) >= scene_.solver.explain_changes;
    }

    [[nodiscard]] ExplanationEnd end() const {
        if (budget_.control().stopped()) return ExplanationEnd::interrupted;
        if (over_ || conflict_cut_ || !found_.unsettled.empty()) return ExplanationEnd::time_limit;
        return has_enough() ? ExplanationEnd::enough : ExplanationEnd::complete;
    }

    [[nodiscard]] bool contradictory() const {
        return solution_.certificate.reason == Reason::conditions_contradict;
    }

    /// The rows of a proof may belong to more limits than it takes: each limit is tried alone, then pairs.
    void reduce_conflict() {
        if (solution_.certificate.verdict != Verdict::infeasible || contradictory()) return;
        budget_.say("suggested changes: which limits are infeasible separately");
        const Budget part = budget_.part(part_of_conflict);
        const std::vector<std::string> given = fighting_keys(solution_);
        std::vector<std::string> keys = given;
        for (const Adjustment& one : limit_changes(scene_))
            if (std::ranges::find(keys, one.key) == keys.end()) keys.push_back(one.key);
        std::vector<ConflictReport> rows;
        for (const std::string& key : keys) {
            const bool known = given.size() == 1 && key == given.front();
            const auto conflict = known ? solution_.conflict : conflict_of(scene_, {key}, part);
            rows.insert(rows.end(), conflict.begin(), conflict.end());
            if (!conflict.empty()) found_.alone.push_back(key);
        }
        for (std::size_t i = 0; keys.size() > 2 && i < keys.size(); ++i)
            for (std::size_t k = i + 1; rows.empty() && k < keys.size(); ++k)
                rows = conflict_of(scene_, {keys[i], keys[k]}, part);
        conflict_cut_ = part.spent();
        if (rows.empty()) return;
        for (ConflictReport& row : rows)
            row.weight /= static_cast<double>(std::max<std::size_t>(found_.alone.size(), 1));
        std::ranges::stable_sort(rows, std::greater{}, &ConflictReport::weight);
        solution_.conflict = std::move(rows);
    }

    /// Proofs over boxes and of any curve have no rows of limits.
    void name_all_limits() {
        const bool proved = solution_.certificate.verdict == Verdict::infeasible;
        if (!proved || contradictory() || !solution_.conflict.empty()) return;
        const std::vector<Adjustment> limits = limit_changes(scene_);
        for (const Adjustment& one : limits)
            solution_.conflict.push_back({one.key, nowhere, 1.0 / static_cast<double>(limits.size())});
    }

    void try_segments() {
        segments_tried_ = true;
        if (scene_.motion.prescribed() || !found_.any_motion.empty() || no_motion_keeps_all_caps(scene_))
            return;
        const Budget part = budget_.part(part_of_segments);
        FinerSpline finer = finer_spline(scene_, part);
        if (finer.row) solution_.relaxation.push_back(*finer.row);
        found_.finest = finer.finest;
        if (!finer.row && part.spent()) found_.unsettled.emplace_back("spline.segments");
    }

    /// Those without which the scene has a motion, and of the first of them the number to change.
    void change_set_points() {
        std::vector<SetPointChanges> all = set_point_changes(scene_);
        std::ranges::stable_sort(all, {},
                                 [](const SetPointChanges& one) { return !one.place; });  // regions last
        const Budget part = budget_.part(part_of_set_points);
        int changed = 0;
        for (const SetPointChanges& one : all) {
            if (part.spent()) {  // not searched to its end
                found_.unsettled.push_back(one.member);
                continue;
            }
            budget_.say(fmt::format("suggested changes: {}", one.member));
            if (!(least_violation(one.without, part) <= 0.0)) continue;
            found_.set_points.push_back(one.member);
            if (changed == most_set_points || has_enough()) continue;
            if (std::optional<Relaxation> row = change_of(one, part.part(0.5))) {
                solution_.relaxation.push_back(std::move(*row));
                ++changed;
            }
        }
    }

    /// The first useful change of one of its numbers, or any.
    [[nodiscard]] std::optional<Relaxation> change_of(const SetPointChanges& point,
                                                      const Budget& part) const {
        std::optional<Relaxation> found;
        const auto settle = [&](const Adjustment& change, const std::optional<double>& needed) {
            if (!needed) return;
            std::optional<Relaxation> row = solved_relaxation(scene_, change, *needed, part);
            if (row && (!found || is_useful(*row))) found = std::move(row);
        };
        const auto search = [&](const Adjustment& change) {
            if (!found || !is_useful(*found))
                settle(change, nearest_value(scene_, change, infinity, part.part(0.5)));
        };
        for (const SetPointChanges::Value& value : point.values) {
            if (found && is_useful(*found)) break;
            if (!value.without) {
                search(value.change);
                continue;
            }
            const auto motion = solved_motion(*value.without, part);
            if (!motion) continue;
            const double feasible =
                motion->at(point.at, Side::right).derivative[value.order] * value.per_normalised;
            settle(value.change, value_towards(scene_, value.change, feasible, part.part(0.5)));
        }
        if (point.place) search(*point.place);
        return found;
    }

    /// One row, or the key of a search that did not end. given: least_violation() of the scene.
    void add_row(const Adjustment& adjustment, double share, double given) {
        if (is_over()) {
            found_.unsettled.push_back(adjustment.key);
            return;
        }
        budget_.say(fmt::format("suggested changes: {}", adjustment.key));
        const Budget part = budget_.part(share), searching = part.part(part_of_search);
        std::optional<Relaxation> row;
        if (coarse_)
            if (const auto needed = nearest_value(*coarse_, adjustment, infinity, searching))
                row = solved_relaxation(*coarse_, adjustment, *needed, part);
        const std::optional<double> needed =
            row ? std::nullopt : nearest_value(scene_, adjustment, given, searching);
        if (needed) {
            row = solved_relaxation(scene_, adjustment, *needed, part);
        } else if (!row && !searching.spent()) {
            row = Relaxation{adjustment.key, adjustment.given};
            row->ruled_out = adjustment.limit && is_ruled_out(adjustment, part);
            // A proof that the clock ended must not make two runs of one scene differ in silence.
            if (adjustment.limit && !row->ruled_out && part.spent()) row.reset();
        }
        std::erase_if(solution_.relaxation,
                      [&](const Relaxation& before) { return before.key == adjustment.key; });
        if (row)
            solution_.relaxation.push_back(std::move(*row));
        else  // what was not searched to its end must not pass for "nothing helps"
            found_.unsettled.push_back(adjustment.key);
    }

    [[nodiscard]] bool is_ruled_out(const Adjustment& limit, const Budget& budget) const {
        return proved_conflict(limit.with(scene_, limit.may_grow ? limit.most : limit.least), budget)
            .has_value();
    }

    /// Everything that can be changed, the most useful first. What the proof does not rest on comes last.
    [[nodiscard]] std::vector<Adjustment> ordered_changes() const {
        std::vector<Adjustment> all = adjustments(scene_);
        const bool in_time = std::ranges::any_of(peak_limit_rows(), [&](const PeakLimitRow& one) {
            const std::optional<PeakLimit>& limit = one.in(scene_.limits);
            return limit && limit->physical();
        });
        const bool in_space = scene_.cam.has_value() || in_time;
        if (!in_space)  // a motion in lifts has no dimensions that could help
            std::erase_if(all, [](const Adjustment& one) { return !one.limit; });
        const std::vector<ConflictReport>& conflict = solution_.conflict;
        const auto takes_part = [&](const Adjustment& one) {
            return conflict.empty() || std::ranges::any_of(conflict, [&](const ConflictReport& row) {
                       if (one.limit) return row.key == one.key;
                       return std::isnan(row.at) || (row.at >= one.begin && row.at <= one.end);
                   });
        };
        for (Adjustment& one : all)
            if (!takes_part(one)) one.usefulness = Usefulness::other;
        std::ranges::stable_sort(all, {}, &Adjustment::usefulness);
        return all;
    }

    [[nodiscard]] bool is_idle_fallback(const Adjustment& adjustment) const {
        return adjustment.fallback && std::ranges::any_of(solution_.relaxation, [](const Relaxation& row) {
                   return row.needed && row.key.starts_with("motion.") && is_angle_key(row.key);
               });
    }

    void change_each() {
        const std::vector<Adjustment> all = ordered_changes();
        const bool few_segments = segments_of(scene_.spline) < many_segments;
        double given = infinity;
        std::size_t done = 0;
        for (const Adjustment& one : all) {
            const bool first = std::ranges::none_of(solution_.relaxation, is_useful);
            const double share = std::max(first ? first_share : least_share,
                                          shares_of_one / static_cast<double>(all.size() - done++));
            if (few_segments && !segments_tried_ && one.usefulness != Usefulness::angle && !has_enough())
                try_segments();
            if (has_enough()) return;
            if (is_idle_fallback(one)) continue;
            if (done == 1) given = least_violation(scene_, budget_.part(least_share));
            add_row(one, share, given);
        }
        if (!segments_tried_ && !has_enough()) try_segments();
    }

    /// Where no limit alone can give way far enough.
    void relax_together() {
        if (contradictory() || has_enough()) return;
        const std::vector<Adjustment> limits = limit_changes(scene_);
        if (limits.size() < 2) return;
        for (const Relaxation& row : solution_.relaxation) {
            const bool of_limit = std::ranges::find(limits, row.key, &Adjustment::key) != limits.end();
            if (of_limit && row.needed) return;
        }
        if (!is_over()) {
            budget_.say("suggested changes: all limits together");
            found_.together = joint_relaxation(scene_, limits, budget_);
        }
        if (found_.together.empty() && is_over()) found_.unsettled.emplace_back(together_key);
    }
};

}  // namespace

void explain(Solution& solution, const SolveControl& control) {
    const Budget all(control);
    const double own = solution.scene.solver.explain_seconds;
    const bool own_limit = own < all.left();
    const Budget budget(control.sooner(own));
    budget.say(fmt::format("no motion: searching for changes, for at most {:.3g} s", budget.left()));
    Explainer(solution, budget).run();
    solution.explanation->own_limit = own_limit;
}

}  // namespace camopt
