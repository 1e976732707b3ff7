// SPDX-License-Identifier: MIT
#include "scene/motion/set_points.hpp"

#include "core/text/parsing.hpp"
#include "core/text/printable.hpp"
#include "scene/faults/scene_faults.hpp"
#include "scene/limit_table.hpp"
#include "scene/part_names.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

const std::string& unit_of(const SetPointUnits& units, int order) {
    return order == 0 ? units.displacement : order == 1 ? units.velocity : units.acceleration;
}

std::span<const Spelling> spellings_of(int order) {
    if (order == 0) return spellings::displacement;
    if (order == 1) return spellings::velocity;
    if (order == 2) return spellings::acceleration;
    return spellings::jerk;  // of corridors
}

const std::optional<double>& value_of(const SetPoint& point, int order) {
    return order == 0 ? point.displacement : order == 1 ? point.velocity : point.acceleration;
}

/// A point of one stretch that begins at x and is `width` of x long.
PlacedPoint placed_on(const PlacedPoint& stretch, const SetPoint& point, std::string member) {
    const double width = stretch.end - stretch.begin;
    PlacedPoint placed;
    placed.member = std::move(member);
    placed.segment = stretch.segment;
    placed.begin = placed.end = stretch.begin + width * point.at;
    if (point.until) placed.end = stretch.begin + width * *point.until;
    for (int order = 0; order < 3; ++order)
        if (const std::optional<double>& value = value_of(point, order))
            placed.wanted[static_cast<std::size_t>(order)] = *value / std::pow(width, order);
    placed.units = point.units;
    return placed;
}

void add_points(std::vector<PlacedPoint>& all, const std::vector<SetPoint>& points, const std::string& member,
                const PlacedPoint& stretch) {
    for (std::size_t i = 0; i < points.size(); ++i)
        all.push_back(placed_on(stretch, points[i], entry_key(member, i)));
}

/// The angle by which a point was normalised, rad.
double own_angle(const MotionSpec& motion, const PlacedPoint& point) {
    return point.segment < 0 ? motion.unit_angle()
                             : motion.segments[static_cast<std::size_t>(point.segment)].angle;
}

/// As written: of a segment from its start.
std::string place_words(const MotionSpec& motion, const PlacedPoint& point, double x) {
    const bool segment = point.segment >= 0;
    double begin = 0.0;
    for (int i = 0; i < point.segment; ++i) begin += motion.segments[static_cast<std::size_t>(i)].angle;
    const double angle = x * motion.unit_angle() - begin;  // rad
    const char* const of = segment ? " of the segment" : "";
    if (point.units.place.empty())
        return fmt::format("{}{:.6g}{}",
                           segment ? "" : "x = ", segment ? angle / own_angle(motion, point) : x, of);
    return fmt::format("{:.6g} {}{}", angle / spelling_of_place(point.units.place).factor, point.units.place,
                       of);
}

}  // namespace

const Spelling& spelling_of_unit(int order, std::string_view unit) {
    for (const Spelling& spelling : spellings_of(order))
        if (spelling.unit == unit) return spelling;
    throw InputError(
        fmt::format("a set point: found a {} in \"{}\"; allowed: none (normalised), or the unit of "
                    "a key of the scene file",
                    derivative_names[static_cast<std::size_t>(order)], unit));
}

const Spelling& spelling_of_place(std::string_view unit) {
    for (const Spelling& spelling : spellings::place)
        if (spelling.unit == unit) return spelling;
    return spellings::place.front();
}

std::optional<double>& value_of(SetPoint& point, int order) {
    return order == 0 ? point.displacement : order == 1 ? point.velocity : point.acceleration;
}

std::vector<PlacedPoint> placed_points(const MotionSpec& motion) {
    std::vector<PlacedPoint> all;
    PlacedPoint stretch;
    stretch.end = 1.0;
    add_points(all, motion.via, "motion.via", stretch);
    if (motion.type != MotionType::program) return all;
    const double unit = motion.unit_angle();
    double angle = 0.0;
    for (std::size_t i = 0; i < motion.segments.size(); ++i) {
        stretch.segment = static_cast<int>(i);
        stretch.begin = angle / unit;
        angle += motion.segments[i].angle;
        stretch.end = angle / unit;
        add_points(all, motion.segments[i].via, segment_key(i, "via"), stretch);
        if (const auto& end = motion.segments[i].end)
            all.push_back(placed_on(stretch, *end, segment_key(i, "end")));
    }
    return all;
}

std::array<double, 2> end_velocities(const MotionSpec& motion, bool at_end) {
    if (const std::optional<SetPoint>& given = at_end ? motion.end : motion.start) {
        const bool program = motion.type == MotionType::program && !motion.segments.empty();
        const double own =
            program ? (at_end ? motion.segments.back() : motion.segments.front()).angle / motion.unit_angle()
                    : 1.0;
        return {given->velocity.value_or(0.0) / own, given->acceleration.value_or(0.0) / (own * own)};
    }
    if (motion.type != MotionType::program) return {};  // between dwells
    const double end = at_end ? motion.length() : 0.0;
    for (const PlacedPoint& point : placed_points(motion))
        if (point.is_region() && std::abs((at_end ? point.end : point.begin) - end) <= same_place)
            return {*point.wanted[1], 0.0};
    return {};
}

WrittenValue written_value(const MotionSpec& motion, const PlacedPoint& point, int order) {
    const std::string& unit = unit_of(point.units, order);
    const Spelling& spelling = spelling_of_unit(order, unit);
    WrittenValue written;
    written.key = fmt::format("{}.{}{}", point.member, derivative_names[static_cast<std::size_t>(order)],
                              spelling.suffix);
    written.unit = unit;
    if (unit.empty()) {
        written.per_normalised = std::pow(own_angle(motion, point) / motion.unit_angle(), order);
        return written;
    }
    const SetPointScale whole{motion.unit_angle(), motion.lift, motion.speed};
    written.per_normalised = set_point_unit(whole, order, is_unit_of_time(unit)) / spelling.factor;
    return written;
}

std::string words_of(const MotionSpec& motion, const PlacedPoint& point, int order) {
    const WrittenValue written = written_value(motion, point, order);
    const double value = *point.wanted[static_cast<std::size_t>(order)] * written.per_normalised;
    const std::string_view unit_space = written.unit.empty() ? "" : " ";
    const bool along = point.is_region() && order > 0;
    return fmt::format("{} = {:.6g}{}{} {} {}{}", listed_words(written.key), value, unit_space,
                       unit_words(written.unit), along ? "from" : "at",
                       place_words(motion, point, point.begin),
                       along ? " to " + place_words(motion, point, point.end) : "");
}

std::vector<double> with_regions(std::vector<double> breakpoints, std::vector<std::array<double, 2>> regions,
                                 double closest) {
    if (regions.empty()) return breakpoints;
    std::ranges::sort(regions);
    std::vector<std::array<double, 2>> apart;  // overlapping ones are merged; touching ones are two
    for (const std::array<double, 2>& region : regions) {
        if (!apart.empty() && region[0] < apart.back()[1] - same_place)
            apart.back()[1] = std::max(apart.back()[1], region[1]);
        else
            apart.push_back(region);
    }
    const double first = breakpoints.front(), last = breakpoints.back();
    const auto gives_way = [&](double point) {
        return std::ranges::any_of(apart, [&](const std::array<double, 2>& region) {
            return point > region[0] - closest && point < region[1] + closest;
        });
    };
    std::erase_if(breakpoints,
                  [&](double point) { return point != first && point != last && gives_way(point); });
    for (const std::array<double, 2>& region : apart)
        for (const double end : region)
            if (std::abs(end - first) > same_place && std::abs(end - last) > same_place)
                breakpoints.push_back(end);
    std::ranges::sort(breakpoints);
    const auto is_same = [](double one, double other) { return std::abs(one - other) <= same_place; };
    breakpoints.erase(std::unique(breakpoints.begin(), breakpoints.end(), is_same), breakpoints.end());
    return breakpoints;
}

void copy_repeats(MotionSpec& motion) {
    const std::size_t own = motion.own_segments();
    for (std::size_t i = own; i < motion.segments.size(); ++i) motion.segments[i] = motion.segments[i - own];
}

void keep_written(MotionSpec& changed, const MotionSpec& before) {
    const auto keep = [](std::vector<SetPoint>& points, const SetPointScale& now, const SetPointScale& then) {
        for (SetPoint& point : points) {
            if (!point.units.place.empty()) {
                point.at *= then.angle / now.angle;
                if (point.until) *point.until *= then.angle / now.angle;
            }
            for (int order = 0; order < 3; ++order) {
                const std::string& unit = unit_of(point.units, order);
                std::optional<double>& value = value_of(point, order);
                if (!value || unit.empty()) continue;
                const bool in_time = is_unit_of_time(unit);
                *value *= set_point_unit(then, order, in_time) / set_point_unit(now, order, in_time);
            }
        }
    };
    const auto keep_one = [&](std::optional<SetPoint>& point, double now, double then) {
        if (!point) return;
        std::vector<SetPoint> one = {*point};
        keep(one, {now, changed.lift, changed.speed}, {then, before.lift, before.speed});
        point = one.front();
    };
    const bool program = changed.type == MotionType::program && !changed.segments.empty();
    keep_one(changed.start, program ? changed.segments.front().angle : changed.unit_angle(),
             program ? before.segments.front().angle : before.unit_angle());
    keep_one(changed.end, program ? changed.segments.back().angle : changed.unit_angle(),
             program ? before.segments.back().angle : before.unit_angle());
    for (Corridor& corridor : changed.corridors)
        for (std::size_t order = 0; order < corridor.bounds.size(); ++order) {
            Corridor::Bounds& bounds = corridor.bounds[order];
            if (bounds.unit.empty()) continue;
            const auto power = static_cast<int>(order);
            const bool in_time = is_unit_of_time(bounds.unit);
            const double factor =
                set_point_unit({before.unit_angle(), before.lift, before.speed}, power, in_time) /
                set_point_unit({changed.unit_angle(), changed.lift, changed.speed}, power, in_time);
            for (std::optional<double>* const side : {&bounds.least, &bounds.most})
                if (*side) **side *= factor;
        }
    keep(changed.via, {changed.unit_angle(), changed.lift, changed.speed},
         {before.unit_angle(), before.lift, before.speed});
    if (changed.valve) return;  // the lobe says its segments
    for (std::size_t i = 0; i < changed.segments.size(); ++i) {
        ProgramSegment& segment = changed.segments[i];
        if (segment.to && !segment.to_unit.empty()) *segment.to *= before.lift / changed.lift;
        keep_one(segment.end, segment.angle, before.segments[i].angle);
        keep(segment.via, {segment.angle, changed.lift, changed.speed},
             {before.segments[i].angle, before.lift, before.speed});
    }
}

void keep_written(Scene& changed, const MotionSpec& before) {
    MotionSpec& now = changed.motion;
    keep_written(now, before);
    // Normalised peak · lift · (speed / unit angle)^order is what a limit in time holds; by the cam angle
    // without the speed.
    const double longer = now.unit_angle() / before.unit_angle();
    const double pace = before.speed.value_or(1.0) / now.speed.value_or(1.0) * longer;
    for (const PeakLimitRow& row : peak_limit_rows())
        if (auto& limit = row.in(changed.limits); limit && limit->physical()) {
            const double faster = limit->in_time() ? pace : longer;
            const double factor = before.lift / now.lift * std::pow(faster, row.order());
            limit->normalised *= factor;
            limit->one_normalised /= factor;
        }
}

Scene with_segment_angles(const Scene& scene, const std::vector<double>& angles) {
    Scene changed = scene;
    for (std::size_t i = 0; i < angles.size(); ++i) changed.motion.segments[i].angle = angles[i];
    keep_written(changed, scene.motion);
    return changed;
}

}  // namespace camopt
