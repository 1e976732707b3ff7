// SPDX-License-Identifier: MIT
// Angles, lift and displacements: what a user could change about the motion that was asked for. What a scene
// file gives in units keeps its value in units, so that the file with the changed numbers is the scene.
#include "scene/motion/set_points.hpp"
#include "scene/part_names.hpp"
#include "studies/least/adjustment.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Of the rise: a set point this close to the top lies on it.
constexpr double at_the_top = 1e-9;
// A dwell that gives way keeps this part of its angle.
constexpr double least_dwell_left = 0.01;
// No lift is reduced to less than this part; a displacement moves by so many lifts at most.
constexpr double least_lift_left = 1e-3, farthest_displacement = 1.0;
constexpr double longest_duration = 2.0;  // of a valve's, by the given one

// Rise and return.

/// Which strokes take longer; both keep their ratio.
struct Strokes {
    bool rise = true, back = false;
};

/// Set points in degrees that lie on the return keep their distance from the end of the motion.
void lengthen(Scene& changed, const Strokes& strokes, double ratio) {
    MotionSpec& motion = changed.motion;
    const MotionSpec before = motion;
    if (strokes.rise) motion.rise *= ratio;
    if (strokes.back && motion.return_angle) *motion.return_angle *= ratio;
    keep_written(changed, before);
    const double later = motion.length() - before.length() * before.rise / motion.rise;
    for (std::size_t i = 0; motion.type == MotionType::rr && i < motion.via.size(); ++i) {
        SetPoint& point = motion.via[i];
        if (before.via[i].at <= 1.0 + at_the_top || point.units.place.empty()) continue;
        point.at += later;
        if (point.until) *point.until += later;
    }
}

/// The set points that lengthen() moved, as the scene file would have to give them.
void add_moved_points(std::vector<CompanionChange>& all, const MotionSpec& before, const MotionSpec& now) {
    for (std::size_t i = 0; i < now.via.size(); ++i) {
        const SetPoint &then = before.via[i], &point = now.via[i];
        if (then.at <= 1.0 + at_the_top || point.units.place.empty()) continue;
        const Spelling& place = spelling_of_place(point.units.place);
        const double unit = place.factor;
        const auto add = [&](const char* name, double from, double to) {
            all.push_back({entry_key("motion.via", i, name).append(place.suffix),
                           as_written(from * before.rise / unit), as_written(to * now.rise / unit)});
        };
        add(point.until ? "from" : "at", then.at, point.at);
        if (point.until) add("to", *then.until, *point.until);
    }
}

void add_stroke(std::vector<Adjustment>& all, const Scene& scene, const Strokes& strokes) {
    const MotionSpec& motion = scene.motion;
    const std::string name = strokes.rise ? "motion.rise" : "motion.return";
    const Spelling spelling = scene.spelling_of(name, spellings::angle[0]);
    const double one = spelling.factor;
    const double given = as_written((strokes.rise ? motion.rise : *motion.return_angle) / one);
    const double total = as_written(motion.length() * motion.rise / one);
    const bool alone = motion.return_angle && strokes.rise != strokes.back;
    const double turn = units::turn / one, most = alone ? given + turn - total : given * turn / total;
    Adjustment adjustment = number_adjustment(
        fmt::format("{}{}", name, spelling.suffix), given, given, Range::between(given, most),
        [strokes, given, one](Scene& changed, double value) {
            lengthen(changed, strokes, value / given);
            // To the last bit as a file with this value is read.
            (strokes.rise ? changed.motion.rise : *changed.motion.return_angle) = value * one;
        });
    adjustment.usefulness = Usefulness::angle;
    adjustment.fallback = strokes.rise && strokes.back;
    adjustment.begin = strokes.rise ? 0.0 : 1.0;
    adjustment.end = strokes.back || !motion.return_angle ? motion.length() : 1.0;
    adjustment.also = [scene, strokes, with = adjustment.with](double value) {
        std::vector<CompanionChange> also;
        const MotionSpec before = scene.motion, now = with(scene, value).motion;
        if (strokes.rise && strokes.back) {
            const Spelling back = scene.spelling_of("motion.return", spellings::angle[0]);
            also.push_back({fmt::format("motion.return{}", back.suffix),
                            as_written(*before.return_angle / back.factor),
                            as_written(*now.return_angle / back.factor)});
        }
        add_moved_points(also, before, now);
        return also;
    };
    all.push_back(std::move(adjustment));
}

void add_strokes(std::vector<Adjustment>& all, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    if (!motion.return_angle) return add_stroke(all, scene, {true, false});
    // Breakpoints are given up to 1 + return / rise.
    if (scene.spline.breakpoints.empty()) {
        add_stroke(all, scene, {true, false});
        add_stroke(all, scene, {false, true});
    }
    add_stroke(all, scene, {true, true});
}

// Programs.

constexpr std::size_t nothing = static_cast<std::size_t>(-1);

/// The nearest dwell after a segment (forward) or before it; across the end of a closed program.
std::size_t dwell_beside(const MotionSpec& motion, std::size_t segment, bool forward) {
    const std::size_t count = motion.own_segments();
    for (std::size_t k = 1; k < count; ++k) {
        const std::size_t i = (segment + (forward ? k : count - k)) % count;
        if (!motion.periodic() && (forward ? i < segment : i > segment)) return nothing;
        const ProgramSegment& other = motion.segments[i];
        if (other.kind == SegmentKind::dwell && !other.angle_range) return i;
    }
    return nothing;
}

/// The angle of a segment, as it is written.
struct WrittenAngle {
    std::string key;
    double unit = units::degree, given = 0.0;

    WrittenAngle(const Scene& scene, std::size_t segment) : key(segment_key(segment, "angle")) {
        const Spelling spelling = scene.spelling_of(key, spellings::angle[0]);
        key += spelling.suffix;
        unit = spelling.factor;
        given = as_written(scene.motion.segments[segment].angle / unit);
    }
};

/// `giver`: the segment it is taken from; nothing: what is left of the turn.
void add_segment_angle(std::vector<Adjustment>& all, const Scene& scene, std::size_t which,
                       std::size_t giver) {
    const MotionSpec& motion = scene.motion;
    const WrittenAngle own(scene, which);
    const double given = own.given, unit = own.unit;
    const double room = giver == nothing ? units::turn - motion.length() * motion.unit_angle()
                                         : (1.0 - least_dwell_left) * motion.segments[giver].angle;
    Adjustment adjustment = number_adjustment(
        own.key, given, given, Range::between(given, given + std::max(as_written(room / unit), 0.0)),
        [which, giver, unit, other = giver == nothing ? unit : WrittenAngle(scene, giver).unit](
            Scene& changed, double value) {
            std::vector<double> angles;
            for (const ProgramSegment& segment : changed.motion.segments) angles.push_back(segment.angle);
            const double more = value * unit - angles[which];
            angles[which] = value * unit;
            if (giver != nothing) angles[giver] = as_written((angles[giver] - more) / other) * other;
            changed = with_segment_angles(changed, angles);
        });
    adjustment.usefulness = Usefulness::angle;
    adjustment.fallback = std::ranges::find(all, adjustment.key, &Adjustment::key) != all.end();
    for (std::size_t i = 0; i < which; ++i)
        adjustment.begin += motion.segments[i].angle / motion.unit_angle();
    adjustment.end = adjustment.begin + motion.segments[which].angle / motion.unit_angle();
    if (giver != nothing)
        adjustment.also = [from = WrittenAngle(scene, giver), given, unit](double value) {
            return std::vector<CompanionChange>{
                {from.key, from.given, as_written(from.given - (value - given) * unit / from.unit)}};
        };
    all.push_back(std::move(adjustment));
}

void add_segment_angles(std::vector<Adjustment>& all, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    for (std::size_t i = 0; i < motion.own_segments(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        if (segment.kind == SegmentKind::dwell || segment.angle_range) continue;
        const std::size_t next = dwell_beside(motion, i, true), before = dwell_beside(motion, i, false);
        if (next != nothing) add_segment_angle(all, scene, i, next);
        if (before != nothing && before != next) add_segment_angle(all, scene, i, before);
        if (!motion.periodic()) add_segment_angle(all, scene, i, nothing);
    }
}

/// A closed program ends at 0.
bool is_last_move_of_turn(const MotionSpec& motion, std::size_t segment) {
    const auto after = [&](std::size_t index) {
        return motion.segments.begin() + static_cast<std::ptrdiff_t>(index);
    };
    return motion.closed &&
           std::all_of(after(segment + 1), after(motion.own_segments()),
                       [](const ProgramSegment& one) { return one.kind == SegmentKind::dwell; });
}

void add_displacements(std::vector<Adjustment>& all, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    for (std::size_t i = 0; i < motion.own_segments(); ++i) {
        const ProgramSegment& segment = motion.segments[i];
        if (!segment.to || is_last_move_of_turn(motion, i)) continue;
        const Spelling& spelling = spelling_of_unit(0, segment.to_unit);
        const double unit = segment.to_unit.empty() ? 1.0 : spelling.factor / motion.lift;  // lifts
        const double given = as_written(*segment.to / unit), reach = farthest_displacement / unit;
        all.push_back(number_adjustment(
            segment_key(i, "to").append(spelling.suffix), given, std::max(std::abs(given), reach),
            Range::between(given - reach, given + reach),
            [i, unit](Scene& changed, double value) { changed.motion.segments[i].to = value * unit; }));
        all.back().usefulness = Usefulness::lift;
    }
}

void add_lift(std::vector<Adjustment>& all, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    const auto by_lift = [](const ProgramSegment& one) {
        return one.to.value_or(0.0) != 0.0 && one.to_unit.empty();
    };
    if (motion.type == MotionType::program && std::ranges::none_of(motion.segments, by_lift)) return;
    const Spelling spelling = motion.lift_is_angle ? scene.spelling_of("motion.lift", spellings::angle[0])
                                                   : scene.length_spelling_of("motion.lift");
    const double unit = spelling.factor, given = as_written(motion.lift / unit);
    all.push_back(number_adjustment(fmt::format("motion.lift{}", spelling.suffix), given, given,
                                    Range::between(least_lift_left * given, given),
                                    [unit](Scene& changed, double value) {
                                        const MotionSpec before = changed.motion;
                                        changed.motion.lift = value * unit;
                                        keep_written(changed, before);
                                    }));
    all.back().usefulness = Usefulness::lift;
}

// Valve lobes.

/// A number of the lobe.
Adjustment valve_change(const Scene& scene, const std::string& name, const Spelling& spelling,
                        double ValveSpec::*member, double least, double most) {
    const double factor = spelling.factor, given = as_written((*scene.motion.valve).*member / factor);
    return number_adjustment(fmt::format("{}{}", name, spelling.suffix), given, given,
                             Range::between(least * given, most * given),
                             [factor, member](Scene& changed, double value) {
                                 ValveSpec valve = *changed.motion.valve;
                                 const double part_before_nose = valve.opening / valve.duration;
                                 valve.*member = value * factor;
                                 valve.opening = part_before_nose * valve.duration;
                                 if (find_valve_fault(valve)) return;  // stays as it was, which is infeasible
                                 const MotionSpec before = changed.motion;
                                 make_valve_lobe(changed.motion, valve);
                                 keep_written(changed, before);
                             });
}

std::vector<Adjustment> valve_adjustments(const Scene& scene) {
    std::vector<Adjustment> all;
    const std::string duration = "motion.duration";
    all.push_back(valve_change(scene, duration, scene.spelling_of(duration, spellings::cam_angle[2]),
                               &ValveSpec::duration, 1.0, longest_duration));
    all.back().usefulness = Usefulness::angle;
    all.push_back(valve_change(scene, "motion.lift", scene.length_spelling_of("motion.lift"),
                               &ValveSpec::lift, least_lift_left, 1.0));
    all.back().usefulness = Usefulness::lift;
    return all;
}

// A wanted number moves by so many times its size, or what is typical of a motion from 0 to 1, at most.
constexpr double farthest_wanted = 1e3;

std::vector<SetPoint>& points_of(MotionSpec& motion, int segment) {
    return segment < 0 ? motion.via : motion.segments[static_cast<std::size_t>(segment)].via;
}

/// A set point of a scene: the `index`-th of the rise, or of a segment; or the given start or end.
struct Place {
    int segment = -1;
    std::size_t index = 0;
    double angle = 1.0, width = 1.0;  ///< of what normalises it: rad, x
    std::optional<SetPoint> MotionSpec::*end = nullptr;

    Place(const Scene& scene, const PlacedPoint& point, std::size_t which)
        : segment(point.segment), index(which) {
        angle = segment < 0 ? scene.motion.unit_angle()
                            : scene.motion.segments[static_cast<std::size_t>(segment)].angle;
        width = angle / scene.motion.unit_angle();
    }
    [[nodiscard]] SetPoint& in(Scene& scene) const {
        return end != nullptr ? *(scene.motion.*end) : points_of(scene.motion, segment)[index];
    }
    [[nodiscard]] Scene removed_from(const Scene& scene) const {
        Scene changed = scene;
        std::vector<SetPoint>& points = points_of(changed.motion, segment);
        points.erase(points.begin() + static_cast<std::ptrdiff_t>(index));
        copy_repeats(changed.motion);
        return changed;
    }
};

SetPointChanges::Value value_of(const Scene& scene, const PlacedPoint& point, const Place& place, int order) {
    const WrittenValue written = written_value(scene.motion, point, order);
    const double given = as_written(*point.wanted[static_cast<std::size_t>(order)] * written.per_normalised);
    const double size = std::max(std::abs(given), written.per_normalised);
    const double own_unit = std::pow(place.width, order) / written.per_normalised;
    SetPointChanges::Value value;
    value.order = order;
    value.per_normalised = written.per_normalised;
    value.change =
        number_adjustment(written.key, given, std::abs(given) > 0.0 ? std::abs(given) : size,
                          Range::between(given - farthest_wanted * size, given + farthest_wanted * size),
                          [place, order, own_unit](Scene& changed, double wanted) {
                              value_of(place.in(changed), order) = wanted * own_unit;
                          });
    if (place.end != nullptr || (point.is_region() && order > 0)) return value;
    const bool only =
        std::ranges::count_if(point.wanted, [](const auto& one) { return one.has_value(); }) == 1;
    value.without = only ? place.removed_from(scene) : scene;
    if (!only) value_of(place.in(*value.without), order).reset();
    copy_repeats(value.without->motion);
    return value;
}

/// The velocities at ends in motion.
void add_ends(std::vector<Adjustment>& all, const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    for (const auto end : {&MotionSpec::start, &MotionSpec::end}) {
        if (!(motion.*end)) continue;
        const bool at_end = end == &MotionSpec::end;
        PlacedPoint point;
        point.member = at_end ? "motion.end" : "motion.start";
        if (motion.type == MotionType::program)
            point.segment = at_end ? static_cast<int>(motion.segments.size()) - 1 : 0;
        point.units = (motion.*end)->units;
        Place place(scene, point, 0);
        place.end = end;
        const std::array<double, 2> given = end_velocities(motion, at_end);
        for (int order = 1; order <= 2; ++order) {
            const auto which = static_cast<std::size_t>(order);
            point.wanted[which] = given[which - 1];
            if (given[which - 1] != 0.0) all.push_back(value_of(scene, point, place, order).change);
        }
    }
}

Adjustment place_change(const Scene& scene, const PlacedPoint& point, const Place& place) {
    const std::string& written = point.units.place;
    const double unit = written.empty() ? 1.0 : spelling_of_place(written).factor / place.angle;
    Scene copy = scene;
    const double given = as_written(place.in(copy).at / unit);
    const double last = (place.segment < 0 ? scene.motion.length() : 1.0) / unit;
    return number_adjustment(
        fmt::format("{}.at{}{}", point.member, written.empty() ? "" : "_", written), given, last,
        Range::between(0.0, last),
        [place, unit](Scene& changed, double value) { place.in(changed).at = value * unit; });
}

}  // namespace

std::vector<Adjustment> motion_adjustments(const Scene& scene) {
    if (scene.motion.valve) return valve_adjustments(scene);
    std::vector<Adjustment> all;
    if (scene.motion.type == MotionType::program) {
        add_segment_angles(all, scene);
        add_displacements(all, scene);
    } else {
        add_strokes(all, scene);
    }
    add_lift(all, scene);
    add_ends(all, scene);
    // What has no room to move is no change.
    std::erase_if(all, [](const Adjustment& one) { return !one.may_grow && !one.may_shrink; });
    return all;
}

std::vector<SetPointChanges> set_point_changes(const Scene& scene) {
    std::vector<SetPointChanges> all;
    if (scene.motion.valve) return all;  // they are the lobe's duration
    int segment = -1;
    std::size_t index = 0;
    for (const PlacedPoint& point : placed_points(scene.motion)) {
        index = point.segment == segment && !all.empty() ? index + 1 : 0;
        segment = point.segment;
        const bool copy = segment >= static_cast<int>(scene.motion.own_segments());
        if (copy || point.member.ends_with(".end")) continue;
        const Place place(scene, point, index);
        SetPointChanges changes{point.member, point.begin, place.removed_from(scene), {}, std::nullopt};
        for (int order = 0; order < 3; ++order)
            if (point.wanted[static_cast<std::size_t>(order)])
                changes.values.push_back(value_of(scene, point, place, order));
        if (!point.is_region()) changes.place = place_change(scene, point, place);
        all.push_back(std::move(changes));
    }
    return all;
}

}  // namespace camopt
