// SPDX-License-Identifier: MIT
// Executes the plan of a scene (plan.hpp), without the explanation of an infeasible one.
#pragma once

#include "objectives/scene_model.hpp"
#include "solvers/exchange/exchange.hpp"
#include "studies/search/cost_scale.hpp"
#include "studies/search/known_solutions.hpp"
#include "studies/search/plan.hpp"

namespace camopt {

/// A scene as it is solved, its objective near one, with its model. `given` outlives it.
struct PosedScene {
    explicit PosedScene(const Scene& scene, HeldStrokes held = {});

    [[nodiscard]] const Scene& scene() const { return scale.scaled(); }
    /// What was found for scene() becomes the solution of `given`.
    void restore(Solution& solution) const {
        if (!scale.is_idle()) scale.restore(solution, given, given_reference);
    }

    const Scene& given;
    Peaks given_reference;
    CostScale scale;
    Peaks reference;  ///< what the peaks of scene() are divided by
    HeldStrokes strokes;
    CamModel model;
};

/// The plan of a scene that was validated (plan.cpp).
[[nodiscard]] SolvePlan plan_of(const PosedScene& posed, const PlanOptions& options = {});

/// Rules that are not convex for every motion: searched from several starts.
[[nodiscard]] bool needs_starts(const CamModel& model);

/// The exchange as a scene sets it up.
[[nodiscard]] ExchangeOptions exchange_options(const Scene& scene);

/// Part of the time for a backend that another one follows.
inline constexpr double share_of_first = 0.5;

/// What takes part in a solve for given angles and breakpoints.
struct PlannedRun {
    PosedScene& posed;  ///< its model is moved from
    const SolvePlan& plan;
    const SolveControl& control;
    KnownSolutions& known;
    /// Not null: a relaxation that settles the whole but leaves its strokes ends the solve and sets this. The
    /// caller then holds the strokes; what is returned has no motion but the bound of the relaxation.
    bool* leaves_strokes = nullptr;
};

/// As solve() (studies/solve/solve.hpp), but infeasible scenes are not explained. `known`: of the scene
/// solved before, and then of this one; null: none. A look is not audited.
[[nodiscard]] Solution solve_without_explaining(const Scene& given, const SolveControl& control,
                                                KnownSolutions* known = nullptr,
                                                const PlanOptions& options = {});

/// Reports the motion and the cam of the least common violation in an infeasible solution that has none; not
/// of conditions that contradict, nor of searched angles and breakpoints, nor after the time. Whether it has
/// one now.
bool show_nearest(Solution& solution, const SolveControl& control);

/// The same of a complete scene inside a search: neither validated nor audited.
[[nodiscard]] Solution solve_planned(const Scene& scene, const SolveControl& control,
                                     KnownSolutions* known = nullptr, const PlanOptions& options = {});

/// The best motion for given angles and breakpoints, with the strokes of the posed scene held or not.
[[nodiscard]] Solution solve_motion(const PlannedRun& run);

/// The same with rules for the strokes of a scene whose objective is near one.
[[nodiscard]] Solution solve_with_strokes(const Scene& scene, const HeldStrokes& strokes,
                                          const SolveControl& control);

}  // namespace camopt
