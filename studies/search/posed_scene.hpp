// SPDX-License-Identifier: MIT
// A scene as the optimization problem that is solved in its place, and the way back.
//
// The problem is the model of the scene in units that leave its cost near one (objectives/cost_units.hpp).
#pragma once

#include "objectives/scene_model.hpp"
#include "solvers/certificate/scale_cost.hpp"
#include "solvers/exchange/exchange.hpp"
#include "studies/delivered/solution.hpp"

namespace camopt {

struct PosedScene {
    /// `asked` outlives it.
    explicit PosedScene(const Scene& asked, HeldStrokes held = {});

    /// The model of the same problem with another form of design vector.
    [[nodiscard]] CamModel model_as(DesignKind kind) const {
        return scene_model(scene, kind, reference, strokes, units);
    }
    /// The solution of the problem becomes that of the scene.
    void restore(Solution& solution) const { scale_cost(solution.certificate, units.cost); }

    const Scene& scene;
    Peaks reference;  ///< what the peaks of the scene are divided by
    HeldStrokes strokes;
    CostUnits units;  ///< of the model
    CamModel model;
};

/// The form of design vector that a scene is solved in; not automatic.
[[nodiscard]] DesignKind design_of(const Scene& scene);

/// Rules that are not convex for every motion: searched from several starts.
[[nodiscard]] bool needs_starts(const CamModel& model);

/// The exchange as a scene sets it up.
[[nodiscard]] ExchangeOptions exchange_options(const Scene& scene);

}  // namespace camopt
