// SPDX-License-Identifier: MIT
#include "objectives/program_family.hpp"

#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// Breakpoints of one spline segment: uniform, or the scene's own in units of the segment.
std::vector<double> segment_breakpoints(const SplineSpec& spline, double begin, double end) {
    std::vector<double> points;
    if (spline.breakpoints.empty()) {
        for (int i = 0; i <= spline.segments; ++i) {
            points.push_back(begin + (end - begin) * static_cast<double>(i) / spline.segments);
        }
    } else {
        for (const double at : spline.breakpoints) points.push_back(begin + (end - begin) * at);
    }
    points.front() = begin;
    points.back() = end;
    return points;
}

std::shared_ptr<const Motion> law_between_dwells(const ProgramSegment& segment, std::size_t index) {
    std::shared_ptr<const Law> law = make_law(segment.law);
    if (law->info().top == TopEnd::turning_point) {
        throw InputError(
            fmt::format("motion.segments[{}].law: found \"{}\", a law that turns back at its top; "
                        "allowed: a law that ends at rest",
                        index, segment.law));
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
            stretch.shape = law_between_dwells(segment, i);
        } else if (segment.kind == SegmentKind::spline) {
            stretch.kind = StretchRequest::Kind::spline;
            stretch.breakpoints = segment_breakpoints(scene.spline, stretch.begin, stretch.end);
        }
        request.stretches.push_back(std::move(stretch));
    }
    return MotionFamily::make(request);
}

}  // namespace camopt
