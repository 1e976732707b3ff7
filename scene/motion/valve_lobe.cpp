// SPDX-License-Identifier: MIT
#include "scene/faults/scene_faults.hpp"
#include "scene/key_row.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr double constant_part = 2.0 / 3.0;  // of a ramp's height
// Of the flank up to the checking point, where nothing else is given: lifts by the angle from there to the
// nose.
constexpr double typical_jerk = 60.0, typical_acceleration = 4.0;
constexpr int bisections = 100;
constexpr double shortest_dwell = 1e-6;  // rad

/// One side of the lobe, from the base circle to the nose.
struct LobeSide {
    const ValveRamp& ramp;
    double checking = 0.0;  ///< the follower there
    double angle = 0.0;     ///< from it to the nose
    double nose = 0.0;      ///< the follower there

    [[nodiscard]] double start_of_constant() const { return (1.0 - constant_part) * ramp.height; }
    /// Of the spline from rest, and of the constant velocity: the mean velocity of the first is half as
    /// large.
    [[nodiscard]] double part_angle() const { return constant_part * ramp.height / ramp.velocity; }
    [[nodiscard]] bool checked_above() const { return checking > ramp.height; }
    /// From the ramp's end to the checking point; negative where that lies on the ramp.
    [[nodiscard]] double before_checking() const {
        const double way = checking - ramp.height;
        if (!checked_above()) return way / ramp.velocity;
        return ramp.end ? *ramp.end : typical_angle(way);
    }
    /// That takes the follower so far beyond the ramp.
    [[nodiscard]] double typical_angle(double way) const {
        const double jerk = typical_jerk * nose / std::pow(angle, 3);
        const double bend = typical_acceleration * nose / (angle * angle), growth = bend / jerk;
        const auto is_within = [&](double on) {
            const double first = std::min(on, growth), rest = on - first;
            const double grown = jerk * first * first * (first / 6.0 + rest / 2.0) + bend * rest * rest / 2.0;
            return ramp.velocity * on + grown <= way;
        };
        return bisected(is_within, {0.0, way / ramp.velocity}, bisections).with;
    }
    [[nodiscard]] double flank_angle() const { return angle + before_checking(); }
    [[nodiscard]] double total_angle() const { return flank_angle() + 2.0 * part_angle(); }
};

SetPoint checking_point(double at, double flank, double displacement, bool angle) {
    SetPoint point;
    point.at = at / flank;
    point.displacement = displacement;
    point.units.place = "deg";
    point.units.displacement = angle ? "deg" : "mm";
    return point;
}

LobeSide opening_side(const ValveSpec& valve) {
    return {valve.opening_ramp, valve.follower(valve.checking_height), valve.opening,
            valve.follower(valve.lift)};
}

LobeSide closing_side(const ValveSpec& valve) {
    return {valve.closing_ramp, valve.follower(valve.checking_height), valve.closing(),
            valve.follower(valve.lift)};
}

Fault side_fault(const LobeSide& side, const std::string& ramp, double nose) {
    const auto fault = [&](const char* name, std::string found, std::string allowed) {
        return SceneFault{fmt::format("motion.{}.{}", ramp, name), std::move(found), std::move(allowed)};
    };
    const auto per_nose = [&](double share) {
        return fmt::format("{:.6g} of the lobe's lift", share / nose);
    };
    if (!(side.ramp.height > 0.0 && side.ramp.height < nose))
        return fault("height", per_nose(side.ramp.height), "a height above 0 and below the lobe's lift");
    if (!(side.ramp.velocity > 0.0))
        return fault("velocity", fmt::format("{}", side.ramp.velocity), ranges::positive.number_text());
    if (side.checking < side.start_of_constant())
        return fault(
            "height",
            fmt::format("a ramp that has its velocity from {} on, with lash and checking height at {}",
                        per_nose(side.start_of_constant()), per_nose(side.checking)),
            "a ramp up to three times as high as the checking point (checking height + lash, at the "
            "follower)");
    if (side.ramp.end && !side.checked_above())
        return fault("end", "an angle where the checking point lies on the ramp, which says where it ends",
                     "no such key, or a ramp below the checking point");
    const double reach = (side.checking - side.ramp.height) / side.ramp.velocity;
    if (side.ramp.end && !(*side.ramp.end > 0.0 && *side.ramp.end < reach))
        return fault("end", fmt::format("{:.6g} deg", *side.ramp.end / units::degree),
                     fmt::format("above 0 and below {:.6g} deg, where the ramp's velocity alone reaches the "
                                 "checking point",
                                 reach / units::degree));
    return std::nullopt;
}

}  // namespace

std::optional<SceneFault> find_valve_fault(const ValveSpec& valve) {
    const auto positive = [](double value, const char* member) -> Fault {
        if (std::isfinite(value) && value > 0.0) return std::nullopt;
        return SceneFault{member, fmt::format("{}", value), ranges::positive.number_text()};
    };
    for (const auto& [value, member] : {std::pair{valve.lift, "motion.lift"},
                                        {valve.ratio, "motion.rocker_ratio"},
                                        {valve.checking_height, "motion.checking_height"},
                                        {valve.duration, "motion.duration"}})
        if (Fault fault = positive(value, member)) return fault;
    if (!(valve.lash >= 0.0))
        return SceneFault{"motion.lash", fmt::format("{}", valve.lash), ranges::not_negative.number_text()};
    if (!(valve.checking_height < valve.lift))
        return SceneFault{"motion.checking_height", "a height that the valve does not reach",
                          "a height below the lift"};
    if (!(valve.opening > 0.0 && valve.closing() > 0.0))
        return SceneFault{
            "motion.opening", fmt::format("{:.6g} cam deg", valve.opening / units::degree),
            fmt::format("above 0 and below the duration, {:.6g} cam deg", valve.duration / units::degree)};
    const double nose = valve.follower(valve.lift);
    if (Fault fault = side_fault(opening_side(valve), "opening_ramp", nose)) return fault;
    if (Fault fault = side_fault(closing_side(valve), "closing_ramp", nose)) return fault;
    const double total = opening_side(valve).total_angle() + closing_side(valve).total_angle();
    if (!(total < units::turn - shortest_dwell))
        return SceneFault{
            "motion.duration",
            fmt::format("a lobe that takes {:.6g} cam deg with its ramps", total / units::degree),
            "ramps and duration of less than one cam revolution: lower or faster ramps"};
    return std::nullopt;
}

double nose_angle(const ValveSpec& valve) {
    return opening_side(valve).total_angle();
}

void make_valve_lobe(MotionSpec& motion, const ValveSpec& valve) {
    if (const std::optional<SceneFault> fault = find_valve_fault(valve)) throw SceneError(*fault);
    const LobeSide opening = opening_side(valve), closing = closing_side(valve);
    motion.type = MotionType::program;
    motion.closed = motion.monotone = true;
    motion.lift = valve.follower(valve.lift);
    motion.valve = valve;
    const double lift = motion.lift;
    const auto spline = [](double angle, double to) {
        ProgramSegment segment;
        segment.kind = SegmentKind::spline;
        segment.angle = angle;
        segment.to = to;
        return segment;
    };
    const auto law = [&](const LobeSide& side, const char* key, double to) {
        ProgramSegment segment = spline(side.part_angle(), to / lift);
        segment.kind = SegmentKind::law;
        segment.law = key;
        return segment;
    };
    ProgramSegment up = spline(opening.flank_angle(), 1.0);
    ProgramSegment down = spline(closing.flank_angle(), closing.ramp.height / lift);
    if (opening.checked_above())
        up.via = {checking_point(opening.before_checking(), up.angle, opening.checking / lift,
                                 motion.lift_is_angle)};
    if (closing.checked_above())
        down.via = {checking_point(closing.angle, down.angle, closing.checking / lift, motion.lift_is_angle)};
    up.end = SetPoint{.at = 1.0, .velocity = 0.0};
    ProgramSegment dwell;
    dwell.angle = units::turn - opening.total_angle() - closing.total_angle();
    motion.segments = {law(opening, "run_in", opening.start_of_constant()),
                       law(opening, "constant_velocity", opening.ramp.height),
                       std::move(up),
                       std::move(down),
                       law(closing, "constant_velocity", closing.start_of_constant()),
                       law(closing, "run_out", 0.0),
                       dwell};
}

}  // namespace camopt
