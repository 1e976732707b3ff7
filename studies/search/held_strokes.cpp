// SPDX-License-Identifier: MIT
#include "studies/search/held_strokes.hpp"

#include "scene/cost_table.hpp"
#include "studies/delivered/delivered_audit.hpp"
#include "studies/search/settled_scene.hpp"
#include "studies/search/solve_motion.hpp"
#include "studies/search/stroke_excursions.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double contradiction = 1e-6;  // lifts: less is left to the solver, whose tolerance may allow it

/// Some directions given, and the best motion with them.
struct Case {
    std::vector<StrokeDirection> directions;
    Solution solution;
    double bound = -infinity;
    std::shared_ptr<const DualityProof> proof = {};
    int leaves = -1;  ///< the open stroke that leaves its range most, −1: none does

    [[nodiscard]] bool infeasible() const { return solution.certificate.verdict == Verdict::infeasible; }
    [[nodiscard]] double objective() const {
        if (!solution.motion) return infinity;
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
        while (!control_.ending()) {
            const auto next = std::ranges::min_element(cases_, [&](const Case& one, const Case& other) {
                if (is_open(one) != is_open(other)) return is_open(one);
                return one.bound < other.bound;
            });
            if (!is_open(*next)) break;
            split(next);
        }
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
    [[nodiscard]] Case contradicted(std::vector<StrokeDirection> directions, const Case& whole,
                                    double apart) const {
        Case part{std::move(directions), whole.solution};
        withdraw_motion(part.solution);
        forget_proof(part.solution.certificate);
        report_contradicted_case(part.solution,
                                 scene_.motion.monotone ? "motion.monotone" : "motion.within_lift", apart);
        part.proof = std::make_shared<DualityProof>(*part.solution.certificate.proof);
        return part;
    }

    [[nodiscard]] Case solved(std::vector<StrokeDirection> directions, const Case* whole) {
        const double apart = contradicting_directions(scene_.motion, directions);
        if (whole != nullptr && apart > contradiction)
            return contradicted(std::move(directions), *whole, apart);
        ++solves_;
        Case part{directions, solve_with_strokes(scene_, {true, directions}, control_)};
        part.bound = least_objective(scene_.objective);
        const Certificate& certificate = part.solution.certificate;
        if (whole != nullptr) {
            part.bound = whole->bound;
            part.proof = whole->proof;
        }
        const bool better = certificate.lower_bound && *certificate.lower_bound >= part.bound;
        if (better) part.bound = *certificate.lower_bound;
        if (certificate.proof && (better || part.infeasible()))
            part.proof = std::make_shared<DualityProof>(*certificate.proof);
        if (!part.solution.motion) return part;
        const std::vector<double> excursions = excursions_of(scene_, family_, *part.solution.motion);
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
             passed_turning_points(scene_, family_, *part.solution.motion, part.directions))
            for (const int segment : {static_cast<int>(i), (static_cast<int>(i) + count - 1) % count})
                for (std::size_t k = 0; k < free_.size(); ++k)
                    if (strokes_[free_[k]].stretch == segment && part.directions[k] == StrokeDirection::open)
                        return static_cast<int>(k);
        return -1;
    }

    [[nodiscard]] double best_objective() const {
        double best = infinity;
        for (const Case& part : cases_)
            if (part.leaves < 0) best = std::min(best, part.objective());
        return best;
    }

    /// Its own motion leaves a stroke, and one that does not may be better than the best.
    [[nodiscard]] bool is_open(const Case& part) const {
        const double best = best_objective();
        return part.leaves >= 0 &&
               (!std::isfinite(best) || relative_gap(best, part.bound) > scene_.solver.wanted_gap());
    }

    void split(std::vector<Case>::iterator at) {
        const Case whole = std::move(*at);
        cases_.erase(at);
        for (const StrokeDirection direction : {StrokeDirection::rises, StrokeDirection::falls}) {
            std::vector<StrokeDirection> directions = whole.directions;
            directions[static_cast<std::size_t>(whole.leaves)] = direction;
            cases_.push_back(solved(std::move(directions), &whole));
        }
    }

    [[nodiscard]] CaseProof proof_of(const Case& part) const {
        std::vector<std::string> region;
        for (std::size_t k = 0; k < free_.size(); ++k)
            if (part.directions[k] != StrokeDirection::open)
                region.push_back(fmt::format(
                    "{} {}", strokes_[free_[k]].member,
                    part.directions[k] == StrokeDirection::rises ? "rises or rests" : "falls or rests"));
        return {std::move(region), part.bound, part.infeasible(), part.proof};
    }

    [[nodiscard]] Solution delivered() const {
        const auto best = std::ranges::min_element(
            cases_, {}, [](const Case& part) { return part.leaves < 0 ? part.objective() : infinity; });
        const bool found = best->leaves < 0 && best->solution.motion;
        const bool nothing = std::ranges::all_of(cases_, &Case::infeasible);
        // Without a motion: of a case that is infeasible, or of one that ended early.
        const Case& chosen = found || nothing ? *best : *std::ranges::find_if(cases_, [](const Case& part) {
            return !part.infeasible();
        });
        Solution solution = chosen.solution;
        Certificate& certificate = solution.certificate;
        const Certificate own = certificate;
        forget_proof(certificate);
        certificate.cases.clear();
        certificate.proof_kind = ProofKind::boxes;
        double bound = infinity;
        for (const Case& part : cases_) {
            certificate.cases.push_back(proof_of(part));
            if (!part.infeasible()) bound = std::min(bound, part.bound);
        }
        solution.notes.push_back(fmt::format(
            "the best motion without {} leaves the range of a stroke whose displacement is free; {} solves "
            "with given directions",
            scene_.motion.monotone ? "motion.monotone" : "motion.within_lift", solves_ - 1));
        if (!found) {
            if (nothing) return solution;
            withdraw_motion(solution);
            certificate.verdict = Verdict::failed;
            certificate.reason = control_.stopped()  ? Reason::interrupted
                                 : control_.ending() ? Reason::time_limit
                                                     : Reason::no_feasible_point;
            return solution;
        }
        if (std::isfinite(bound)) {
            certificate.lower_bound = std::min(bound, certificate.objective);
            certificate.gap = relative_gap(certificate.objective, *certificate.lower_bound);
        }
        if (certificate.gap && *certificate.gap <= scene_.solver.wanted_gap()) {
            certificate.verdict = Verdict::optimal;
            certificate.reason = Reason::none;
        } else if (own.verdict == Verdict::optimal) {
            certificate.verdict = Verdict::feasible;
            certificate.reason =
                control_.ending().has_value() ? Reason::time_limit : Reason::free_displacements;
        }
        return solution;
    }
};

}  // namespace

Solution solve_held_strokes(const Scene& scene, const SolveControl& control) {
    return DirectionSearch(scene, control).run();
}

void take_bound_of_relaxation(Solution& held, const Solution& relaxed) {
    Certificate& certificate = held.certificate;
    const Certificate& other = relaxed.certificate;
    const bool delivered = held.motion && certificate.verdict != Verdict::failed;
    if (!delivered || !other.lower_bound) return;
    if (certificate.lower_bound && *certificate.lower_bound >= *other.lower_bound) return;
    certificate.lower_bound = std::min(*other.lower_bound, certificate.objective);
    certificate.gap = relative_gap(certificate.objective, *certificate.lower_bound);
    certificate.proof_kind = other.proof_kind;
    certificate.proof = other.proof;
    certificate.cases = other.cases;
    certificate.box_proof = other.box_proof;
    held.solver.proof_source = relaxed.solver.proof_source;
    if (*certificate.gap > held.scene.solver.wanted_gap(held.solver.convex)) return;
    certificate.verdict = Verdict::optimal;
    certificate.reason = Reason::none;
}

}  // namespace camopt
