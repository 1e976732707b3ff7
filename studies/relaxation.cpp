// SPDX-License-Identifier: MIT
#include "studies/relaxation.hpp"

#include "objectives/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "solvers/elastic.hpp"
#include "studies/adjustment.hpp"
#include "studies/solve_without_explaining.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

// A value is found to this part of itself; a solve with that much to spare is feasible.
constexpr double value_accuracy = 1e-8;
constexpr int most_doublings = 24;
constexpr int most_root_steps = 60;

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

/// The least common violation over all motions (and dimensions) of a scene; <= 0: it is feasible. Infinite
/// where the cam cannot be built. For limits that are not convex it is what one search found.
double least_violation(const Scene& scene, const SolveControl& control) {
    if (find_fault(scene)) return infinity;
    CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
    const Candidate start = judged(problem, problem.start());
    if (start.violation <= 0.0) return start.violation;
    ExchangeOptions options;
    options.tolerance = options.backend.tolerance = scene.solver.tolerance;
    options.backend.max_seconds = scene.solver.max_seconds;
    const Feasibility found = find_feasible(problem, options, control);
    return found.point.x.size() > 0 ? found.point.violation : infinity;
}

class ValueSearch {
 public:
    ValueSearch(const Adjustment& adjustment, const SolveControl& control)
        : adjustment_(adjustment), control_(control) {}

    /// The nearest feasible value in one direction, ±1.
    [[nodiscard]] std::optional<double> nearest(int direction) const {
        double inside = adjustment_.given;  // of the infeasible part
        double violation = violation_at(inside);
        double step = adjustment_.step;
        for (int k = 0; k < most_doublings && !control_.stopped(); ++k, step *= 2.0) {
            const double end = direction > 0 ? adjustment_.most : adjustment_.least;
            double next = adjustment_.given + direction * step;
            const bool last = direction > 0 ? next >= end : next <= end;
            if (last) next = end;
            const double there = violation_at(next);
            if (there <= 0.0) return between(inside, violation, next, there);
            if (last) return {};
            inside = next;
            violation = there;
        }
        return {};
    }

 private:
    const Adjustment& adjustment_;
    const SolveControl& control_;

    [[nodiscard]] double violation_at(double value) const {
        return least_violation(adjustment_.with(value), control_);
    }

    /// The boundary between an infeasible and a feasible value, from the feasible side.
    [[nodiscard]] double between(double outside, double violation, double inside, double slack) const {
        const double accuracy = value_accuracy * std::max(std::abs(inside), adjustment_.step);
        for (int k = 0; k < most_root_steps && std::abs(inside - outside) > accuracy; ++k) {
            if (control_.stopped()) break;
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

std::optional<double> needed_value(const Adjustment& adjustment, const SolveControl& control) {
    const ValueSearch search(adjustment, control);
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
    std::vector<Relaxation> found;
    for (const LimitedPeak& one : limited_peaks) {
        const std::optional<PeakLimit>& limit = scene.limits.*one.limit;
        if (!limit || scene.motion.type == MotionType::program) continue;
        Relaxation relaxation{limit->key, limit->given, {}};
        const Solution least = solve_without_explaining(without_limit(scene, one), control);
        if (least.motion) {
            relaxation.needed = (least.peaks.*one.peak).value * limit->unit_per_normalised();
        }
        found.push_back(std::move(relaxation));
    }
    if (!scene.cam) return found;
    for (const Adjustment& adjustment : adjustments(scene)) {
        if (control.stopped()) break;
        found.push_back({adjustment.key, adjustment.given, needed_value(adjustment, control)});
    }
    return found;
}

}  // namespace camopt
