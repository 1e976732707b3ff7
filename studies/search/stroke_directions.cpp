// SPDX-License-Identifier: MIT
#include "studies/search/stroke_directions.hpp"

#include "scene/cost_table.hpp"
#include "studies/bound/branch_and_bound.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/presolve.hpp"
#include "studies/search/solve_motion.hpp"
#include "studies/search/stroke_excursions.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double contradiction = 1e-6;  // lifts: less is left to the solver, whose tolerance may allow it

/// Some directions given, and the best motion with them.
struct Case : CaseProof {
    std::vector<StrokeDirection> directions = {};
    Solution solution = {};
    int leaves = -1;  ///< the open stroke that leaves its range most, −1: none does

    /// Of a motion that leaves no stroke.
    [[nodiscard]] double objective() const {
        if (leaves >= 0 || !solution.motion) return infinity;
        return solution.certificate.objective;
    }
};

class DirectionSearch {
 public:
    DirectionSearch(const Scene& scene, const SolveControl& control)
        : scene_(scene),
          control_(control),
          family_(scene_family(scene, DesignKind::states)),
          strokes_(strokes_of(scene, family_)) {
        for (std::size_t k = 0; k < strokes_.size(); ++k)
            if (strokes_[k].is_free()) free_.push_back(k);
    }

    [[nodiscard]] Solution run() {
        const Stopwatch watch;
        cases_.push_back(solved(std::vector(free_.size(), StrokeDirection::open), nullptr));
        if (cases_.front().leaves < 0) return std::move(cases_.front().solution);
        branch_and_bound(cases_, {[this](const Case& part) { return is_closed(part); },
                                  [this](const Case&) { return !control_.ending(); },
                                  [this](const Case& part) { return branches(part); }});
        Solution best = delivered();
        best.seconds_solve = watch.seconds();
        return best;
    }

 private:
    const Scene& scene_;
    const SolveControl& control_;
    MotionFamily family_;
    std::vector<StrokeRange> strokes_;
    std::vector<std::size_t> free_;  ///< those whose displacement is free
    std::vector<Case> cases_;        ///< together they hold everything
    int solves_ = 0;

    /// A case that the given displacements contradict: nothing to solve.
    [[nodiscard]] Case contradicted(Case part, const Case& whole, double apart) const {
        part.solution = whole.solution;
        withdraw_motion(part.solution);
        forget_proof(part.solution.certificate);
        report_contradicted_case(part.solution,
                                 scene_.motion.monotone ? "motion.monotone" : "motion.within_lift", apart);
        take_bound(part, part.solution.certificate);
        return part;
    }

    [[nodiscard]] Case solved(std::vector<StrokeDirection> directions, const Case* whole) {
        Case part;
        describe(part, directions);
        part.directions = directions;
        part.bound = least_objective(scene_.objective);
        const double apart = contradicting_directions(scene_.motion, directions);
        if (whole != nullptr) {
            part.bound = whole->bound;
            part.proof = whole->proof;
            if (apart > contradiction) return contradicted(std::move(part), *whole, apart);
        }
        ++solves_;
        PosedScene posed(scene_, {true, directions});
        KnownSolutions none;
        part.solution = solve_motion({posed, plan_of(posed), control_, none});
        take_bound(part, part.solution.certificate);
        if (!part.solution.motion) return part;
        const std::vector<double> excursions = excursions_of(scene_, family_, part.solution.output_motion());
        double worst = scene_.solver.tolerance;
        for (std::size_t k = 0; k < free_.size(); ++k) {
            if (directions[k] != StrokeDirection::open || excursions[free_[k]] <= worst) continue;
            worst = excursions[free_[k]];
            part.leaves = static_cast<int>(k);
        }
        if (part.leaves < 0) part.leaves = beside_passed_turning_point(part);
        return part;
    }

    /// A free stroke without a direction next to one; −1: none.
    [[nodiscard]] int beside_passed_turning_point(const Case& part) const {
        const int count = static_cast<int>(family_.own_stretches().size());
        for (const std::size_t i :
             passed_turning_points(scene_, family_, part.solution.output_motion(), part.directions))
            for (const int segment : {static_cast<int>(i), (static_cast<int>(i) + count - 1) % count})
                for (std::size_t k = 0; k < free_.size(); ++k)
                    if (strokes_[free_[k]].stretch == segment && part.directions[k] == StrokeDirection::open)
                        return static_cast<int>(k);
        return -1;
    }

    [[nodiscard]] auto best() const { return std::ranges::min_element(cases_, {}, &Case::objective); }

    /// Its own motion leaves no stroke, or one that leaves none is as good as any in the case.
    [[nodiscard]] bool is_closed(const Case& part) const {
        const double least = best()->objective();
        return part.leaves < 0 ||
               (std::isfinite(least) && relative_gap(least, part.bound) <= scene_.solver.wanted_gap());
    }

    [[nodiscard]] std::vector<Case> branches(const Case& whole) {
        std::vector<Case> parts;
        for (const StrokeDirection direction : {StrokeDirection::rises, StrokeDirection::falls}) {
            std::vector<StrokeDirection> directions = whole.directions;
            directions[static_cast<std::size_t>(whole.leaves)] = direction;
            parts.push_back(solved(std::move(directions), &whole));
        }
        return parts;
    }

    void describe(CaseProof& part, const std::vector<StrokeDirection>& directions) const {
        for (std::size_t k = 0; k < free_.size(); ++k) {
            if (directions[k] == StrokeDirection::open) continue;
            const StrokeRange& stroke = strokes_[free_[k]];
            const bool rises = directions[k] == StrokeDirection::rises;
            part.region.push_back(fmt::format("{} {} or rests", stroke.member, rises ? "rises" : "falls"));
            part.parts.push_back({.segment = stroke.stretch, .rises = rises});
        }
    }

    [[nodiscard]] Solution delivered() const {
        const bool found = std::isfinite(best()->objective());
        // Without a motion: of a case that is infeasible, or of one that ended early.
        const auto unsettled = std::ranges::find(cases_, false, &Case::infeasible);
        Solution solution = (found || unsettled == cases_.end() ? best() : unsettled)->solution;
        Certificate& certificate = solution.certificate;
        const Verdict own = certificate.verdict;
        if (!found) withdraw_motion(solution);
        const bool nothing = take_cases(certificate, {cases_.begin(), cases_.end()});
        solution.notes.push_back(fmt::format(
            "the best motion without {} leaves the range of a stroke whose displacement is free; {} solves "
            "with given directions",
            scene_.motion.monotone ? "motion.monotone" : "motion.within_lift", solves_ - 1));
        if (nothing) return solution;
        if (!found) {
            certificate.verdict = Verdict::failed;
            certificate.reason = control_.stopped()  ? Reason::interrupted
                                 : control_.ending() ? Reason::time_limit
                                                     : Reason::no_feasible_point;
        } else if (certificate.gap && *certificate.gap <= scene_.solver.wanted_gap()) {
            certificate.verdict = Verdict::optimal;
            certificate.reason = Reason::none;
        } else if (own == Verdict::optimal) {
            certificate.verdict = Verdict::feasible;
            certificate.reason =
                control_.ending().has_value() ? Reason::time_limit : Reason::free_displacements;
        }
        return solution;
    }
};

}  // namespace

Solution solve_stroke_directions(const Scene& scene, const SolveControl& control) {
    return DirectionSearch(scene, control).run();
}

void take_bound_of_relaxation(Solution& held, const Solution& relaxed) {
    Certificate& certificate = held.certificate;
    const Certificate& other = relaxed.certificate;
    const bool delivered = held.motion && certificate.verdict != Verdict::failed;
    if (!delivered || !other.lower_bound) return;
    if (certificate.lower_bound && *certificate.lower_bound >= *other.lower_bound) return;
    take_bound(certificate, other, held.scene.solver.wanted_gap(held.solver.convex));
    held.solver.proof_source = relaxed.solver.proof_source;
}

}  // namespace camopt
