// SPDX-License-Identifier: MIT
#include "studies/relaxation.hpp"

#include "objectives/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/elastic.hpp"
#include "solvers/structured/structured_solver.hpp"
#include "studies/adjustment.hpp"
#include "studies/rest_conflict.hpp"
#include "studies/solve_without_explaining.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace camopt {

namespace {

// A value is found to this part of itself; a solve with that much to spare is feasible.
constexpr double value_accuracy = 1e-8;
constexpr int most_doublings = 24;
constexpr int most_root_steps = 60;
constexpr int most_rounds = 40;

struct LimitedPeak {
    std::optional<PeakLimit> LimitSpec::*limit;
    double ObjectiveSpec::*weight;
    Extremum Peaks::*peak;
};

constexpr std::array<LimitedPeak, 3> limited_peaks = {{
    {&LimitSpec::velocity, &ObjectiveSpec::velocity, &Peaks::velocity},
    {&LimitSpec::acceleration, &ObjectiveSpec::acceleration, &Peaks::acceleration},
    {&LimitSpec::jerk, &ObjectiveSpec::jerk, &Peaks::jerk},
}};

/// The scene that asks for the least of one limited peak and keeps every other limit.
Scene without_limit(const Scene& scene, const LimitedPeak& one) {
    Scene relaxed = scene;
    (relaxed.limits.*one.limit).reset();
    relaxed.objective = {};
    relaxed.objective.*one.weight = 1.0;
    relaxed.objective.tie_break = TieBreak::none;
    relaxed.solver.name = "auto";
    relaxed.solver.options.clear();
    return relaxed;
}

/// Seconds left for the whole explanation, and the user's wish to stop.
class Budget {
 public:
    explicit Budget(const SolveControl& control) : control_(control) {}
    [[nodiscard]] bool spent() const { return control_.ending().has_value(); }
    [[nodiscard]] const SolveControl& control() const { return control_; }

 private:
    const SolveControl& control_;
};

/// Whether t* of the model is above zero: at most so many exchange rounds as that needs, since a grid's t is
/// a bound from below and a judged motion's one from above. The value is whichever of the two decided.
double least_violation(const CamModel& model, double tolerance, const Budget& budget) {
    CamProblem problem(model);
    const Candidate start = judged(problem, problem.start());
    if (start.violation <= 0.0) return start.violation;
    ElasticProblem elastic(problem);
    const std::unique_ptr<Solver> solver = make_structured_solver();
    Eigen::VectorXd x = elastic.start();
    double violation = start.violation;
    for (int round = 0; round < most_rounds && !budget.spent(); ++round) {
        BackendOptions options;
        options.tolerance = tolerance;
        const BackendResult result = solver->minimize(elastic.grid(), x, options, budget.control());
        if (result.x.size() == 0 || !result.x.allFinite()) break;
        const double on_grid = result.x[result.x.size() - 1];
        if (on_grid > tolerance) return on_grid;
        const Candidate found = judged(problem, result.x.head(result.x.size() - 1));
        violation = std::min(violation, found.violation);
        if (violation <= 0.0) return violation;
        std::vector<Violation> worst = elastic.violations(result.x, 0.0);
        if (worst.empty() || elastic.refine(worst) == 0) break;
        x = elastic.completed(result.x);
    }
    return violation <= tolerance ? 0.0 : violation;
}

/// <= 0: the scene is feasible. Infinite where the cam cannot be built. The limits that are linear or convex
/// come first: they are quick, and may settle it. For the others it is what one search found.
double least_violation(const Scene& scene, const Budget& budget) {
    if (find_fault(scene)) return infinity;
    const CamModel model = scene_model(scene, DesignKind::states, reference_peaks(scene));
    if (const auto rest = rest_conflict(model, scene.solver.tolerance)) return rest->violation;
    const CamModel convex = convex_part(model, ConvexOver::every_motion);
    const double tolerance = scene.solver.tolerance;
    const double necessary = least_violation(convex, tolerance, budget);
    if (necessary > 0.0 || convex.rules.size() == model.rules.size()) return necessary;
    return least_violation(model, tolerance, budget);
}

class ValueSearch {
 public:
    /// given: the least violation of the scene as it is.
    ValueSearch(const Adjustment& adjustment, double given, const Budget& budget)
        : adjustment_(adjustment), given_(given), budget_(budget) {}

    /// The nearest feasible value in one direction, ±1.
    [[nodiscard]] std::optional<double> nearest(int direction) const {
        double outside = adjustment_.given;  // still infeasible
        double violation = given_;
        double step = adjustment_.step;
        for (int k = 0; k < most_doublings && !budget_.spent(); ++k, step *= 2.0) {
            const double end = direction > 0 ? adjustment_.most : adjustment_.least;
            double next = adjustment_.given + direction * step;
            const bool last = direction > 0 ? next >= end : next <= end;
            if (last) next = end;
            const double there = violation_at(next);
            if (there <= 0.0) return between(outside, violation, next, there);
            if (last) return {};
            outside = next;
            violation = there;
        }
        return {};
    }

 private:
    const Adjustment& adjustment_;
    double given_;
    const Budget& budget_;

    [[nodiscard]] double violation_at(double value) const {
        return least_violation(adjustment_.with(value), budget_);
    }

    /// The boundary between an infeasible and a feasible value, from the feasible side.
    [[nodiscard]] double between(double outside, double violation, double inside, double slack) const {
        const double accuracy = value_accuracy * std::max(std::abs(inside), adjustment_.step);
        for (int k = 0; k < most_root_steps && std::abs(inside - outside) > accuracy; ++k) {
            if (budget_.spent()) break;
            double value = 0.5 * (inside + outside);
            // A slack of zero stands for all slack (a start that already keeps everything has its own).
            const bool usable = std::isfinite(violation) && slack < 0.0 && k % 3 != 2;
            if (usable) value = inside + (outside - inside) * slack / (slack - violation);
            value = std::clamp(value, std::min(inside, outside) + 0.1 * accuracy,
                               std::max(inside, outside) - 0.1 * accuracy);
            const double there = violation_at(value);
            if (there <= 0.0) {
                inside = value;
                slack = there;
            } else {
                outside = value;
                violation = there;
            }
        }
        return inside;
    }
};

std::optional<double> needed_value(const Adjustment& adjustment, double given, const Budget& budget) {
    const ValueSearch search(adjustment, given, budget);
    std::optional<double> nearest;
    for (const int direction : {1, -1}) {
        if (!(direction > 0 ? adjustment.may_grow : adjustment.may_shrink)) continue;
        const std::optional<double> found = search.nearest(direction);
        const bool nearer = found && (!nearest || std::abs(*found - adjustment.given) <
                                                      std::abs(*nearest - adjustment.given));
        if (nearer) nearest = found;
    }
    return nearest;
}

}  // namespace

std::vector<Relaxation> relaxations(const Scene& scene, const SolveControl& control) {
    const SolveControl timed = control.sooner(scene.solver.max_seconds);
    std::vector<Relaxation> found;
    for (const LimitedPeak& one : limited_peaks) {
        const std::optional<PeakLimit>& limit = scene.limits.*one.limit;
        if (!limit || scene.motion.type == MotionType::program) continue;
        Relaxation relaxation{limit->key, limit->given, {}};
        const Solution least = solve_without_explaining(without_limit(scene, one), timed);
        if (least.motion) {
            relaxation.needed = (least.peaks.*one.peak).value * limit->unit_per_normalised();
        }
        found.push_back(std::move(relaxation));
    }
    if (!scene.cam && !scene.mechanism) return found;
    const Budget budget(timed);
    const double given = least_violation(scene, budget);
    for (const Adjustment& adjustment : adjustments(scene)) {
        const std::optional<double> needed = needed_value(adjustment, given, budget);
        if (budget.spent()) break;  // what was not searched to its end must not pass for "nothing helps"
        found.push_back({adjustment.key, adjustment.given, needed});
    }
    return found;
}

}  // namespace camopt
