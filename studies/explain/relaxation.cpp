// SPDX-License-Identifier: MIT
#include "studies/explain/relaxation.hpp"

#include "profiles/scene_cam.hpp"
#include "scene/limit_table.hpp"
#include "studies/explain/adjustment.hpp"
#include "studies/explain/feasibility_question.hpp"
#include "studies/explain/finer_spline.hpp"
#include "studies/explain/joint_relaxation.hpp"
#include "studies/explain/smallest_of_any_motion.hpp"
#include "studies/explain/value_search.hpp"
#include "studies/solve/solve_without_explaining.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

// Of what is left: the search for more segments; one change alone, in equal shares of all that are left.
constexpr double part_of_segments = 0.3;
constexpr double shares_of_one = 2.0;

/// The scene that asks for the least of one limited peak and keeps every other limit.
Scene without_limit(const Scene& scene, const PeakLimitRow& one) {
    Scene relaxed = scene;
    one.in(relaxed.limits).reset();
    relaxed.objective = {};
    relaxed.own_terms.clear();
    relaxed.objective.*one.term().weight = 1.0;
    relaxed.objective.tie_break = TieBreak::none;
    relaxed.solver.name = "auto";
    relaxed.solver.options.clear();
    return relaxed;
}

/// The least peak in the unit of its limit; none where the other limits allow no motion or the time is out.
std::optional<double> least_peak(const Scene& scene, const PeakLimitRow& one, const Budget& budget) {
    if (budget.spent()) return {};
    Scene relaxed = without_limit(scene, one);
    const Solution least = solve_without_explaining(relaxed, budget.control());
    if (!least.motion) return {};
    return one.term().measured.of(least.peaks) * one.in(scene.limits)->unit_per_normalised();
}

/// The scene with one of its limits alone.
Scene only_limit(const Scene& scene, const std::string& key) {
    Scene only = scene;
    LimitSpec& limits = only.limits;
    const auto drop = [&](auto& limit) {
        if (limit && limit->key != key) limit.reset();
    };
    for (const PeakLimitRow& row : peak_limit_rows()) drop(row.in(limits));
    for (const LimitRow& row : limit_rows()) drop(row.in(limits));
    std::erase_if(only.own_limits, [&](const OwnLimit& limit) { return limit.key() != key; });
    if (only.cam && !key.starts_with("cam.face_half_width_")) only.cam->face_half_width.reset();
    return only;
}

/// The limits that the proof of infeasibility rests on, each once.
std::vector<std::string> fighting_keys(const Solution& solution) {
    std::vector<std::string> keys;
    for (const ConflictReport& row : solution.conflict)
        if (std::ranges::find(keys, row.key) == keys.end()) keys.push_back(row.key);
    return keys;
}

class Explainer {
 public:
    Explainer(Solution& solution, const Budget& budget)
        : solution_(solution), scene_(solution.scene), budget_(budget) {
        found_.allowed = budget.left();
    }

    void run() {
        name_the_impossible();
        if (try_segments()) relax_each();
        relax_together();
        found_.seconds = watch_.seconds();
        solution_.explanation = std::move(found_);
    }

 private:
    Solution& solution_;
    const Scene& scene_;
    const Budget& budget_;
    Stopwatch watch_;
    Explanation found_;
    bool over_ = false;

    /// Once over, the clock is asked no more.
    [[nodiscard]] bool is_over() { return over_ = over_ || budget_.spent(); }

    [[nodiscard]] bool contradictory() const {
        return solution_.certificate.reason == Reason::conditions_contradict;
    }

    void name_the_impossible() {
        const std::vector<std::string> keys = fighting_keys(solution_);
        found_.any_motion = kept_by_no_motion(scene_);
        if (solution_.certificate.reason == Reason::limit_broken_at_rest) found_.any_motion = keys;
        if (keys.size() == 1) found_.alone = keys;
        if (keys.size() < 2) return;
        budget_.say("what would help: which limits are impossible by themselves");
        for (const std::string& key : keys)
            if (!is_over() && is_proved_infeasible(only_limit(scene_, key), budget_))
                found_.alone.push_back(key);
    }

    /// False: the conditions contradict each other, so that no limit has a say.
    bool try_segments() {
        if (found_.any_motion.empty() && !no_motion_keeps_all_caps(scene_)) {
            const Budget part = budget_.part(part_of_segments);
            FinerSpline finer = finer_spline(scene_, part);
            if (finer.row) solution_.relaxation.push_back(*finer.row);
            found_.finest = finer.finest;
            if (!finer.row && part.spent()) found_.unsettled.emplace_back("spline.segments");
        }
        return !contradictory();
    }

    /// One row, or the key of a search that did not end. `find`: the needed value within the time it is
    /// given.
    template <typename Find>
    void add_row(const Adjustment& adjustment, double share, const Find& find) {
        if (is_over()) {
            found_.unsettled.push_back(adjustment.key);
            return;
        }
        budget_.say(fmt::format("what would help: {}", adjustment.key));
        const Budget part = budget_.part(share);
        const std::optional<double> needed = find(part);
        std::optional<Relaxation> row;
        if (needed) {
            row = solved_relaxation(scene_, adjustment, *needed, part);
        } else if (!part.spent()) {
            row = Relaxation{adjustment.key, adjustment.given};
            row->ruled_out = adjustment.limit && is_ruled_out(adjustment, part);
            // A proof that the clock ended must not make two runs of one scene differ in silence.
            if (adjustment.limit && !row->ruled_out && part.spent()) row.reset();
        }
        if (row)
            solution_.relaxation.push_back(std::move(*row));
        else  // what was not searched to its end must not pass for "nothing helps"
            found_.unsettled.push_back(adjustment.key);
    }

    [[nodiscard]] bool is_ruled_out(const Adjustment& limit, const Budget& budget) const {
        return is_proved_infeasible(limit.with(scene_, limit.may_grow ? limit.most : limit.least), budget);
    }

    void relax_each() {
        const std::vector<Adjustment> caps = peak_adjustments(scene_);
        std::vector<Adjustment> others;
        const bool in_time = std::ranges::any_of(peak_limit_rows(), [&](const PeakLimitRow& one) {
            const std::optional<PeakLimit>& limit = one.in(scene_.limits);
            return limit && limit->in_time();
        });
        const bool in_space = has_cam(scene_) || in_time;
        if (in_space || !scene_.own_limits.empty()) others = adjustments(scene_);
        // A motion that is nothing but normalised has no dimensions and no speed that could help.
        if (!in_space) std::erase_if(others, [](const Adjustment& one) { return !one.limit; });
        const std::size_t count = caps.size() + others.size();
        std::size_t done = 0;
        const auto share = [&] { return shares_of_one / static_cast<double>(count - done++); };
        const double given = least_violation(scene_, budget_);
        const auto search = [&](const Adjustment& adjustment) {
            add_row(adjustment, share(),
                    [&](const Budget& part) { return nearest_value(scene_, adjustment, given, part); });
        };
        std::size_t cap = 0;
        for (const PeakLimitRow& one : peak_limit_rows()) {
            if (!one.in(scene_.limits)) continue;
            const Adjustment& adjustment = caps[cap++];
            if (scene_.motion.type == MotionType::program)
                search(adjustment);
            else
                add_row(adjustment, share(),
                        [&](const Budget& part) { return least_peak(scene_, one, part); });
        }
        for (const Adjustment& adjustment : others) search(adjustment);
    }

    /// Where no limit alone can give way far enough.
    void relax_together() {
        if (contradictory()) return;
        std::vector<Adjustment> limits = peak_adjustments(scene_);
        for (Adjustment& one : adjustments(scene_))
            if (one.limit) limits.push_back(std::move(one));
        if (limits.size() < 2) return;
        for (const Relaxation& row : solution_.relaxation) {
            const bool of_limit = std::ranges::find(limits, row.key, &Adjustment::key) != limits.end();
            if (of_limit && row.needed) return;
        }
        if (!is_over()) {
            budget_.say("what would help: all limits together");
            found_.together = joint_relaxation(scene_, limits, budget_);
        }
        if (found_.together.empty() && is_over()) found_.unsettled.emplace_back(together_key);
    }
};

}  // namespace

void explain(Solution& solution, const SolveControl& control) {
    const Budget budget(control);
    budget.say(fmt::format("no motion: searches what would help, for {:.3g} s at most", budget.left()));
    Explainer(solution, budget).run();
}

}  // namespace camopt
