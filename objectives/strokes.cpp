// SPDX-License-Identifier: MIT
#include "objectives/strokes.hpp"

#include "objectives/rules/linear_bound.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Datum = PlacedRule::Datum;

constexpr double same_level = 1e-9;  // lifts: tolerance of a set point on the edge of the range
constexpr double slow_enough =
    1e-9;  // lifts by x: a joint or set point slower than this does not leave the range

/// y and y' at a location that the motion passes, and y'' if given.
struct Passed {
    double y = 0.0, slope = 0.0;
    std::optional<double> bend = {};
};

/// The set points of a stroke that give a displacement: a region at both of its ends.
std::vector<Passed> passed_points(const std::vector<PlacedPoint>& points, const StrokeRange& stroke,
                                  int segment) {
    std::vector<Passed> passed;
    for (const PlacedPoint& point : points) {
        const bool own = point.segment == segment && point.begin >= stroke.begin - same_level &&
                         point.end <= stroke.end + same_level;
        if (!own || !point.wanted[0]) continue;
        const double slope = point.wanted[1].value_or(0.0);
        passed.push_back({*point.wanted[0], slope, point.wanted[2]});
        if (point.is_region())
            passed.push_back({*point.wanted[0] + slope * (point.end - point.begin), slope});
    }
    return passed;
}

/// y' of a law next to a stroke at the joint; 0 if it rests, or if its displacement is free.
double slope_beside(const Scene& scene, const MotionFamily& family, int stretch, Side side) {
    const int count = static_cast<int>(family.own_stretches().size());
    int other = stretch + (side == Side::right ? -1 : 1);
    if (!scene.motion.periodic() && (other < 0 || other >= count))
        return end_velocities(scene.motion, other >= count)[0];
    other = (other + count) % count;
    const MotionFamily::Stretch& beside = family.stretches()[other];
    if (!beside.shape) return 0.0;
    const auto from = known_displacement(beside.from), to = known_displacement(beside.to);
    const double x = side == Side::right ? beside.shape->end() : beside.shape->begin();
    const Side seen = side == Side::right ? Side::left : Side::right;
    return from && to ? (*to - *from) / (beside.end - beside.begin) * beside.shape->at(x, seen).derivative[1]
                      : 0.0;
}

/// The range of a stroke whose ends are known.
void set_range(StrokeRange& stroke, const std::vector<Passed>& points, const std::array<double, 2>& slopes) {
    if (std::abs(*stroke.to - *stroke.from) < standing_displacement && points.empty()) return;
    stroke.least = std::min(*stroke.from, *stroke.to);
    stroke.most = std::max(*stroke.from, *stroke.to);
    for (const Passed& point : points) {
        stroke.least = std::min(stroke.least, point.y);
        stroke.most = std::max(stroke.most, point.y);
    }
    const double least = stroke.least, most = stroke.most;
    const auto open_at = [&](double y, bool below, bool above) {
        if (below && y <= least + same_level) stroke.least = -infinity;
        if (above && y >= most - same_level) stroke.most = infinity;
    };
    open_at(*stroke.from, slopes[0]<-slow_enough, slopes[0]> slow_enough);
    open_at(*stroke.to, slopes[1] > slow_enough, slopes[1] < -slow_enough);
    for (const Passed& point : points) {
        const bool moves = std::abs(point.slope) > slow_enough;
        open_at(point.y, moves || (point.bend && *point.bend <= slow_enough),
                moves || (point.bend && *point.bend >= -slow_enough));
    }
}

/// Of a rise or a rise and return.
std::vector<StrokeRange> strokes_of_one_spline(const Scene& scene) {
    const std::vector<PlacedPoint> points = placed_points(scene.motion);
    std::vector<StrokeRange> strokes = {{"motion", 0, 0.0, 1.0, 0.0, 1.0}};
    if (scene.motion.type == MotionType::rr)
        strokes.push_back({"motion", 0, 1.0, scene.motion.length(), 1.0, 0.0});
    strokes.front().rest_at_begin = strokes.back().rest_at_end = scene.rest_order();
    const std::array<double, 2> slopes = {end_velocities(scene.motion, false)[0],
                                          end_velocities(scene.motion, true)[0]};
    for (StrokeRange& stroke : strokes)
        set_range(
            stroke, passed_points(points, stroke, -1),
            {&stroke == &strokes.front() ? slopes[0] : 0.0, &stroke == &strokes.back() ? slopes[1] : 0.0});
    return strokes;
}

void add_turning_points(std::vector<PointCondition>& turning, const std::vector<PlacedPoint>& points,
                        const StrokeRange& stroke, int segment) {
    for (const PlacedPoint& point : points) {
        const bool inside = point.segment == segment && !point.is_region() && point.begin > stroke.begin &&
                            point.begin < stroke.end;
        const std::optional<double>& y = point.wanted[0];
        if (!inside || !y || point.wanted[1] || point.wanted[2]) continue;
        if (*y <= stroke.least || *y >= stroke.most)
            turning.push_back(
                {point.begin, 1, Side::right, 0.0, "turning point at " + listed_words(point.member), false});
    }
}

std::vector<PlacedRule> rules_of(const Scene& scene, const StrokeRange& stroke, StrokeDirection direction) {
    std::vector<PlacedRule> rules;
    const auto add = [&](LinearBound bound, Datum datum) {
        bound.stretch = stroke.stretch;
        bound.datum = datum;
        bound.starts_without_rows = true;
        // y^(order) leaves its end with the first derivative that is not 0 there.
        bound.contact_begin = stroke.rest_at_begin + 1 - bound.order;
        bound.contact_end = stroke.rest_at_end + 1 - bound.order;
        bound.begin = stroke.begin;
        bound.end = stroke.end;
        bound.touches_begin = datum != Datum::end;
        bound.touches_end = datum != Datum::begin;
        if (scene.motion.type == MotionType::rr)
            (stroke.begin > 0.0 ? bound.from : bound.until) = stroke.begin > 0.0 ? stroke.begin : stroke.end;
        rules.push_back(bound.rule());
    };
    const bool free = stroke.is_free();
    if (free && (direction == StrokeDirection::open || stroke.has_points)) return rules;
    const double lift = free ? 1.0 : std::abs(*stroke.to - *stroke.from);
    const bool rises = free ? direction == StrokeDirection::rises : *stroke.to > *stroke.from;
    if (scene.motion.monotone && lift >= standing_displacement) {
        const double mean = lift / (stroke.end - stroke.begin);
        add({"motion.monotone", 1, rises ? -1 : 1, 0.0, mean}, Datum::zero);
        return rules;  // from a to b it stays between them
    }
    if (!scene.motion.within_lift) return rules;
    if (free) {
        add({"motion.within_lift", 0, -1, 0.0, 1.0}, rises ? Datum::begin : Datum::end);
        add({"motion.within_lift", 0, 1, 0.0, 1.0}, rises ? Datum::end : Datum::begin);
        return rules;
    }
    const bool bounded = std::isfinite(stroke.least) && std::isfinite(stroke.most);
    const double width = bounded ? stroke.most - stroke.least : std::max(lift, standing_displacement);
    if (std::isfinite(stroke.least)) add({"motion.within_lift", 0, -1, -stroke.least, width}, Datum::zero);
    if (std::isfinite(stroke.most)) add({"motion.within_lift", 0, 1, stroke.most, width}, Datum::zero);
    return rules;
}

}  // namespace

bool meets_rest(const MotionSpec& motion, int segment, bool at_end) {
    const int count = static_cast<int>(motion.segments.size());
    const int beside = segment + (at_end ? 1 : -1);
    if (!motion.periodic() && (beside < 0 || beside >= count)) return true;
    return motion.segments[static_cast<std::size_t>((beside + count) % count)].kind == SegmentKind::dwell;
}

std::vector<StrokeRange> strokes_of(const Scene& scene, const MotionFamily& family) {
    if (scene.motion.type != MotionType::program) return strokes_of_one_spline(scene);
    const std::vector<PlacedPoint> points = placed_points(scene.motion);
    std::vector<StrokeRange> strokes;
    for (int i = 0; i < static_cast<int>(family.own_stretches().size()); ++i) {
        const MotionFamily::Stretch& stretch = family.own_stretches()[i];
        if (stretch.kind != StretchRequest::Kind::spline) continue;
        StrokeRange stroke{segment_key(i),
                           i,
                           stretch.begin,
                           stretch.end,
                           known_displacement(stretch.from),
                           known_displacement(stretch.to)};
        if (meets_rest(scene.motion, i, false)) stroke.rest_at_begin = scene.rest_order();
        if (meets_rest(scene.motion, i, true)) stroke.rest_at_end = scene.rest_order();
        const std::vector<Passed> passed = passed_points(points, stroke, i);
        stroke.has_points = !passed.empty();
        if (!stroke.is_free())
            set_range(
                stroke, passed,
                {slope_beside(scene, family, i, Side::right), slope_beside(scene, family, i, Side::left)});
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

std::vector<PointCondition> turning_points(const Scene& scene) {
    std::vector<PointCondition> turning;
    if (!scene.motion.within_lift) return turning;
    const std::vector<PlacedPoint> points = placed_points(scene.motion);
    for (const StrokeRange& stroke : strokes_of_one_spline(scene))
        add_turning_points(turning, points, stroke, -1);
    return turning;
}

std::vector<PointCondition> turning_points(const MotionSpec& motion, const std::vector<PlacedPoint>& points,
                                           StrokeRange stroke) {
    std::vector<PointCondition> turning;
    if (!motion.within_lift || stroke.is_free()) return turning;
    set_range(stroke, passed_points(points, stroke, stroke.stretch), {});
    // What is next to the spline may open a side that one of its ends is on.
    const auto [lower, upper] = std::minmax(*stroke.from, *stroke.to);
    if (!(stroke.least < lower - same_level)) stroke.least = -infinity;
    if (!(stroke.most > upper + same_level)) stroke.most = infinity;
    add_turning_points(turning, points, stroke, stroke.stretch);
    return turning;
}

namespace {

/// Whether y^(order) is bounded by the value on both sides of x.
bool is_at_limit(const Scene& scene, int order, double value, double x, const StretchScale& scale) {
    constexpr double same = 1e-9;
    const auto equals = [&](double bound) {
        return std::abs(value - bound) <= same * std::max(1.0, std::abs(bound));
    };
    for (const PeakLimitRow& row : peak_limit_rows()) {
        const auto& limit = row.in(scene.limits);
        if (!limit || row.order() != order || row.of_cam) continue;
        const double size = limit->physical() ? 1.0 : scale.displacement / std::pow(scale.angle, order);
        if ((row.side >= 0 && equals(size * limit->normalised)) ||
            (row.side <= 0 && equals(row.side == 0 ? -size * limit->normalised : size * limit->normalised)))
            return true;
    }
    for (const Corridor& corridor : scene.motion.corridors) {
        const Corridor::Bounds& bounds = corridor.bounds[static_cast<std::size_t>(order)];
        const double unit = scene.motion.unit_angle();
        if (!(corridor.from < unit * x && unit * x < corridor.to)) continue;
        if ((bounds.least && equals(*bounds.least)) || (bounds.most && equals(*bounds.most))) return true;
    }
    return order == 1 && value == 0.0 && scene.motion.monotone;
}

}  // namespace

std::vector<PointCondition> points_at_limits(const Scene& scene, const std::vector<PlacedPoint>& points,
                                             int segment, const StretchScale& scale) {
    std::vector<PointCondition> found;
    const double length = scene.motion.length();
    double begin = 0.0;
    for (int i = 0; i < segment; ++i) begin += scene.motion.segments[static_cast<std::size_t>(i)].angle;
    begin /= scene.motion.unit_angle();
    const double end = segment < 0 ? length
                                   : begin + scene.motion.segments[static_cast<std::size_t>(segment)].angle /
                                                 scene.motion.unit_angle();
    for (const PlacedPoint& point : points) {
        // A limit of a spline says nothing of what follows it, and at an end the motion has one side.
        if (point.segment != segment || point.is_region()) continue;
        if (point.begin <= begin + same_level || point.begin >= end - same_level) continue;
        for (int order = 0; order < 2; ++order) {
            const auto& value = point.wanted[static_cast<std::size_t>(order)];
            if (!value || point.wanted[static_cast<std::size_t>(order) + 1]) continue;
            if (is_at_limit(scene, order, *value, point.begin, scale))
                found.push_back({point.begin, order + 1, Side::right, 0.0,
                                 "a set point at a limit: " + point.member, false});
        }
    }
    return found;
}

namespace {

/// Laws and dwells stay between the displacements at their ends.
void hold_displacement(CamModel& model, const std::vector<StrokeRange>& strokes) {
    double most = 0.0, width = 0.0;
    for (const StrokeRange& stroke : strokes) {
        if (stroke.is_free()) return;
        most = std::max({most, std::abs(stroke.least), std::abs(stroke.most)});
        width = std::max(width, stroke.most - stroke.least);
    }
    for (const MotionFamily::Stretch& stretch : model.design.own_stretches())  // a law may be the last
        most = std::max(most, std::abs(known_displacement(stretch.to).value_or(infinity)));
    if (strokes.empty() || !std::isfinite(most)) return;
    model.held_displacement = most;
    model.held_width = width;
}

/// MotionSpec::reach along every spline.
void add_reach_rules(CamModel& model, const std::array<double, 2>& reach) {
    for (int i = 0; i < static_cast<int>(model.design.own_stretches().size()); ++i) {
        if (model.design.own_stretches()[i].kind != StretchRequest::Kind::spline) continue;
        for (const int sign : {-1, 1}) {
            LinearBound bound{"cam", 0, sign, sign * reach[sign < 0 ? 0 : 1], 1.0};
            if (!std::isfinite(bound.bound)) continue;
            bound.stretch = i;
            bound.starts_without_rows = true;
            model.rules.push_back(bound.rule());
        }
    }
}

}  // namespace

void add_stroke_rules(CamModel& model, const Scene& scene, const HeldStrokes& strokes) {
    if (scene.motion.reach) add_reach_rules(model, *scene.motion.reach);
    if (!scene.motion.within_lift && !scene.motion.monotone) return;
    std::size_t free = 0;
    const std::vector<StrokeRange> all = strokes_of(scene, model.design);
    if (scene.motion.within_lift) hold_displacement(model, all);
    if (!strokes.held) return;
    for (const StrokeRange& stroke : all) {
        StrokeDirection direction = StrokeDirection::open;
        if (stroke.is_free() && free < strokes.directions.size()) direction = strokes.directions[free++];
        for (PlacedRule& rule : rules_of(scene, stroke, direction)) model.rules.push_back(std::move(rule));
    }
}

void set_entry_factors(CamModel& model, const Scene& scene) {
    const std::vector<StrokeRange> strokes = strokes_of(scene, model.design);
    if (strokes.size() < 2) return;  // the length and the displacement of one stroke count as one
    model.entry_factors.assign(static_cast<std::size_t>(model.design.size()), 1.0);
    for (int j = 0; j < model.design.size(); ++j) {
        const std::optional<double> x = model.design.place(j);
        const int order = model.design.order(j);
        if (!x || order == 0) continue;
        double factor = 0.0;  // the larger one where two strokes join
        for (const StrokeRange& stroke : strokes) {
            if (*x < stroke.begin || *x > stroke.end) continue;
            const double moved = stroke.is_free() ? 1.0 : measured_displacement(*stroke.to - *stroke.from);
            factor = std::max(factor, moved / std::pow(stroke.end - stroke.begin, order));
        }
        if (factor > 0.0) model.entry_factors[j] = factor;
    }
}

std::vector<double> excursions_of(const Scene& scene, const MotionFamily& family, const MotionChain& motion) {
    std::vector<double> excursions;
    for (const StrokeRange& stroke : strokes_of(scene, family)) {
        const double moved = motion.at(stroke.end, Side::left).derivative[0] -
                             motion.at(stroke.begin, Side::right).derivative[0];
        double worst = 0.0;
        for (const PlacedRule& rule :
             rules_of(scene, stroke, moved < 0.0 ? StrokeDirection::falls : StrokeDirection::rises))
            worst = std::max(worst, largest_of(rule_maxima(rule, family, motion, {})).value);
        excursions.push_back(worst);
    }
    return excursions;
}

}  // namespace camopt
