// SPDX-License-Identifier: MIT
#include "objectives/program_family.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/set_point_conditions.hpp"
#include "scene/scene_error.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// A law whose ends move is joined by splines alone, which take its velocity.
void require_splines_beside(const MotionSpec& motion, std::size_t index) {
    const std::size_t count = motion.segments.size();
    const auto refuse = [&](const std::string& beside) {
        throw SceneError(
            {fmt::format("motion.segments[{}].law", index),
             fmt::format("\"{}\", a law whose ends move, beside {}", motion.segments[index].law, beside),
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
