// SPDX-License-Identifier: MIT
// A scene as an optimization problem: its model, scaled so that its objective is near one, and the options of
// its exchange.
#pragma once

#include "objectives/scene_model.hpp"
#include "solvers/exchange/exchange.hpp"
#include "studies/search/cost_scale.hpp"

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

/// The form of design vector that a scene is solved in; not automatic.
[[nodiscard]] DesignKind design_of(const Scene& scene);

/// Rules that are not convex for every motion: searched from several starts.
[[nodiscard]] bool needs_starts(const CamModel& model);

/// The exchange as a scene sets it up.
[[nodiscard]] ExchangeOptions exchange_options(const Scene& scene);

}  // namespace camopt
