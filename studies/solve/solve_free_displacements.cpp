// SPDX-License-Identifier: MIT
#include "studies/solve/solve_free_displacements.hpp"

#include "core/deadline.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/exchange/continuous_solve.hpp"
#include "studies/solve/free_displacement_cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

using Sign = DisplacementBox::Sign;

// Relaxations solved at most, shared out by the number of free displacements: enough to close the cases of
// one of them. A flat optimum of two or three would need thousands and is left open.
constexpr int most_cases = 300;
// Part of the time that cases may take; the rest is for moving the best displacements and the last solve.
constexpr double time_for_cases = 0.6, time_for_moves = 0.9;
// Displacements closer to standing than this, in lifts, are tried as standing: what is left of a zero.
constexpr double nearly_standing = 1e-6;
// Steps of the moves, in lifts: the first, and the last one that must not help.
constexpr double first_step = 0.02, last_step = 1e-7;
constexpr double growth = 2.0, shrink = 0.25;
constexpr int most_moves = 100;
// Part of the gap that a case may keep when it is closed.
constexpr double closing_part = 0.5;

std::vector<double> known_or(const MotionFamily& family, double missing) {
    std::vector<double> levels = {0.0};
    for (const MotionFamily::Stretch& stretch : family.stretches())
        levels.push_back(known_displacement(stretch.to).value_or(missing));
    return levels;
}

class DisplacementSearch {
 public:
    DisplacementSearch(const Scene& scene, const Peaks& reference, const SolveGiven& solve_given,
                       const SolveControl& control)
        : scene_(scene), solve_given_(solve_given), control_(control), cases_(scene, reference, control) {}

    void run() {
        bound_cases();
        if (!proved() && best_.motion) move_levels();
    }

    [[nodiscard]] Solution deliver();

 private:
    [[nodiscard]] double seconds() const { return watch_.seconds(); }
    [[nodiscard]] double left(double part) const { return part * allowed_ - seconds(); }
    [[nodiscard]] bool out_of_time(double part) {
        if (control_.stopped()) return true;
        const bool in_vain = !best_.motion && control_.in_vain.passed();
        if (!in_vain && left(part) > 0.0) return false;
        timed_out_ = true;
        return true;
    }
    [[nodiscard]] double objective() const { return best_.motion ? best_.certificate.objective : infinity; }
    /// A case of this bound holds nothing better worth the search.
    [[nodiscard]] bool is_closed(const DisplacementCase& part) const {
        return part.infeasible ||
               part.bound >= objective() - closing_part * scene_.solver.gap * std::max(1.0, objective());
    }
    [[nodiscard]] bool is_left(const DisplacementCase& part) const {
        return !is_closed(part) && !part.indivisible;
    }
    [[nodiscard]] bool proved() const {
        return std::ranges::all_of(parts_, [&](const DisplacementCase& part) { return is_closed(part); });
    }

    void bound_cases();
    void try_guesses();
    bool try_levels(const std::vector<double>& levels, double part_of_time);
    void move_levels();
    [[nodiscard]] std::vector<double> snapped(std::vector<double> levels) const;
    [[nodiscard]] Scene given(const std::vector<double>& levels) const;
    /// Why no motion was found: what the clock ended is no search.
    [[nodiscard]] Reason reason_of_nothing() const {
        if (control_.stopped()) return Reason::interrupted;
        const bool timed_out = timed_out_ || control_.in_vain.passed() || left(time_for_cases) <= 0.0;
        return timed_out ? Reason::time_limit : Reason::no_feasible_point;
    }
    void tell_progress() const;
    void judge(Solution& solution) const;
    void tell(Solution& solution) const;

    const Scene& scene_;
    const SolveGiven& solve_given_;
    const SolveControl& control_;
    Stopwatch watch_;
    double allowed_ = std::min(scene_.solver.max_seconds, control_.deadline.seconds_left());
    DisplacementCases cases_;
    std::vector<DisplacementCase> parts_;  ///< together they hold everything
    Solution best_;
    std::vector<double> best_levels_;
    std::vector<std::vector<double>> tried_;
    int bounded_ = 0;
    bool timed_out_ = false, settled_ = false;
};

/// The scene with the free displacements given; the search itself breaks no ties.
Scene DisplacementSearch::given(const std::vector<double>& levels) const {
    Scene scene = scene_;
    const std::vector<int>& joints = cases_.free().joints;
    for (std::size_t k = 0; k < joints.size(); ++k)
        scene.motion.segments[static_cast<std::size_t>(joints[k]) - 1].to = levels[k];
    return scene;
}

/// Inside the range, and standing where a segment nearly stands.
std::vector<double> DisplacementSearch::snapped(std::vector<double> levels) const {
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

bool DisplacementSearch::try_levels(const std::vector<double>& wanted, double part_of_time) {
    const std::vector<double> levels = snapped(wanted);
    if (std::ranges::find(tried_, levels) != tried_.end()) return false;
    tried_.push_back(levels);
    Scene scene = given(levels);
    scene.objective.tie_break = TieBreak::none;
    scene.solver.name = "auto";
    scene.solver.options.clear();
    scene.spline.design = DesignKind::automatic;
    scene.solver.max_seconds = std::max(left(part_of_time), 0.0);
    if (scene.solver.max_seconds <= 0.0) return false;
    Solution solution = solve_given_(scene);
    const bool better = solution.motion && solution.certificate.objective < objective();
    if (!better) return false;
    best_ = std::move(solution);
    best_levels_ = levels;
    return true;
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
        if (!out_of_time(time_for_cases)) try_levels(*levels, time_for_cases);
}

void DisplacementSearch::bound_cases() {
    parts_.push_back(cases_.whole());
    cases_.bound(parts_.front(), left(time_for_cases));
    bounded_ = 1;
    if (parts_.front().infeasible) return;
    if (!parts_.front().levels.empty()) try_levels(parts_.front().levels, time_for_cases);
    if (!proved()) try_guesses();
    const int most = most_cases / static_cast<int>(std::max<std::size_t>(1, cases_.free().joints.size()));
    while (bounded_ < most && !proved() && !out_of_time(time_for_cases)) {
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
            if (!is_closed(piece) && !out_of_time(time_for_cases)) {
                cases_.bound(piece, left(time_for_cases));
                ++bounded_;
                // A relaxation that ended early has no displacements to try.
                if (!is_closed(piece) && !piece.levels.empty()) try_levels(piece.levels, time_for_cases);
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
    std::vector<double> step(best_levels_.size(), first_step);
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
                std::vector<double> levels = best_levels_;
                levels[k] += way * step[k];
                helped = try_levels(levels, time_for_moves);
            }
            step[k] *= helped ? growth : shrink;
        }
    }
    settled_ = true;
}

void DisplacementSearch::judge(Solution& solution) const {
    Certificate& certificate = solution.certificate;
    const Verdict for_given = certificate.verdict;
    certificate.lower_bound.reset();
    certificate.gap.reset();
    certificate.proof.reset();
    certificate.proof_kind = ProofKind::none;
    solution.solver.proof_source.clear();
    double bound = infinity;
    bool complete = true;
    for (const DisplacementCase& part : parts_) {
        if (!part.infeasible) bound = std::min(bound, part.bound);
        complete = complete && part.proof;
        std::vector<std::string> region;
        for (const DisplacementBox& box : part.boxes) region.push_back(box.words());
        certificate.cases.push_back({std::move(region), part.bound, part.infeasible, part.proof});
    }
    const bool nothing = std::ranges::all_of(parts_, &DisplacementCase::infeasible);
    if (!complete || (!nothing && !(bound > 0.0))) {
        certificate.cases.clear();
    } else if (parts_.size() == 1) {  // one relaxation settles the whole
        certificate.cases.clear();
        certificate.proof = *parts_.front().proof;
        certificate.proof_kind = ProofKind::duality;
    } else {
        certificate.proof_kind = ProofKind::boxes;
    }
    if (certificate.proof_kind != ProofKind::none)
        solution.solver.proof_source = "structured, convex relaxation";
    if (!solution.motion) {
        const bool impossible = nothing && certificate.proof_kind != ProofKind::none;
        certificate.verdict = impossible ? Verdict::infeasible : Verdict::failed;
        certificate.reason = impossible ? Reason::limits_contradict : reason_of_nothing();
        if (impossible && !certificate.proof) certificate.proof = *parts_.front().proof;
        return;
    }
    if (certificate.proof_kind != ProofKind::none) {
        certificate.lower_bound = bound;
        certificate.gap = relative_gap(certificate.objective, bound);
    }
    const bool optimal = certificate.gap && *certificate.gap <= scene_.solver.gap;
    // One displacement that no step moves downhill, and the best motion for it: no small change improves.
    const bool local = settled_ && best_levels_.size() == 1 && for_given <= Verdict::local;
    if (for_given == Verdict::failed || for_given == Verdict::infeasible) return;
    certificate.verdict = optimal ? Verdict::optimal : local ? Verdict::local : Verdict::feasible;
    certificate.reason = optimal ? Reason::none : local ? Reason::stationary : Reason::free_displacements;
    if (!optimal && control_.stopped()) certificate.reason = Reason::interrupted;
    if (!optimal && timed_out_) certificate.reason = Reason::time_limit;
}

/// The free displacements are free entries of the design like any other.
void DisplacementSearch::tell(Solution& solution) const {
    solution.notes.push_back(fmt::format(
        "free displacements, sought between {:.6g} and {:.6g} lifts: {} cases bounded, {} sets of "
        "displacements tried",
        cases_.free().least, cases_.free().most, bounded_, tried_.size()));
    if (timed_out_)
        solution.notes.emplace_back(
            "the time ended the search for displacements: how far it came depends on the "
            "machine");
    if (!solution.motion) return;
    const auto count = static_cast<Eigen::Index>(best_levels_.size());
    std::vector<std::string> names;
    for (const int joint : cases_.free().joints)
        names.push_back(fmt::format("motion.segments[{}].to", joint - 1));
    names.insert(names.end(), solution.design.names.begin(), solution.design.names.end());
    Eigen::VectorXd values(count + solution.design.values.size());
    values << Eigen::Map<const Eigen::VectorXd>(best_levels_.data(), count), solution.design.values;
    solution.design.names = std::move(names);
    solution.design.values = std::move(values);
}

Solution DisplacementSearch::deliver() {
    Solution solution = best_;
    if (best_.motion) {
        Scene scene = given(best_levels_);
        scene.solver.max_seconds = std::max(left(1.0), allowed_ * (1.0 - time_for_moves));
        Solution last = solve_given_(scene);
        const double allowance = scene_.solver.gap * std::max(1.0, objective());
        if (last.motion && last.certificate.objective <= objective() + allowance) solution = std::move(last);
    }
    solution.scene = scene_;
    solution.seconds_solve = solution.seconds_total = seconds();
    solution.solver.convex = false;
    judge(solution);
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
