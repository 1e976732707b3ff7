// SPDX-License-Identifier: MIT
#include "studies/tolerance/tolerance_study.hpp"

#include "studies/delivered/made_limits.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/search/planned_solve.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

constexpr double half = 0.5;

/// One of the tolerances of a scene.
struct OneTolerance {
    std::string key;
    std::function<ToleranceSpec(const ToleranceSpec&, double factor)> times;  ///< the others as they are
};

std::vector<OneTolerance> tolerances_of(const ToleranceSpec& spec) {
    std::vector<OneTolerance> all;
    for (std::size_t order = 0; order < spec.motion.size(); ++order)
        if (spec.motion[order])
            all.push_back({fmt::format("tolerance.{}", motion_tolerance_names[order]),
                           [order](ToleranceSpec own, double factor) {
                               *own.motion[order] *= factor;
                               return own;
                           }});
    for (const auto& entry : spec.numbers)
        all.push_back({"tolerance." + entry.first, [name = entry.first](ToleranceSpec own, double factor) {
                           own.numbers.at(name).size *= factor;
                           return own;
                       }});
    return all;
}

class ToleranceStudy {
 public:
    ToleranceStudy(const Solution& solution, const SolveControl& control)
        : solution_(solution), control_(control), all_(tolerances_of(*solution.scene.tolerance)) {}

    ToleranceReport run() {
        if (solution_.cam) find_deciding();
        const std::optional<double> without = objective_with({}, "the price");
        const double own = solution_.certificate.objective;
        if (!without || !std::isfinite(own) || !(*without > 0.0)) return report_;
        report_.price = (own - *without) / *without;
        find_halved(own);
        find_segments(own - *without, *without);
        return report_;
    }

 private:
    const Solution& solution_;
    const SolveControl& control_;
    std::vector<OneTolerance> all_;
    ToleranceReport report_;

    [[nodiscard]] Scene scene_with(const std::optional<ToleranceSpec>& tolerance) const {
        Scene scene = solution_.scene;
        scene.objective.sought.reset();
        scene.tolerance = tolerance;
        return scene;
    }
    /// None: time is over, or there is no motion; `what` is then open.
    [[nodiscard]] std::optional<double> solved(const Scene& scene, std::string_view what) {
        if (control_.ending()) {
            report_.open.emplace_back(what);
            return std::nullopt;
        }
        const Solution found = solve_without_explaining(scene, control_, nullptr, {.look = true});
        if (found.motion && std::isfinite(found.certificate.objective)) return found.certificate.objective;
        report_.open.emplace_back(what);
        return std::nullopt;
    }
    [[nodiscard]] std::optional<double> objective_with(const std::optional<ToleranceSpec>& tolerance,
                                                       std::string_view what) {
        return solved(scene_with(tolerance), what);
    }

    /// Of each limit the tolerance that alone moves it farthest.
    void find_deciding() {
        std::vector<double> farthest;
        for (const OneTolerance& one : all_) {
            ToleranceSpec alone = *solution_.scene.tolerance;
            for (const OneTolerance& other : all_)
                if (other.key != one.key) alone = other.times(alone, 0.0);
            for (const ConstraintReport& made : made_constraints(solution_, scene_with(alone)))
                note_if_farthest(farthest, made, one.key);
        }
    }
    void note_if_farthest(std::vector<double>& farthest, const ConstraintReport& made,
                          const std::string& tolerance) {
        const auto drawn = std::ranges::find(solution_.constraints, made.key, &ConstraintReport::key);
        if (drawn == solution_.constraints.end()) return;
        const double moved = std::abs(made.worst - drawn->worst);
        const auto own = std::ranges::find(report_.decides, made.key, &ToleranceReport::Decides::limit);
        const auto place = static_cast<std::size_t>(own - report_.decides.begin());
        if (own == report_.decides.end()) {
            if (!(moved > 0.0)) return;
            report_.decides.push_back({made.key, tolerance});
            farthest.push_back(moved);
        } else if (moved > farthest[place]) {
            own->tolerance = tolerance;
            farthest[place] = moved;
        }
    }

    void find_halved(double own) {
        for (const OneTolerance& one : all_)
            if (const auto with = objective_with(one.times(*solution_.scene.tolerance, half),
                                                 fmt::format("half of {}", one.key)))
                report_.halved.push_back({one.key, (own - *with) / own});
    }

    /// Uniform splines with fewer segments than the scene's, without tolerances: bisected, since the
    /// objective falls with the number but for small steps back.
    void find_segments(double price, double without) {
        const SplineSpec& spline = solution_.scene.spline;
        if (!spline.breakpoints.empty() || spline.by_stroke || spline.free_knots) return;
        int few = 1, enough = segments_of(spline);  // `enough` is so; fewer than 2 are not tried
        while (enough - few > 1) {
            const int middle = (few + enough) / 2;
            const auto found =
                solved(with_segments(scene_with({}), middle), fmt::format("a spline of {} segments", middle));
            if (control_.ending()) return;
            (found && *found - without <= price ? enough : few) = middle;
        }
        std::erase_if(report_.open, [](const std::string& one) { return one.starts_with("a spline"); });
        report_.segments_worth = enough;
    }
};

}  // namespace

void report_tolerance(Solution& solution, const SolveControl& control) {
    if (!solution.motion || solution.certificate.verdict == Verdict::infeasible) return;
    solution.tolerance = ToleranceStudy(solution, control).run();
}

}  // namespace camopt
