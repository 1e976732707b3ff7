// SPDX-License-Identifier: MIT
// From a scene to the optimization model: the strokes of its motion, its family of motions, and the model
// with the weighted or capped peaks and their references.
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/motion/set_points.hpp"

namespace camopt {

// The strokes of a motion, and their range under motion.within_lift and motion.monotone.
//
// A stroke runs from displacement a to b: the rise of DRD; rise and return of RR; each spline segment of a
// program. within_lift: min(a, b, set points) <= y <= max(a, b, set points). A side is open where the motion
// has to leave the range: next to a law that moves outward at the joint, or at a set point on the edge of the
// range that is passed with a velocity, or whose acceleration does not reverse the motion. A spline segment
// that ends where it began is bounded by its set points only. monotone: y' has the sign of b − a, or is 0.
//
// If a program leaves a or b free, the direction of the stroke is unknown: StrokeDirection selects a case,
// and the ends are rows of the design. Such a stroke with displacements at its set points has no range.

/// Of a stroke whose displacement is free.
enum class StrokeDirection { open, rises, falls };

struct StrokeRange {
    std::string member;              ///< "motion", "motion.segments[2]"
    int stretch = 0;                 ///< of the family
    double begin = 0.0, end = 0.0;   ///< x
    std::optional<double> from, to;  ///< displacements at its ends, in lifts; none: free
    double least = -infinity,
           most = infinity;   ///< of its range, in lifts; infinite: open, or the ends are free
    bool has_points = false;  ///< its set points give a displacement

    [[nodiscard]] bool is_free() const { return !from || !to; }
};

/// In the order of the cam angle.
[[nodiscard]] std::vector<StrokeRange> strokes_of(const Scene& scene, const MotionFamily& family);

/// y' = 0 at the set points of a rise or a rise and return on the edge of its range, which follows from
/// motion.within_lift: as inequalities around such a place y <= most would be degenerate.
[[nodiscard]] std::vector<PointCondition> turning_points(const Scene& scene);
/// The same of a spline of a program (its place and its ends; stretch: the segment), beyond both ends.
[[nodiscard]] std::vector<PointCondition> turning_points(const MotionSpec& motion,
                                                         const std::vector<PlacedPoint>& points,
                                                         StrokeRange stroke);

/// Where a set point's derivative equals a limit or the edge of a corridor that it lies inside, the next
/// derivative is 0: as inequalities around such a place they would be degenerate. Of the points of a spline
/// (`segment` −1: of DRD or RR) between `begin` and `end`; scale: of its normalised limits.
[[nodiscard]] std::vector<PointCondition> points_at_limits(const Scene& scene,
                                                           const std::vector<PlacedPoint>& points,
                                                           int segment, const StretchScale& scale);

/// Whether rules enforce the range of the strokes. Most optima satisfy it anyway: they are searched without
/// these rules first, which are active and degenerate wherever a stroke begins or ends.
struct HeldStrokes {
    bool held = false;
    /// One for each free stroke in their order; strokes without a direction (open or missing) are not
    /// bounded.
    std::vector<StrokeDirection> directions = {};
};

/// The rules of motion.within_lift and motion.monotone, named by these keys.
void add_stroke_rules(CamModel& model, const Scene& scene, const HeldStrokes& strokes);

/// Sets model.entry_factors, so that each entry is of order one: y^{(r)} of a stroke of length β and
/// displacement h is about h / β^r times that of a rise of one lift over one unit of x.
void set_entry_factors(CamModel& model, const Scene& scene);

/// How far each stroke of a motion of the family leaves its range, as the largest violation of its rules; of
/// a free one those of the direction that it takes. In the order of strokes_of; 0: not at all.
[[nodiscard]] std::vector<double> excursions_of(const Scene& scene, const MotionFamily& family,
                                                const MotionChain& motion);

// A program of segments as a family of motions: x = cam angle / angle of the first spline segment, y in
// lifts.

/// Segments of a program that begin with a turning point: both strokes there are splines that have to stay on
/// their side of it. of_free: HeldStrokes::directions.
[[nodiscard]] std::vector<std::size_t> turning_segments(const MotionSpec& motion,
                                                        const std::vector<StrokeDirection>& of_free);

/// By how much (lifts) the given displacements are too far apart for these directions of the free strokes:
/// from 1 no motion rises, and then rises again, to 0. 0: they are not.
[[nodiscard]] double contradicting_directions(const MotionSpec& motion,
                                              const std::vector<StrokeDirection>& of_free);

/// of_free: HeldStrokes::directions; joints where they reverse the motion are turning points. Throws
/// InputError for a law that is not allowed in a program (one without a dwell's end).
[[nodiscard]] MotionFamily program_family(const Scene& scene, DesignKind kind,
                                          const std::vector<StrokeDirection>& of_free = {});

// Displacements of a program that the scene leaves free.
//
// A stroke with a free displacement may pass through 0, so its V, A and J are normalised by the lift:
// normalised by its own displacement, a vanishing stroke would cost nothing. A free displacement lies within
// one span beyond the given ones: [least − span, most + span], span = max(1 lift, most − least).
// Displacements in lifts.

struct FreeDisplacements {
    std::vector<int> joints;         ///< joint j: the end of segment j − 1, which moves; free levels
    double least = 0.0, most = 0.0;  ///< range of the levels
};

/// The smallest and the largest of the known displacements and 0.
[[nodiscard]] std::array<double, 2> known_range(const MotionFamily& family);

/// No joints if the displacement of every spline is known, and for DRD and RR.
[[nodiscard]] FreeDisplacements free_displacements(const Scene& scene, const MotionFamily& family);

// Set points and regions of constant velocity as conditions on a spline, and the breakpoints that regions
// need.
//
// On a region [a, b] the motion is one polynomial of degree p, since a and b are breakpoints and there is
// none between. It is y(a) + v (x − a) exactly if
//   p = 3:  y'(a) = v, y''(a) = y''(b) = 0   (y'' is linear, so it vanishes; y' is constant),
//   p = 5:  these, y'(b) = v and y'((a + b)/2) = v   (y' − v is quartic with double zeros at both ends, so a
//           multiple of (x − a)²(b − x)²; the middle makes that multiple 0).
// All of them are linear in the design vector, in any form, and of the order of its entries.

/// `end`: of the motion, x: there a point is seen from the left.
[[nodiscard]] std::vector<PointCondition> conditions_of(const MotionSpec& motion, const PlacedPoint& point,
                                                        int degree, double end);

/// Begin and end of each region of one stretch (segment −1: DRD and RR; with their mirror images where the
/// motion is symmetric), x.
[[nodiscard]] std::vector<std::array<double, 2>> regions_of(const MotionSpec& motion,
                                                            const std::vector<PlacedPoint>& points,
                                                            int segment);

/// The breakpoints of a stretch from `begin` to `end`: uniform or the scene's own, replaced by those of
/// regions where they overlap.
[[nodiscard]] std::vector<double> breakpoints_of(const SplineSpec& spline, double begin, double end,
                                                 const std::vector<std::array<double, 2>>& regions);

// From a scene to the optimization model: the design vector of its motion, the weighted or capped peaks, the
// references.

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

/// The one spline of a DRD or RR scene: its breakpoints, end states, exact points and symmetry.
[[nodiscard]] DesignRequest spline_request(const Scene& scene, DesignKind kind);

/// The motions of the scene, with the given form of design vector (not automatic).
///   DRD: y = y' = y'' = 0 at x = 0, y = 1, y' = y'' = 0 at x = 1.
///   RR:  the same at x = 0, y = y' = y'' = 0 at the end, y(1) = 1, y'(1) = 0.
///   program: program_family.
[[nodiscard]] MotionFamily scene_family(const Scene& scene, DesignKind kind,
                                        const std::vector<StrokeDirection>& of_free = {});

/// Only peaks with a weight or a limit become variables. A program's peaks are the largest over its spline
/// segments, each normalised by its own angle and displacement (the lift where that is 0, or free).
/// `strokes`: whether rules enforce their range (add_stroke_rules).
[[nodiscard]] CamModel scene_model(const Scene& scene, DesignKind kind, const Peaks& reference,
                                   const HeldStrokes& strokes = {});

/// The motions over which a retained rule must be convex.
enum class ConvexOver {
    every_motion,    ///< for any displacements: proofs need nothing else
    sensible_motion  ///< for the displacements that CamModel expects: a proof needs bounds on them too
};

/// The model without the rules that are not convex there: a convex relaxation.
[[nodiscard]] CamModel convex_part(const CamModel& model, ConvexOver range);

}  // namespace camopt
