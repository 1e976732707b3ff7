// SPDX-License-Identifier: MIT
#include "studies/solve/program/solve_free_displacements.hpp"

#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange/continuous_solve.hpp"
#include "studies/solve/program/free_displacement_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using Sign = DisplacementBox::Sign;

// Relaxations solved at most, shared out by the number of free displacements: enough to close the cases of
// one of them. A flat optimum of two or three would need thousands and is left open.
constexpr int most_cases = 300;
// Displacements closer to standing than this, in lifts, are tried as standing: what is left of a zero.
constexpr double nearly_standing = 1e-6;
// Steps of the moves, in lifts: the first, and the last one that must not help.
constexpr double first_step = 0.02, last_step = 1e-7;
constexpr int most_moves = 100;

std::vector<double> known_or(const MotionFamily& family, double missing) {
    std::vector<double> levels = {0.0};
    for (const MotionFamily::Stretch& stretch : family.stretches())
        levels.push_back(known_displacement(stretch.to).value_or(missing));
    return levels;
}

class DisplacementSearch : public ProgramSearch {
 public:
    DisplacementSearch(const Scene& scene, const Peaks& reference, const SolveGiven& solve_given,
                       const SolveControl& control)
        : ProgramSearch(scene, solve_given, control,
                        {"displacements", "structured, convex relaxation", Reason::free_displacements,
                         one_displacement}),
          cases_(scene, reference, control) {}

    void run() {
        bound_cases();
        if (!proved() && found()) move_levels();
    }

    [[nodiscard]] Solution deliver();

 private:
    // One displacement that no step moves downhill, and the best motion for it: no small change improves.
    static constexpr std::size_t one_displacement = 1;

    [[nodiscard]] bool is_left(const DisplacementCase& part) const {
        return !is_closed(part) && !part.indivisible;
    }
    [[nodiscard]] bool proved() const {
        return std::ranges::all_of(parts_, [&](const DisplacementCase& part) { return is_closed(part); });
    }

    void bound_cases();
    void try_guesses();
    bool try_levels(const Values& levels, double part_of_time);
    void move_levels();
    [[nodiscard]] Values snapped(Values levels) const;
    [[nodiscard]] Scene given(const Values& levels) const override;
    void tell_progress() const;
    void judge_cases(Solution& solution) const;
    void tell(Solution& solution) const;

    DisplacementCases cases_;
    std::vector<DisplacementCase> parts_;  ///< together they hold everything
    int bounded_ = 0;
};

Scene DisplacementSearch::given(const Values& levels) const {
    Scene scene = scene_;
    const std::vector<int>& joints = cases_.free().joints;
    for (std::size_t k = 0; k < joints.size(); ++k)
        scene.motion.segments[static_cast<std::size_t>(joints[k]) - 1].to = levels[k];
    return scene;
}

/// Inside the range, and standing where a segment nearly stands.
ProgramSearch::Values DisplacementSearch::snapped(Values levels) const {
    const FreeDisplacements& free = cases_.free();
    for (double& level : levels) level = std::clamp(level, free.least, free.most);
    std::vector<double> all = known_or(cases_.family(), std::nan(""));
    std::size_t next = 0;
    std::vector<int> entry(all.size(), -1);
    for (std::size_t joint = 1; joint < all.size(); ++joint) {
        const bool dwell = cases_.family().stretches()[joint - 1].kind == StretchRequest::Kind::dwell;
        if (next < free.joints.size() && free.joints[next] == static_cast<int>(joint)) {
            entry[joint] = static_cast<int>(next);
            all[joint] = levels[next++];
            const bool stands = std::abs(all[joint] - all[joint - 1]) < nearly_standing;
            if (stands) all[joint] = all[joint - 1];
        } else if (dwell && std::isnan(all[joint])) {
            all[joint] = all[joint - 1];
            entry[joint] = entry[joint - 1];
        }
    }
    for (std::size_t joint = all.size() - 1; joint > 0; --joint) {  // and from what lies behind
        const bool open = entry[joint - 1] >= 0 && std::abs(all[joint] - all[joint - 1]) < nearly_standing;
        if (open) all[joint - 1] = all[joint];
    }
    for (std::size_t joint = 1; joint < all.size(); ++joint)
        if (entry[joint] >= 0) levels[static_cast<std::size_t>(entry[joint])] = all[joint];
    return levels;
}

bool DisplacementSearch::try_levels(const Values& levels, double part_of_time) {
    return try_values(snapped(levels), part_of_time);
}

/// Displacements shared out by the angle, and every segment standing until it has to move.
void DisplacementSearch::try_guesses() {
    const std::vector<MotionFamily::Stretch>& stretches = cases_.family().stretches();
    const std::vector<double> known = known_or(cases_.family(), std::nan(""));
    std::vector<double> shared, late, early;
    for (const int joint : cases_.free().joints) {
        int before = joint, after = joint;
        while (std::isnan(known[static_cast<std::size_t>(before)])) --before;
        const int last = static_cast<int>(known.size()) - 1;
        while (after < last && std::isnan(known[static_cast<std::size_t>(after)])) ++after;
        const double from = known[static_cast<std::size_t>(before)];
        const double to = std::isnan(known[static_cast<std::size_t>(after)])
                              ? from
                              : known[static_cast<std::size_t>(after)];
        double passed = 0.0, whole = 0.0;
        for (int i = before; i < after; ++i) {
            const MotionFamily::Stretch& stretch = stretches[static_cast<std::size_t>(i)];
            if (stretch.kind == StretchRequest::Kind::dwell) continue;
            whole += stretch.end - stretch.begin;
            if (i < joint) passed += stretch.end - stretch.begin;
        }
        shared.push_back(from + (to - from) * (whole > 0.0 ? passed / whole : 0.0));
        late.push_back(from);
        early.push_back(to);
    }
    for (const std::vector<double>* levels : {&shared, &late, &early})
        if (!out_of_time(time_for_boxes)) try_levels(*levels, time_for_boxes);
}

void DisplacementSearch::bound_cases() {
    parts_.push_back(cases_.whole());
    cases_.bound(parts_.front(), left(time_for_boxes));
    bounded_ = 1;
    if (parts_.front().infeasible) return;
    if (!parts_.front().levels.empty()) try_levels(parts_.front().levels, time_for_boxes);
    if (!proved()) try_guesses();
    const int most = most_cases / static_cast<int>(std::max<std::size_t>(1, cases_.free().joints.size()));
    while (bounded_ < most && !proved() && !out_of_time(time_for_boxes)) {
        const auto next = std::ranges::min_element(parts_, [&](const auto& one, const auto& other) {
            if (is_left(one) != is_left(other)) return is_left(one);
            return one.bound < other.bound;
        });
        if (!is_left(*next)) return;
        std::vector<DisplacementCase> pieces = cases_.split(*next);
        next->indivisible = pieces.empty();
        if (next->indivisible) continue;  // what is left of the others may still hold the motion
        parts_.erase(next);
        for (DisplacementCase& piece : pieces) {
            if (!is_closed(piece) && !out_of_time(time_for_boxes)) {
                cases_.bound(piece, left(time_for_boxes));
                ++bounded_;
                // A relaxation that ended early has no displacements to try.
                if (!is_closed(piece) && !piece.levels.empty()) try_levels(piece.levels, time_for_boxes);
            }
            parts_.push_back(std::move(piece));
        }
        tell_progress();
    }
}

void DisplacementSearch::tell_progress() const {
    if (!control_.progress) return;
    const std::string line =
        fmt::format("{} cases of the free displacements, objective {:.9g}", bounded_, objective());
    Progress progress(line);
    if (std::isfinite(objective())) progress.incumbent = objective();
    double bound = infinity;
    for (const DisplacementCase& part : parts_)
        if (!part.infeasible) bound = std::min(bound, part.bound);
    if (std::isfinite(bound) && bound > 0.0) progress.bound = bound;
    control_.progress(progress);
}

/// Each displacement by itself, forth and back, by steps that shrink where neither helps.
void DisplacementSearch::move_levels() {
    std::vector<double> step(best_values_.size(), first_step);
    int moves = 0;
    bool moving = true;
    while (moving) {
        moving = false;
        for (std::size_t k = 0; k < step.size(); ++k) {
            if (step[k] < last_step) continue;
            moving = true;
            bool helped = false;
            for (const double way : {1.0, -1.0}) {
                if (helped) break;
                if (++moves > most_moves || out_of_time(time_for_moves)) return;
                Values levels = best_values_;
                levels[k] += way * step[k];
                helped = try_levels(levels, time_for_moves);
            }
            step[k] = next_step(step[k], helped);
        }
    }
    settled_ = true;
}

void DisplacementSearch::judge_cases(Solution& solution) const {
    std::vector<CaseProof> proofs;
    for (const DisplacementCase& part : parts_) {
        std::vector<std::string> region;
        for (const DisplacementBox& box : part.boxes) region.push_back(box.words());
        proofs.push_back({std::move(region), part.bound, part.infeasible, part.proof});
    }
    // What the clock ended is no search.
    const bool time_ended = timed_out_ || control_.in_vain.passed() || left(time_for_boxes) <= 0.0;
    judge(solution, std::move(proofs), time_ended);
}

void DisplacementSearch::tell(Solution& solution) const {
    solution.notes.push_back(fmt::format(
        "free displacements, sought between {:.6g} and {:.6g} lifts: {} cases bounded, {} sets of "
        "displacements tried",
        cases_.free().least, cases_.free().most, bounded_, tried_.size()));
    note_time(solution);
    if (!solution.motion) return;
    std::vector<std::string> names;
    for (const int joint : cases_.free().joints)
        names.push_back(fmt::format("motion.segments[{}].to", joint - 1));
    add_to_design(solution, std::move(names));
}

Solution DisplacementSearch::deliver() {
    Solution solution = found() ? best_solved() : best_;
    solution.scene = scene_;
    solution.seconds_solve = solution.seconds_total = watch_.seconds();
    solution.solver.convex = false;
    judge_cases(solution);
    tell(solution);
    return solution;
}

}  // namespace

Solution solve_free_displacements(const Scene& scene, const Peaks& reference, const SolveGiven& solve_given,
                                  const SolveControl& control) {
    DisplacementSearch search(scene, reference, solve_given, control);
    search.run();
    return search.deliver();
}

}  // namespace camopt
