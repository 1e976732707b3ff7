// SPDX-License-Identifier: MIT
#include "objectives/program_family.hpp"

#include "motions/laws/law.hpp"
#include "objectives/laws/segment_law.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/part_names.hpp"

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
    if (degree <= 5) return;
    add(region.begin, 3, Side::right, 0.0);
    add(region.end, 3, Side::left, 0.0);
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
        const MotionFamily::Stretch& stretch = stretches[i];
        if (stretch.kind != Kind::spline || (is_known(stretch.from) && is_known(stretch.to))) continue;
        open[i] = open[static_cast<std::size_t>(i) + 1] = true;
    }
    for (int i = count - 1; i >= 0; --i)  // a dwell passes its level back to the segment before it
        if (stretches[i].kind == Kind::dwell && open[static_cast<std::size_t>(i) + 1]) open[i] = true;
    for (int i = 0; i < count; ++i) {
        const MotionFamily::Stretch& stretch = stretches[i];
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
        const std::optional<double>& value = point.wanted[order];
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

namespace {

/// Which way each spline segment goes: from one given displacement to another, or a free one as the case
/// says. open: not known, or a free one with set points, which may lead out of its range.
std::vector<StrokeDirection> segment_directions(const MotionSpec& motion,
                                                const std::vector<StrokeDirection>& of_free) {
    const std::vector<std::optional<double>> levels = given_levels(motion);
    std::vector<StrokeDirection> directions(motion.own_segments(), StrokeDirection::open);
    std::size_t free = 0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        if (segment.kind != SegmentKind::spline) continue;
        const bool passes = std::ranges::any_of(
            segment.via, [](const SetPoint& point) { return point.displacement.has_value(); });
        if (!levels[i] || !levels[i + 1]) {
            const StrokeDirection found = free < of_free.size() ? of_free[free++] : StrokeDirection::open;
            if (!passes) directions[i] = found;
        } else if (*levels[i] != *levels[i + 1]) {
            directions[i] = *levels[i] < *levels[i + 1] ? StrokeDirection::rises : StrokeDirection::falls;
        }
    }
    return directions;
}

/// Whether set points of a stroke lead beyond one of its ends: `upper`, or the lower one.
bool leads_beyond(const ProgramSegment& segment, double level, bool upper) {
    constexpr double same_level = 1e-9;  // lifts
    const double sign = upper ? 1.0 : -1.0;
    return std::ranges::any_of(segment.via, [&](const SetPoint& point) {
        if (!point.displacement) return false;
        const double slope = point.velocity.value_or(0.0);
        const double moved = point.is_region() ? slope * (*point.until - point.at) : 0.0;
        const double farthest = std::max(sign * *point.displacement, sign * (*point.displacement + moved));
        // One on the edge of the range leaves it where it moves.
        const bool moves = std::abs(slope) > same_level || point.acceleration.has_value();
        return farthest > sign * level + (moves ? -same_level : same_level);
    });
}

}  // namespace

std::vector<std::size_t> turning_segments(const MotionSpec& motion,
                                          const std::vector<StrokeDirection>& of_free) {
    std::vector<std::size_t> turning;
    if (!motion.within_lift && !motion.monotone) return turning;
    const std::vector<StrokeDirection> directions = segment_directions(motion, of_free);
    const std::vector<std::optional<double>> levels = given_levels(motion);
    const std::size_t count = directions.size();
    for (std::size_t i = motion.periodic() ? 0 : 1; i < count; ++i) {
        const std::size_t before = (i + count - 1) % count;
        if (directions[before] == StrokeDirection::open || directions[i] == StrokeDirection::open ||
            directions[before] == directions[i])
            continue;
        const bool top = directions[before] == StrokeDirection::rises;
        const auto &end = levels[before + 1], &begin = levels[i];  // others where a relative motion goes on
        const bool passed = (end && leads_beyond(motion.segments[before], *end, top)) ||
                            (begin && leads_beyond(motion.segments[i], *begin, top));
        if (!passed) turning.push_back(i);
    }
    return turning;
}

namespace {

/// Whether two strokes of one direction join at the start of a segment with the velocity 0: each keeps to its
/// side of the joint, so that the acceleration is 0 there too.
bool rests_between(const MotionSpec& motion, std::size_t i) {
    if ((i == 0 && !motion.periodic()) || (!motion.within_lift && !motion.monotone)) return false;
    const std::size_t before = i > 0 ? i - 1 : motion.own_segments() - 1;
    const std::optional<SetPoint>& joint = motion.segments[before].end;
    if (!joint || joint->velocity != 0.0 || joint->acceleration) return false;
    const std::vector<std::optional<double>> levels = given_levels(motion);
    const std::vector<StrokeDirection> directions = segment_directions(motion, {});
    if (!levels[i] || !levels[before + 1] || directions[i] == StrokeDirection::open ||
        directions[i] != directions[before])
        return false;
    const bool rises = directions[i] == StrokeDirection::rises;
    return !leads_beyond(motion.segments[before], *levels[before + 1], rises) &&
           !leads_beyond(motion.segments[i], *levels[i], !rises);
}

}  // namespace

namespace {

/// Splines that join in motion, as peak_scales measures them.
class Strokes {
 public:
    explicit Strokes(const MotionSpec& motion) : motion_(motion), levels_(given_levels(motion)) {}

    [[nodiscard]] std::vector<StretchScale> scales() const {
        const std::size_t count = motion_.own_segments();
        std::vector<StretchScale> all(count);
        std::size_t first = 0;
        while (first < count && !begins(first)) ++first;
        const bool never_rests = first == count || advances();
        for (std::size_t k = 0, size = 0; k < count; k += size) {
            const std::size_t begin = (first + k) % count;
            size = 1;
            while (!never_rests && k + size < count && !begins((begin + size) % count)) ++size;
            const StretchScale scale = scale_of(begin, size);
            for (std::size_t i = 0; i < size; ++i) all[(begin + i) % count] = scale;
        }
        return all;
    }

 private:
    const MotionSpec& motion_;
    std::vector<std::optional<double>> levels_;

    /// Splines alone, which go on in the next turn from where they are.
    [[nodiscard]] bool advances() const {
        return motion_.relative && std::ranges::all_of(motion_.segments, [](const ProgramSegment& segment) {
                   return segment.kind == SegmentKind::spline;
               });
    }
    [[nodiscard]] bool begins(std::size_t segment) const {
        if (segment == 0 && !motion_.periodic()) return true;
        const std::size_t last = segment > 0 ? segment - 1 : motion_.own_segments() - 1;
        const ProgramSegment &own = motion_.segments[segment], &before = motion_.segments[last];
        if (own.kind != SegmentKind::spline || before.kind != SegmentKind::spline) return true;
        if (before.end && before.end->velocity == 0.0) return true;
        // It turns back, or one of the two stands.
        const std::optional<double> moves = moved(segment, segment + 1), moved_before = moved(last, last + 1);
        if (!moves || !moved_before) return true;  // which of them a free displacement joins is open
        return *moves * *moved_before < 0.0 ||
               std::min(std::abs(*moves), std::abs(*moved_before)) < standing_displacement;
    }
    /// None: one of the two is free.
    [[nodiscard]] std::optional<double> moved(std::size_t from, std::size_t to) const {
        if (!levels_[from] || !levels_[to]) return std::nullopt;
        return *levels_[to] - *levels_[from];
    }
    /// Where a segment begins, x.
    [[nodiscard]] double begin_of(std::size_t segment) const {
        double angle = 0.0;
        for (std::size_t i = 0; i < segment; ++i) angle += motion_.segments[i].angle;
        return angle / motion_.unit_angle();
    }
    /// Of so many segments, which may go on at the start of the turn.
    [[nodiscard]] StretchScale scale_of(std::size_t begin, std::size_t size) const {
        const std::size_t end = std::min(begin + size, motion_.own_segments());
        double angle = begin_of(end) - begin_of(begin);
        std::optional<double> whole = moved(begin, end);
        if (const std::size_t more = begin + size - end; more > 0) {
            angle += begin_of(more);
            const std::optional<double> beyond = moved(0, more);
            whole = whole && beyond ? std::optional(*whole + *beyond) : std::nullopt;
        }
        return {angle, whole ? measured_displacement(*whole) : 1.0};
    }
};

}  // namespace

std::vector<StretchScale> peak_scales(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    if (motion.type != MotionType::program) return {};
    if (scene.objective.peaks == PeakScope::motion) return std::vector<StretchScale>(motion.segments.size());
    std::vector<StretchScale> scales = Strokes(motion).scales();
    const std::size_t own = scales.size();
    for (std::size_t i = own; i < motion.segments.size(); ++i) scales.push_back(scales[i % own]);
    return scales;
}

double contradicting_directions(const MotionSpec& motion, const std::vector<StrokeDirection>& of_free) {
    const std::vector<std::optional<double>> levels = given_levels(motion);
    const std::vector<StrokeDirection> directions = segment_directions(motion, of_free);
    std::vector<double> least, most;
    for (const std::optional<double>& level : levels) {
        least.push_back(level.value_or(-infinity));
        most.push_back(level.value_or(infinity));
    }
    const auto rises = [&](std::size_t from, std::size_t to) {
        least[to] = std::max(least[to], least[from]);
        most[from] = std::min(most[from], most[to]);
    };
    for (std::size_t pass = 0; pass < directions.size(); ++pass)
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const bool stands = motion.segments[i].kind == SegmentKind::dwell;
            if (stands || directions[i] == StrokeDirection::rises) rises(i, i + 1);
            if (stands || directions[i] == StrokeDirection::falls) rises(i + 1, i);
        }
    double apart = 0.0;
    for (std::size_t j = 0; j < levels.size(); ++j) apart = std::max(apart, least[j] - most[j]);
    return apart;
}

namespace {

/// What follows from inequalities alone, with its segment.
using ImpliedConditions = std::vector<std::pair<std::size_t, PointCondition>>;

/// The ends of a run count as given where its conditions are solved: a spline of few segments may then have
/// too little freedom for those that are implied, whose inequalities hold without them.
MotionFamily family_of(const FamilyRequest& request, const ImpliedConditions& implied) {
    FamilyRequest whole = request;
    for (const auto& [i, condition] : implied) whole.stretches[i].conditions.push_back(condition);
    MotionFamily family = MotionFamily::make(whole);
    if (implied.empty() || family.contradictions().empty()) return family;
    return MotionFamily::make(request);
}

}  // namespace

MotionFamily program_family(const Scene& scene, DesignKind kind,
                            const std::vector<StrokeDirection>& of_free) {
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
    request.rest = scene.spline.rest;
    const double unit = scene.motion.unit_angle();
    const std::vector<PlacedPoint> points = placed_points(scene.motion);
    // Where two splines reverse the motion y' = 0 is a condition: inequalities around the joint would be
    // degenerate.
    const std::vector<std::size_t> turning = turning_segments(motion, of_free);
    const std::vector<std::optional<double>> levels = given_levels(motion);
    const std::vector<StretchScale> scales = peak_scales(scene);
    ImpliedConditions implied;
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
            stretch.shape = segment_law(scene.motion, i);
        } else if (segment.kind == SegmentKind::spline) {
            stretch.kind = StretchRequest::Kind::spline;
            stretch.breakpoints = breakpoints_of(scene.spline, stretch.begin, stretch.end,
                                                 regions_of(scene.motion, points, static_cast<int>(i)));
            if (std::ranges::find(turning, i) != turning.end())
                stretch.conditions.push_back({stretch.begin, 1, Side::right, 0.0,
                                              "turning point at the start of " + segment_words(i), false});
            for (const PlacedPoint& point : points) {
                if (point.segment != static_cast<int>(i)) continue;
                const auto own = conditions_of(scene.motion, point, scene.spline.degree, stretch.end);
                stretch.conditions.insert(stretch.conditions.end(), own.begin(), own.end());
            }
            const StrokeRange stroke{{},          static_cast<int>(i), stretch.begin,
                                     stretch.end, levels[i],           levels[i + 1]};
            for (PointCondition& condition : turning_points(motion, points, stroke))
                stretch.conditions.push_back(std::move(condition));
            for (PointCondition& condition : points_at_limits(scene, points, static_cast<int>(i), scales[i]))
                implied.emplace_back(i, std::move(condition));
            if (rests_between(motion, i))
                implied.emplace_back(i, PointCondition{stretch.begin, 2, Side::right, 0.0,
                                                       "rest at the start of " + segment_words(i), false});
        }
        request.stretches.push_back(std::move(stretch));
    }
    return family_of(request, implied);
}

}  // namespace camopt
