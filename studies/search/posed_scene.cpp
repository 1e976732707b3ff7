// SPDX-License-Identifier: MIT
#include "studies/search/posed_scene.hpp"

#include "studies/measured/measured_fit.hpp"

namespace camopt {

namespace {

// Of a problem whose residual vibration is limited (a cone), relative to the scene's tolerance, and the
// tightest that double precision carries.
constexpr double cone_tolerance = 1e-2, least_tolerance = 1e-12;

}  // namespace

DesignKind design_of(const Scene& scene) {
    if (scene.spline.design != DesignKind::automatic) return scene.spline.design;
    // NLopt works on dense matrices and handles equalities badly: fewest variables, ends built in.
    return scene.solver.name.starts_with("nlopt.") ? DesignKind::coefficients : DesignKind::states;
}

bool needs_starts(const CamModel& model) {
    return std::ranges::any_of(model.rules, [](const PlacedRule& rule) {
        return rule->curvature(-infinity, infinity) == Curvature::general;
    });
}

PosedScene::PosedScene(const Scene& asked, HeldStrokes held)
    : scene(asked),
      reference(reference_peaks(asked)),
      strokes(std::move(held)),
      units(cost_units(asked, reference)),
      model(model_as(design_of(asked))) {
    const bool measured = scene.measured && scene.measured->start && !searches_angles(scene);
    if (measured && model.design.contradictions().empty())
        model.start_design = nearest_design(model.design, scene);
}

ExchangeOptions exchange_options(const Scene& scene) {
    ExchangeOptions options;
    options.tolerance = scene.solver.tolerance;
    options.backend.tolerance = scene.solver.tolerance;
    options.backend.max_seconds = scene.solver.max_seconds;
    options.backend.native = scene.solver.options;
    // A point just outside is drawn to one well inside, which costs its violation times their distance;
    // tangents of a cone always leave it just outside, and a few more of them cost little.
    if (scene.limits.residual) {
        options.tolerance = std::max(cone_tolerance * options.tolerance, least_tolerance);
        options.backend.tolerance = options.tolerance;
    }
    return options;
}

}  // namespace camopt
