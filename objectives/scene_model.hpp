// SPDX-License-Identifier: MIT
// From a scene to the optimization model: its family of motions, the weighted or capped peaks, the
// references.
#pragma once

#include "objectives/cost_units.hpp"
#include "objectives/scene_family.hpp"

namespace camopt {

/// The peaks (and root mean squares) the objective divides by: those of the reference law, or the given
/// numbers. Throws InputError where a positive weight meets an infinite or a missing one.
[[nodiscard]] Peaks reference_peaks(const Scene& scene);

/// What the objective divides the cam's dimensions by: the lift; for a swinging output the lift times a
/// length of the cam, for an oscillating follower the centre distance. m; the scene must have a cam with its
/// formulas.
[[nodiscard]] double dimension_unit(const Scene& scene);

/// The factor of a dimension of the scene's cam in the objective: its weight (under its name for disk cams)
/// over the unit. 0: none.
[[nodiscard]] double dimension_weight(const Scene& scene, const std::string& name);

/// Only peaks with a weight or a limit become variables. A program's peaks are the largest over its spline
/// segments, normalised as peak_scales says.
/// `strokes`: whether rules enforce their range (add_stroke_rules). Cost and peaks are in `units`.
[[nodiscard]] CamModel scene_model(const Scene& scene, DesignKind kind, const Peaks& reference,
                                   const HeldStrokes& strokes = {}, const CostUnits& units = {});

/// The motions over which a retained rule must be convex.
enum class ConvexOver {
    every_motion,    ///< for any displacements: proofs need nothing else
    sensible_motion  ///< for the displacements that CamModel expects: a proof needs bounds on them too
};

/// The model without the rules that are not convex there: a convex relaxation.
[[nodiscard]] CamModel convex_part(const CamModel& model, ConvexOver range);

}  // namespace camopt
