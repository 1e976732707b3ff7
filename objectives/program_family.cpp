// SPDX-License-Identifier: MIT
#include "motions/laws/law_catalogue.hpp"
#include "objectives/scene_model.hpp"
#include "scene/faults/scene_faults.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = StretchRequest::Kind;

bool is_known(const AffineRow& row) {
    return known_displacement(row).has_value();
}

// Of a uniform segment: a breakpoint this close to a region would leave a very short segment between them.
constexpr double sliver = 0.25;
// x: a breakpoint of the scene this close to the end of a region coincides with it.
constexpr double same_breakpoint = 1e-12;

void add_region(std::vector<PointCondition>& all, const PlacedPoint& region, int degree,
                const std::string& name) {
    const auto add = [&](double at, int order, Side side, double value) {
        all.push_back({at, order, side, value, name, true, true});
    };
    const double velocity = *region.wanted[1];
    add(region.begin, 1, Side::right, velocity);
    add(region.begin, 2, Side::right, 0.0);
    add(region.end, 2, Side::left, 0.0);
    if (degree <= 3) return;
    add(region.end, 1, Side::left, velocity);
    add(0.5 * (region.begin + region.end), 1, Side::right, velocity);
}

constexpr double same_velocity = 1e-9;  // of two laws that join, relative

/// y' of a law or a dwell where it ends, or begins, in lifts by the cam angle; none: its displacement is
/// free.
std::optional<double> end_velocity(const MotionSpec& motion, std::size_t index, bool at_end) {
    const ProgramSegment& segment = motion.segments[index];
    double from = 0.0;
    for (std::size_t i = 0; i < index; ++i) from = motion.segments[i].to.value_or(from);
    if (segment.kind == SegmentKind::dwell) return 0.0;
    if (segment.kind != SegmentKind::law || !segment.to) return std::nullopt;
    const std::unique_ptr<Law> law = make_law(segment.law);
    const MotionPoint point = at_end ? law->at(1.0, Side::left) : law->at(0.0, Side::right);
    return (*segment.to - from) * point.derivative[1] / segment.angle;
}

/// An end that moves is joined by a spline, which takes its velocity, by a law of the same velocity, or
/// stands where a motion begins or ends.
void require_splines_beside(const MotionSpec& motion, std::size_t index) {
    const std::size_t count = motion.segments.size();
    const auto refuse = [&](const std::string& beside) {
        throw SceneError(
            {fmt::format("motion.segments[{}].law", index),
             fmt::format("\"{}\", a law whose ends move, next to {}", motion.segments[index].law, beside),
             "spline segments next to it, which join with its velocity, or a law that has it"});
    };
    for (const bool after : {false, true}) {
        const bool outer = index == (after ? count - 1 : 0);
        if (outer && !motion.periodic()) continue;
        const std::size_t other = (index + (after ? 1 : count - 1)) % count;
        if (motion.segments[other].kind == SegmentKind::spline) continue;
        const auto own = end_velocity(motion, index, after), next = end_velocity(motion, other, !after);
        const bool goes_on =
            own && next &&
            std::abs(*own - *next) <= same_velocity * std::max(std::abs(*own), std::abs(*next));
        if (!goes_on)
            refuse(fmt::format("motion.segments[{}] of kind \"{}\"{}", other,
                               name_of(motion.segments[other].kind),
                               own && next && *next != 0.0 ? " with another velocity" : ""));
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

std::array<double, 2> known_range(const MotionFamily& family) {
    std::array<double, 2> range{};
    for (const MotionFamily::Stretch& stretch : family.own_stretches()) {
        const std::optional<double> to = known_displacement(stretch.to);
        if (!to) continue;
        range[0] = std::min(range[0], *to);
        range[1] = std::max(range[1], *to);
    }
    return range;
}

FreeDisplacements free_displacements(const Scene& scene, const MotionFamily& family) {
    FreeDisplacements free;
    if (scene.motion.type != MotionType::program) return free;
    const std::span<const MotionFamily::Stretch> stretches = family.own_stretches();
    const int count = static_cast<int>(stretches.size());
    std::vector<bool> open(stretches.size() + 1,
                           false);  // levels next to a spline whose displacement is free
    for (int i = 0; i < count; ++i) {
        const MotionFamily::Stretch& stretch = stretches[static_cast<std::size_t>(i)];
        if (stretch.kind != Kind::spline || (is_known(stretch.from) && is_known(stretch.to))) continue;
        open[static_cast<std::size_t>(i)] = open[static_cast<std::size_t>(i) + 1] = true;
    }
    for (int i = count - 1; i >= 0; --i)  // a dwell passes its level back to the segment before it
        if (stretches[static_cast<std::size_t>(i)].kind == Kind::dwell &&
            open[static_cast<std::size_t>(i) + 1])
            open[static_cast<std::size_t>(i)] = true;
    for (int i = 0; i < count; ++i) {
        const MotionFamily::Stretch& stretch = stretches[static_cast<std::size_t>(i)];
        if (stretch.kind != Kind::dwell && open[static_cast<std::size_t>(i) + 1] && !is_known(stretch.to))
            free.joints.push_back(i + 1);
    }
    const auto [least, most] = known_range(family);
    const double span = std::max(1.0, most - least);
    free.least = least - span;
    free.most = most + span;
    return free;
}

std::vector<PointCondition> conditions_of(const MotionSpec& motion, const PlacedPoint& point, int degree,
                                          double end) {
    std::vector<PointCondition> conditions;
    const Side side = point.begin < end ? Side::right : Side::left;
    for (int order = 0; order < 3; ++order) {
        const std::optional<double>& value = point.wanted[static_cast<std::size_t>(order)];
        if (!value) continue;
        const std::string name = words_of(motion, point, order);
        if (point.is_region() && order == 1)
            add_region(conditions, point, degree, name);
        else
            conditions.push_back({point.begin, order, side, *value, name});
    }
    return conditions;
}

std::vector<std::array<double, 2>> regions_of(const MotionSpec& motion,
                                              const std::vector<PlacedPoint>& points, int segment) {
    std::vector<std::array<double, 2>> regions;
    const double length = motion.length();
    for (const PlacedPoint& point : points) {
        if (point.segment != segment || !point.is_region()) continue;
        regions.push_back({point.begin, point.end});
        if (motion.symmetric) regions.push_back({length - point.end, length - point.begin});
    }
    return regions;
}

std::vector<double> breakpoints_of(const SplineSpec& spline, double begin, double end,
                                   const std::vector<std::array<double, 2>>& regions) {
    std::vector<double> points;
    const double width = end - begin;
    if (spline.breakpoints.empty()) {
        for (int i = 0; i <= spline.segments; ++i)
            points.push_back(begin + width * static_cast<double>(i) / spline.segments);
        points.front() = begin;
        points.back() = end;
        return with_regions(std::move(points), regions, sliver * width / spline.segments);
    }
    const double unit = width / (spline.breakpoints.back() - spline.breakpoints.front());
    for (const double at : spline.breakpoints)
        points.push_back(begin + unit * (at - spline.breakpoints.front()));
    points.front() = begin;
    points.back() = end;
    return with_regions(std::move(points), regions, same_breakpoint);
}

/// Where two splines reverse the motion and both have to stay on their side of the joint, it is a turning
/// point: y' = 0. Imposed as a condition, since inequalities around the joint would be degenerate. At the
/// begin of segment `index`.
bool turns_back(const MotionSpec& motion, std::size_t index) {
    const std::size_t count = motion.own_segments();
    if ((!motion.within_lift && !motion.monotone) || (index == 0 && !motion.closed)) return false;
    const std::size_t before = (index + count - 1) % count;
    /// The displacement at a joint, if the segment that ends there, or before the dwells there, gives it.
    const auto level = [&](std::size_t joint) -> std::optional<double> {
        if (joint == count && motion.closed) return 0.0;
        while (joint > 0 && motion.segments[joint - 1].kind == SegmentKind::dwell) --joint;
        if (joint == 0) return 0.0;
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
    const MotionSpec& motion = scene.motion;
    request.closed = motion.closed;
    request.relative = motion.relative;
    request.repeat = motion.repeat;
    request.start = end_velocities(motion, false);
    request.end = end_velocities(motion, true);
    request.end_jerk_zero = scene.spline.end_jerk == EndJerk::zero;
    const double unit = scene.motion.unit_angle();
    const std::vector<PlacedPoint> points = placed_points(scene.motion);
    double angle = 0.0;
    for (std::size_t i = 0; i < scene.motion.own_segments(); ++i) {
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
