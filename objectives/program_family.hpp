// SPDX-License-Identifier: MIT
// A program of segments as a family of motions: x = cam angle / angle of the first spline segment, y in
// lifts.
#pragma once

#include "objectives/strokes.hpp"

namespace camopt {

/// Segments of a program that begin with a turning point: both strokes there are splines that have to stay on
/// their side of it. of_free: HeldStrokes::directions.
[[nodiscard]] std::vector<std::size_t> turning_segments(const MotionSpec& motion,
                                                        const std::vector<StrokeDirection>& of_free);

/// By how much (lifts) the given displacements are too far apart for these directions of the free strokes:
/// from 1 no motion rises, and then rises again, to 0. 0: they are not.
[[nodiscard]] double contradicting_directions(const MotionSpec& motion,
                                              const std::vector<StrokeDirection>& of_free);

/// What V, A and J of each segment are measured by (objective.peaks):
///   strokes: angle and displacement of its stroke. A stroke is a spline, or several between given
///            displacements that join in motion: it begins after a dwell or a law, where the motion turns
///            back, beside a spline that stands or ends at a free displacement, at an `end` of velocity 0 and
///            where the motion begins. Measured by the lift where its displacement is 0 or free. Each spline
///            where there is no such place, and in a relative motion of splines alone. Laws and dwells: their
///            own.
///   motion:  all by the lift and the unit angle.
/// One a segment; none: DRD and RR, all 1.
[[nodiscard]] std::vector<StretchScale> peak_scales(const Scene& scene);

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
//           multiple of (x − a)²(b − x)²; the middle makes that multiple 0),
//   p = 7:  these and y'''(a) = y'''(b) = 0, in the same way with triple zeros.
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

}  // namespace camopt
