// SPDX-License-Identifier: MIT
// The rows of set points, of the states at ends and joints, and of corridors.
#include "scene/key_place.hpp"
#include "scene/keys/own_rows.hpp"
#include "scene/set_point_scale.hpp"

#include <tuple>

namespace camopt::key_rows {
namespace {

using enum KeyType;
using namespace spellings;
using key_place::each, key_place::each_inner;

/// The angle that x of a set point counts in, rad.
using StretchAngle = double (*)(const MotionSpec& motion, const KeyAt& at);

double whole_angle(const MotionSpec& motion, const KeyAt& /*at*/) {
    return motion.unit_angle();
}
double segment_angle(const MotionSpec& motion, const KeyAt& at) {
    return motion.segments.at(at.entry[0]).angle;
}
double first_angle(const MotionSpec& motion, const KeyAt& /*at*/) {
    return motion.segments.empty() ? motion.unit_angle() : motion.segments.front().angle;
}
double last_angle(const MotionSpec& motion, const KeyAt& /*at*/) {
    return motion.segments.empty() ? motion.unit_angle() : motion.segments.back().angle;
}

constexpr int location = -1;  // in place of the order of a derivative

/// In a unit: by the angle of the stretch, the lift and, in time, the speed.
void normalise(KeyPlace& place, StretchAngle angle, int order) {
    place.stored = [=](const Scene& scene, const KeyAt& at, double written) {
        const MotionSpec& motion = scene.motion;
        if (at.spelling->unit.empty()) return written;
        const double si = written * at.spelling->factor, own = angle(motion, at);
        if (order == location) return si / own;
        return si /
               set_point_unit({own, motion.lift, motion.speed}, order, is_unit_of_time(at.spelling->unit));
    };
}

/// The places of a set point's numbers; `path` leads to it.
template <class... Path>
struct SetPointPlaces {
    StretchAngle angle;
    std::tuple<Path...> path;

    SetPointPlaces(StretchAngle own_angle, Path... own_path) : angle(own_angle), path(own_path...) {}

    template <class... Member>
    [[nodiscard]] KeyPlace of(Member... member) const {
        return std::apply([&](auto... step) { return stored_in(step..., member...); }, path);
    }
    template <class Member>
    [[nodiscard]] KeyPlace number(Member member, std::string SetPointUnits::*unit, int order) const {
        KeyPlace place = in_unit(of(member), of(&SetPoint::units, unit));
        normalise(place, angle, order);
        return place;
    }
    /// A region has `from` and `to`, a point `at`.
    [[nodiscard]] KeyPlace begin(bool of_region) const {
        return unless(number(&SetPoint::at, &SetPointUnits::place, location),
                      [of_region, until = of(&SetPoint::until)](const Scene& scene, const KeyAt& at) {
                          return until.value(scene, at).has_value() != of_region;
                      });
    }
    /// With `to` at its place until that is read.
    [[nodiscard]] KeyPlace from() const {
        KeyPlace place = begin(true);
        place.assign = [first = place.assign, until = of(&SetPoint::until)](
                           Scene& scene, const KeyValue& value, const KeyAt& at) {
            first(scene, value, at);
            until.assign(scene, value, at);
        };
        return place;
    }
    [[nodiscard]] KeyPlace until() const { return number(&SetPoint::until, &SetPointUnits::place, location); }
    [[nodiscard]] KeyPlace displacement() const {
        return number(&SetPoint::displacement, &SetPointUnits::displacement, 0);
    }
    [[nodiscard]] KeyPlace velocity() const {
        return number(&SetPoint::velocity, &SetPointUnits::velocity, 1);
    }
    [[nodiscard]] KeyPlace acceleration() const {
        return number(&SetPoint::acceleration, &SetPointUnits::acceleration, 2);
    }
};

/// Bounds of the derivative of `order`, and how they are written.
KeyPlace corridor_bounds(std::string_view name, std::size_t order) {
    using Bounds = Corridor::Bounds;
    const auto of = [order](auto member) {
        return stored_in(&Scene::motion, &MotionSpec::corridors, each, &Corridor::bounds, order, member);
    };
    KeyPlace place = in_unit(of(&Bounds::least), of(&Bounds::unit));
    place.assign = [=, unit = place.assign](Scene& scene, const KeyValue& value, const KeyAt& at) {
        Bounds& bounds = scene.motion.corridors.at(at.entry[0]).bounds[order];
        const auto& given = std::get<KeyBounds>(value);
        unit(scene, 0.0, at);
        bounds.least = given.least;
        bounds.most = given.most;
        bounds.key = std::string(name) + std::string(at.spelling->suffix);
    };
    place.value = [order](const Scene& scene, const KeyAt& at) -> std::optional<KeyValue> {
        if (at.entry[0] >= scene.motion.corridors.size()) return std::nullopt;
        const Bounds& bounds = scene.motion.corridors[at.entry[0]].bounds[order];
        if (!bounds.least && !bounds.most) return std::nullopt;
        return KeyBounds{bounds.least, bounds.most};
    };
    normalise(place, whole_angle, static_cast<int>(order));
    return place;
}

KeyPlace corridor_end() {
    return unless(stored_in(&Scene::motion, &MotionSpec::corridors, each, &Corridor::to),
                  [](const Scene& scene, const KeyAt& at) {
                      const MotionSpec& motion = scene.motion;
                      return at.entry[0] < motion.corridors.size() &&
                             motion.corridors[at.entry[0]].to == motion.length() * motion.unit_angle();
                  });
}

// A row is read as a row.
// clang-format off
/// Set points of the whole motion, or of a segment: `unit` is that of their locations.
template <class Places>
Rows set_points(const char* table, const char* unit, const Places& places) {
    static const std::string in_rise = "Where, in units of the rise (DRD 0 to 1, RR 0 to 1 + return/rise) or as "
                                       "a cam angle.";
    static const std::string in_segment = "Where, in units of the segment (0 to 1) or as a cam angle from its "
                                          "start.";
    const bool whole = std::string_view(unit) == "rise";
    return {
        called(whole ? "cam angle" : "cam angle from the segment's start", {table, "at", number, place, not_negative, {}, "needed by a point",
         whole ? in_rise : in_segment, places.begin(false)}),
        called("from cam angle", {table, "from", number, place, not_negative, {}, "needed by a region",
         "Where a region begins, in the units of `at`. Its `velocity` holds exactly from here to its end, and "
         "both are breakpoints of the spline.", places.from(), Availability::now, "at"}),
        called("to cam angle", {table, "to", number, place, not_negative, {}, "needed by a region",
         "Where the region ends.", places.until(), Availability::now, "at"}),
        {table, "displacement", number, spellings::displacement, any, {}, "free",
         "There; of a region where it begins. In lifts (s/lift) or in a unit of the lift.", places.displacement()},
        {table, "velocity", number, spellings::velocity, any, {}, "free",
         whole ? "There, or all along the region: dy/dx, by the cam angle, or in time (needs a speed)."
               : "There, or all along the region: lifts per segment, by the cam angle, or in time (needs a "
                 "speed).", places.velocity()},
        {table, "acceleration", number, spellings::acceleration, any, {}, "free",
         whole ? "There: d²y/dx², by the cam angle, or in time; not in a region, where it is 0."
               : "There: lifts per segment squared, by the cam angle, or in time; not in a region, where it is "
                 "0.", places.acceleration()},
    };
}

/// Velocity and acceleration at an end of the motion, or of a segment.
template <class Places>
Rows end_state(const char* table, const Places& places) {
    const bool joint = std::string_view(table) == "motion.segments.end";
    const char* const otherwise = joint ? "free" : "0";
    return {
        {table, "velocity", number, spellings::velocity, any, {}, otherwise,
         joint ? "There: lifts per segment, by the cam angle, or in time (needs a speed)."
               : "There: dy/dx (programs: lifts per segment), by the cam angle, or in time (needs a speed).",
         places.velocity()},
        {table, "acceleration", number, spellings::acceleration, any, {}, otherwise, "There, likewise.",
         places.acceleration()},
    };
}

Rows corridor() {
    constexpr const char* table = "motion.corridor";
    return {
        called("from cam angle", {table, "from", number, angle, not_negative, {}, "0 deg",
         "Where it begins, counted from the start of the motion; it holds there too.",
         stored_in(&Scene::motion, &MotionSpec::corridors, each, &Corridor::from)}),
        called("to cam angle", {table, "to", number, angle, positive, {}, "the end", "Where it ends; it holds there too.", corridor_end()}),
        {table, "displacement", bounds, spellings::displacement, any, {}, "none",
         "Bounds of the displacement, in lifts or in a unit of the lift.", corridor_bounds("displacement", 0)},
        {table, "velocity", bounds, spellings::velocity, any, {}, "none",
         "Bounds of the velocity: dy/dx (programs: x = 1 is the first spline segment), by the cam angle, or in "
         "time.", corridor_bounds("velocity", 1)},
        {table, "acceleration", bounds, spellings::acceleration, any, {}, "none",
         "Bounds of the acceleration, likewise.", corridor_bounds("acceleration", 2)},
        {table, "jerk", bounds, spellings::jerk, any, {}, "none", "Bounds of the jerk, likewise.",
         corridor_bounds("jerk", 3)},
    };
}
// clang-format on

}  // namespace

Rows points_of_motion() {
    const SetPointPlaces via(whole_angle, &Scene::motion, &MotionSpec::via, each);
    const SetPointPlaces start(first_angle, &Scene::motion, &MotionSpec::start);
    const SetPointPlaces end(last_angle, &Scene::motion, &MotionSpec::end);
    return joined(set_points("motion.via", "rise", via), end_state("motion.start", start),
                  end_state("motion.end", end));
}

Rows points_of_segments() {
    const SetPointPlaces of_segment(segment_angle, &Scene::motion, &MotionSpec::segments, each,
                                    &ProgramSegment::via, each_inner);
    const SetPointPlaces joint(segment_angle, &Scene::motion, &MotionSpec::segments, each,
                               &ProgramSegment::end);
    return joined(corridor(), set_points("motion.segments.via", "segment", of_segment),
                  end_state("motion.segments.end", joint));
}

}  // namespace camopt::key_rows
