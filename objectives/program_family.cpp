// SPDX-License-Identifier: MIT
#include "objectives/program_family.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/set_point_conditions.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace camopt {

namespace {

/// A law with moving ends is joined only by splines, which take its velocity.
void require_splines_beside(const MotionSpec& motion, std::size_t index) {
    const std::size_t count = motion.segments.size();
    const auto refuse = [&](const std::string& beside) {
        throw SceneError(
            {fmt::format("motion.segments[{}].law", index),
             fmt::format("\"{}\", a law whose ends move, next to {}", motion.segments[index].law, beside),
             "spline segments on both sides, which join with its velocity"});
    };
    for (const bool after : {false, true}) {
        if (!motion.closed && index == (after ? count - 1 : 0)) refuse("the open end of the program");
        const std::size_t other = (index + (after ? 1 : count - 1)) % count;
        if (motion.segments[other].kind != SegmentKind::spline)
            refuse(fmt::format("motion.segments[{}] of kind \"{}\"", other,
                               name_of(motion.segments[other].kind)));
    }
}

std::shared_ptr<const Motion> law_of_segment(const MotionSpec& motion, std::size_t index) {
    const ProgramSegment& segment = motion.segments[index];
    std::shared_ptr<const Law> law = make_law(segment.law);
    if (!law->info().rests) require_splines_beside(motion, index);
    if (law->info().top == TopEnd::turning_point) {
        throw SceneError({fmt::format("motion.segments[{}].law", index),
                          fmt::format("\"{}\", a law that turns back at its top", segment.law),
                          "a law that ends at rest"});
    }
    return law;
}

}  // namespace

/// Where two splines reverse the motion and both have to stay on their side of the joint, it is a turning
/// point: y' = 0. Imposed as a condition, since inequalities around the joint would be degenerate. At the
/// begin of segment `index`.
bool turns_back(const MotionSpec& motion, std::size_t index) {
    const std::size_t count = motion.segments.size();
    if ((!motion.within_lift && !motion.monotone) || (index == 0 && !motion.closed)) return false;
    const std::size_t before = (index + count - 1) % count;
    /// The displacement at a joint, if the segment that ends there gives it.
    const auto level = [&](std::size_t joint) -> std::optional<double> {
        if (joint == 0 || (joint == count && motion.closed)) return 0.0;
        return motion.segments[joint - 1].to;
    };
    for (const std::size_t i : {before, index}) {
        const std::vector<SetPoint>& via = motion.segments[i].via;
        const auto gives = [](const SetPoint& point) { return point.displacement.has_value(); };
        if (motion.segments[i].kind != SegmentKind::spline || std::ranges::any_of(via, gives)) return false;
    }
    const auto start = level(before), joint = level(before + 1), end = level(index + 1);
    return start && joint && end && (*joint - *start) * (*end - *joint) < 0.0;
}

MotionFamily program_family(const Scene& scene, DesignKind kind) {
    FamilyRequest request;
    request.degree = scene.spline.degree;
    request.continuity = scene.spline.smoothness();
    request.kind = kind;
    request.closed = scene.motion.closed;
    request.end_jerk_zero = scene.spline.end_jerk == EndJerk::zero;
    const double unit = scene.motion.unit_angle();
    const std::vector<PlacedPoint> points = placed_points(scene.motion);
    double angle = 0.0;
    for (std::size_t i = 0; i < scene.motion.segments.size(); ++i) {
        const ProgramSegment& segment = scene.motion.segments[i];
        StretchRequest stretch;
        stretch.begin = angle / unit;
        angle += segment.angle;
        stretch.end = angle / unit;
        stretch.to = segment.to;
        if (segment.kind == SegmentKind::law) {
            stretch.kind = StretchRequest::Kind::shape;
            stretch.shape = law_of_segment(scene.motion, i);
        } else if (segment.kind == SegmentKind::spline) {
            stretch.kind = StretchRequest::Kind::spline;
            stretch.breakpoints = breakpoints_of(scene.spline, stretch.begin, stretch.end,
                                                 regions_of(scene.motion, points, static_cast<int>(i)));
            if (turns_back(scene.motion, i))
                stretch.conditions.push_back(
                    {stretch.begin, 1, Side::right, 0.0,
                     fmt::format("turning point at the start of motion.segments[{}]", i), false});
            for (const PlacedPoint& point : points) {
                if (point.segment != static_cast<int>(i)) continue;
                const auto own = conditions_of(scene.motion, point, scene.spline.degree, stretch.end);
                stretch.conditions.insert(stretch.conditions.end(), own.begin(), own.end());
            }
        }
        request.stretches.push_back(std::move(stretch));
    }
    return MotionFamily::make(request);
}

}  // namespace camopt
