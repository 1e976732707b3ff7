// SPDX-License-Identifier: MIT
#include "studies/search/free_angles.hpp"

#include "scene/cost_table.hpp"
#include "scene/part_names.hpp"
#include "studies/bound/branch_and_bound.hpp"
#include "studies/delivered/solution_report.hpp"

#include <fmt/format.h>

#include <random>

namespace camopt {

namespace {

// Boxes bounded at most; three ranges of a flat optimum would take thousands, and are left open.
constexpr int most_boxes = 400;
// Of a turn: the first step of a move, and the last one that must not help.
constexpr double first_angle_step = 1.0 / 64.0, last_angle_step = 1e-8;
constexpr int most_angle_moves = 400;
// Angles tried at random where the current ones allow no motion.
constexpr int random_angles = 24;
// Of a turn: a box narrower than this has nothing left to gain but rounding.
constexpr double narrowest_box = 1e-12;
// Part of the gap that a box may keep when it is closed.
constexpr double closing_part_of_gap = 0.5;
constexpr double step_growth = 2.0, step_shrink = 0.25;
// Two ranges are one freedom: no step forth or back helps. Of more, a step along two at once might.
constexpr std::size_t one_freedom = 2;

/// Angles of the segments with a range.
using Angles = std::vector<double>;

/// Angles within a box, and what is proved of them.
struct AngleBox : CaseProof {
    Angles least = {}, most = {};
};

class AngleSearch {
 public:
    AngleSearch(const Scene& scene, const SolvePlan& plan, const SolveControl& control,
                const SolveScene& solve)
        : scene_(scene),
          plan_(plan),
          control_(control),
          solve_(solve),
          allowed_(std::min(plan.seconds, control.deadline.seconds_left())) {
        whole_.bound = least_objective(scene.objective);
        for (std::size_t i = 0; i < scene.motion.segments.size(); ++i) {
            const ProgramSegment& segment = scene.motion.segments[i];
            if (!segment.angle_range) {
                fixed_ += segment.angle;
                continue;
            }
            searched_.push_back(i);
            whole_.least.push_back(segment.angle_range->least);
            whole_.most.push_back(segment.angle_range->most);
            given_.push_back(segment.angle);
        }
    }

    void run() {
        try_angles(given_, plan_.bounding_boxes);
        if (plan_.proof == ProofKind::boxes) bound_boxes();
        if (!found() && !proved()) try_at_random();
        if (!proved() && found()) move_angles();
    }

    [[nodiscard]] Solution deliver() {
        const Angles& angles = found() ? best_angles_ : given_;
        // Where there is no motion, the conflict of the given angles is told.
        Solution solution = found() ? best_solved() : solve_(given(angles), control_);
        set_scene(solution, with_segment_angles(scene_, all_angles(angles)));
        solution.seconds_solve = solution.seconds_total = watch_.seconds();
        solution.solver.convex = false;
        for (std::string& note : solution.notes) note.insert(0, "for these angles: ");
        judge(solution);
        report(solution);
        return solution;
    }

 private:
    const Scene& scene_;
    const SolvePlan& plan_;
    const SolveControl& control_;
    const SolveScene& solve_;
    Stopwatch watch_;
    double allowed_;
    double fixed_ = 0.0;                 ///< rad, of the segments without a range
    std::vector<std::size_t> searched_;  ///< the others
    AngleBox whole_;
    Angles given_;
    Solution best_;
    Angles best_angles_;
    std::vector<Angles> tried_;
    std::vector<AngleBox> boxes_;  ///< together they hold everything
    int bounded_ = 0;
    bool timed_out_ = false, settled_ = false;

    [[nodiscard]] bool found() const { return best_.motion != nullptr; }
    [[nodiscard]] double objective() const {
        if (!found()) return infinity;
        return best_.certificate.objective;
    }
    /// Seconds of a part of the time that are left.
    [[nodiscard]] double left(double part) const { return part * allowed_ - watch_.seconds(); }
    /// A box of this bound holds nothing better worth the search.
    [[nodiscard]] bool is_closed(const AngleBox& box) const {
        return box.infeasible || box.bound >= objective() - closing_part_of_gap * scene_.solver.wanted_gap() *
                                                                std::max(1.0, objective());
    }
    [[nodiscard]] bool proved() const {
        return !boxes_.empty() &&
               std::ranges::all_of(boxes_, [&](const AngleBox& box) { return is_closed(box); });
    }

    [[nodiscard]] bool out_of_time(double part) {
        if (control_.stopped()) return true;
        const bool in_vain = !found() && control_.in_vain.passed();
        if (!in_vain && left(part) > 0.0) return false;
        timed_out_ = true;
        return true;
    }

    [[nodiscard]] std::vector<double> all_angles(const Angles& angles) const {
        std::vector<double> all;
        for (const ProgramSegment& segment : scene_.motion.segments) all.push_back(segment.angle);
        for (std::size_t k = 0; k < angles.size(); ++k) all[searched_[k]] = angles[k];
        return all;
    }

    /// Leaves of a box what can add up to the turn; false: nothing.
    [[nodiscard]] bool narrow(AngleBox& box) const {
        const double rest = units::turn - fixed_, rounding = narrowest_box * units::turn;
        for (int sweep = 0; sweep < 2; ++sweep) {
            double least = 0.0, most = 0.0;
            for (const double angle : box.least) least += angle;
            for (const double angle : box.most) most += angle;
            if (least > rest + rounding || most < rest - rounding) return false;
            for (std::size_t k = 0; k < box.least.size(); ++k) {
                const double up = std::min(box.most[k], rest - (least - box.least[k]));
                const double down = std::max(box.least[k], rest - (most - box.most[k]));
                box.most[k] = std::max(up, box.least[k]);
                box.least[k] = std::min(down, box.most[k]);
            }
        }
        return true;
    }

    /// Angles of a box that add up.
    [[nodiscard]] Angles inside(const AngleBox& box) const {
        double least = 0.0, most = 0.0;
        for (const double angle : box.least) least += angle;
        for (const double angle : box.most) most += angle;
        const double part =
            most > least ? std::clamp((units::turn - fixed_ - least) / (most - least), 0.0, 1.0) : 0.0;
        Angles angles;
        for (std::size_t k = 0; k < box.least.size(); ++k)
            angles.push_back(box.least[k] + part * (box.most[k] - box.least[k]));
        return angles;
    }

    [[nodiscard]] Scene given(const Angles& angles) const {
        Scene scene = with_segment_angles(scene_, all_angles(angles));
        for (ProgramSegment& segment : scene.motion.segments) segment.angle_range.reset();
        return scene;
    }

    /// The scene for these angles, as fast as it goes: the search itself breaks no ties.
    [[nodiscard]] Scene quick(const Angles& angles, double seconds) const {
        Scene scene = given(angles);
        scene.objective.tie_break = TieBreak::none;
        scene.solver.name = "auto";
        scene.solver.options.clear();
        scene.spline.design = DesignKind::automatic;
        scene.spline.free_knots = false;  // breakpoints are searched for the angles that are found
        scene.solver.max_seconds = seconds;
        return scene;
    }

    /// Whether angles that were not tried yet are the best so far.
    bool try_angles(const Angles& angles, double part_of_time) {
        if (std::ranges::find(tried_, angles) != tried_.end()) return false;
        tried_.push_back(angles);
        const double seconds = left(part_of_time);
        if (seconds <= 0.0) return false;
        Solution solution = solve_(quick(angles, seconds), control_);
        const bool better = solution.motion && solution.certificate.objective < objective();
        if (!better || solution.certificate.verdict == Verdict::failed) return false;
        best_ = std::move(solution);
        best_angles_ = angles;
        if (control_.progress) {
            const std::string line =
                fmt::format("{} sets of angles, objective {:.9g}", tried_.size(), objective());
            Progress progress(line);
            progress.incumbent = objective();
            control_.progress(progress);
        }
        return true;
    }

    void bound(AngleBox& box) {
        ++bounded_;
        const double seconds = left(plan_.bounding_boxes);
        if (seconds <= 0.0) return;
        take_bound(box, solve_(quick(box.most, seconds), control_).certificate);
    }

    /// Two halves, less what does not add up to the turn; none: too narrow.
    [[nodiscard]] std::optional<std::vector<AngleBox>> halves(const AngleBox& box) {
        std::size_t widest = 0;
        for (std::size_t k = 1; k < box.least.size(); ++k)
            if (box.most[k] - box.least[k] > box.most[widest] - box.least[widest]) widest = k;
        if (box.most[widest] - box.least[widest] < narrowest_box * units::turn) return {};
        const double middle = 0.5 * (box.least[widest] + box.most[widest]);
        std::vector<AngleBox> parts;
        for (const bool upper : {false, true}) {
            AngleBox part = box;
            (upper ? part.least : part.most)[widest] = middle;
            if (narrow(part)) parts.push_back(std::move(part));
        }
        for (AngleBox& part : parts) {
            if (out_of_time(plan_.bounding_boxes)) continue;
            try_angles(inside(part), plan_.bounding_boxes);
            if (!is_closed(part)) bound(part);
        }
        return parts;
    }

    void bound_boxes() {
        AngleBox all = whole_;
        if (!narrow(all)) return;
        bound(all);
        boxes_.push_back(std::move(all));
        branch_and_bound(boxes_, {[this](const AngleBox& box) { return is_closed(box); },
                                  [this](const AngleBox&) {
                                      return bounded_ < most_boxes && !out_of_time(plan_.bounding_boxes);
                                  },
                                  [this](const AngleBox& box) { return halves(box); }});
    }

    void try_at_random() {
        std::mt19937 engine(scene_.solver.seed);
        for (int k = 0; k < random_angles && !found() && !out_of_time(plan_.bounding_boxes); ++k) {
            // A box around random corners holds angles that add up, or is passed over.
            AngleBox box = whole_;
            for (std::size_t i = 0; i < box.least.size(); ++i) {
                const double part = static_cast<double>(engine()) / 4294967295.0;
                const double cut = box.least[i] + part * (box.most[i] - box.least[i]);
                (engine() % 2 == 0 ? box.least : box.most)[i] = cut;
            }
            if (narrow(box)) try_angles(inside(box), plan_.bounding_boxes);
        }
    }

    /// From each segment to each other, by steps that shrink where none helps.
    void move_angles() {
        double step = first_angle_step * units::turn;
        int moves = 0;
        while (step >= last_angle_step * units::turn) {
            bool helped = false;
            for (std::size_t from = 0; from < searched_.size() && !helped; ++from) {
                for (std::size_t to = 0; to < searched_.size() && !helped; ++to) {
                    const double passed = std::min(
                        {step, best_angles_[from] - whole_.least[from], whole_.most[to] - best_angles_[to]});
                    if (from == to || passed < last_angle_step * units::turn) continue;
                    if (++moves > most_angle_moves || out_of_time(plan_.moving_angles)) return;
                    Angles angles = best_angles_;
                    angles[from] -= passed;
                    angles[to] += passed;
                    helped = try_angles(angles, plan_.moving_angles);
                }
            }
            step *= helped ? step_growth : step_shrink;
        }
        settled_ = true;
    }

    [[nodiscard]] std::string words(const AngleBox& box, std::size_t k) const {
        return fmt::format("{:.9g} deg <= angle of {} <= {:.9g} deg", box.least[k] / units::degree,
                           segment_key(searched_[k]), box.most[k] / units::degree);
    }

    [[nodiscard]] CasePart part_of(const AngleBox& box, std::size_t k) const {
        return {.segment = static_cast<int>(searched_[k]),
                .angle_deg = {{box.least[k] / units::degree, box.most[k] / units::degree}}};
    }

    /// What is proved of the boxes, which together hold everything.
    void take_proofs(Solution& solution) const {
        Certificate& certificate = solution.certificate;
        forget_proof(certificate);
        certificate.cases.clear();
        solution.solver.proof_source.clear();
        const bool complete = !boxes_.empty() && std::ranges::all_of(boxes_, [](const AngleBox& box) {
            return box.proof != nullptr;
        });
        if (!complete) return;
        solution.solver.proof_source = "structured, the largest angles of each box";
        if (!solution.motion) certificate.objective = infinity;
        std::vector<CaseProof> cases(boxes_.begin(), boxes_.end());
        for (std::size_t i = 0; i < cases.size(); ++i)
            for (std::size_t k = 0; k < searched_.size(); ++k) {
                cases[i].region.push_back(words(boxes_[i], k));
                cases[i].parts.push_back(part_of(boxes_[i], k));
            }
        const bool nothing = take_cases(certificate, std::move(cases)) && !solution.motion;
        if (nothing) certificate.verdict = Verdict::infeasible;
        if (nothing || boxes_.size() == 1) certificate.proof = *boxes_.front().proof;
        if (boxes_.size() > 1) return;
        certificate.cases.clear();  // one box settles the whole
        certificate.proof_kind = ProofKind::duality;
    }

    /// From a verdict for given angles to one for all.
    void judge(Solution& solution) const {
        Certificate& certificate = solution.certificate;
        const Verdict for_given = certificate.verdict;
        certificate.verdict = Verdict::failed;
        take_proofs(solution);
        if (!solution.motion) {
            certificate.reason = certificate.verdict == Verdict::infeasible ? Reason::limits_contradict
                                 : control_.stopped()                       ? Reason::interrupted
                                 : timed_out_                               ? Reason::time_limit
                                                                            : Reason::no_feasible_point;
            return;
        }
        certificate.verdict = for_given;
        if (for_given == Verdict::failed || for_given == Verdict::infeasible) return;
        const bool optimal = certificate.gap && *certificate.gap <= scene_.solver.wanted_gap();
        const bool local = settled_ && best_angles_.size() == one_freedom && for_given <= Verdict::local &&
                           !scene_.spline.free_knots;
        certificate.verdict = optimal ? Verdict::optimal : local ? Verdict::local : Verdict::feasible;
        certificate.reason = optimal ? Reason::none : local ? Reason::stationary : Reason::free_angles;
        if (!optimal && control_.stopped()) certificate.reason = Reason::interrupted;
        if (!optimal && timed_out_) certificate.reason = Reason::time_limit;
    }

    /// Angles are entries of the design like any other, in rad, so that they come back as they are.
    void report(Solution& solution) const {
        solution.notes.push_back(fmt::format(
            "searched angles: {} boxes bounded, {} sets of angles tried{}", bounded_, tried_.size(),
            plan_.proof == ProofKind::boxes ? "" : "; no bound over angles is known for such a scene"));
        if (timed_out_)
            solution.notes.emplace_back(
                "the search for angles reached its time limit: the result depends on the machine");
        if (!solution.motion) return;
        std::vector<std::string> names;
        for (const std::size_t segment : searched_) names.push_back(searched_angle_key(segment));
        add_to_design(solution, std::move(names), best_angles_);
    }

    /// The best motion, solved as the scene asks where that is no worse. There is one.
    [[nodiscard]] Solution best_solved() const {
        Scene scene = given(best_angles_);
        scene.solver.max_seconds = std::max(left(1.0), allowed_ * (1.0 - plan_.moving_angles));
        Solution last = solve_(scene, control_);
        const double allowance = scene_.solver.wanted_gap() * std::max(1.0, objective());
        const bool no_worse = last.motion && last.certificate.objective <= objective() + allowance;
        return no_worse ? last : best_;
    }
};

}  // namespace

Solution solve_free_angles(const Scene& scene, const SolvePlan& plan, const SolveControl& control,
                           const SolveScene& solve) {
    AngleSearch search(scene, plan, control, solve);
    search.run();
    return search.deliver();
}

}  // namespace camopt
