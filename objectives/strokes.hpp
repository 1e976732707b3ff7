// SPDX-License-Identifier: MIT
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
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/motion/set_points.hpp"

namespace camopt {

/// Of a stroke whose displacement is free.
enum class StrokeDirection { open, rises, falls };

struct StrokeRange {
    std::string member;              ///< "motion", "motion.segments[2]"
    int stretch = 0;                 ///< of the family
    double begin = 0.0, end = 0.0;   ///< x
    std::optional<double> from, to;  ///< displacements at its ends, in lifts; none: free
    double least = -infinity,
           most = infinity;                  ///< of its range, in lifts; infinite: open, or the ends are free
    bool has_points = false;                 ///< its set points give a displacement
    int rest_at_begin = 2, rest_at_end = 2;  ///< derivatives up to this order are 0 there, if it rests

    [[nodiscard]] bool is_free() const { return !from || !to; }
};

/// Whether spline.rest holds at that end of a spline segment of a program: it meets a dwell or an open end.
[[nodiscard]] bool meets_rest(const MotionSpec& motion, int segment, bool at_end);

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

/// The rules of motion.within_lift and motion.monotone, named by these keys, and of MotionSpec::reach.
void add_stroke_rules(CamModel& model, const Scene& scene, const HeldStrokes& strokes);

/// Sets model.entry_factors, so that each entry is of order one: y^{(r)} of a stroke of length β and
/// displacement h is about h / β^r times that of a rise of one lift over one unit of x.
void set_entry_factors(CamModel& model, const Scene& scene);

/// How far each stroke of a motion of the family leaves its range, as the largest violation of its rules; of
/// a free one those of the direction that it takes. In the order of strokes_of; 0: not at all.
[[nodiscard]] std::vector<double> excursions_of(const Scene& scene, const MotionFamily& family,
                                                const MotionChain& motion);

}  // namespace camopt
