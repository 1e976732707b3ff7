// SPDX-License-Identifier: MIT
// Valve lobes: every key in every unit, and what is refused.
#include "tests/input/broken_scenes.hpp"
#include "tests/input/scene_key_cases.hpp"

#include <functional>
#include <numbers>

namespace camopt::input {
namespace valve_cases_parts {

constexpr double degree = std::numbers::pi / 180.0;

/// A lobe without the lines that begin with these words.
std::string lobe(std::initializer_list<const char*> except, const std::string& more = "") {
    std::string text = "motion.type = \"valve\"\n" + more;
    for (const std::string line :
         {"motion.lift_mm = 10", "motion.duration_crank_deg = 240", "motion.checking_height_mm = 1",
          "motion.opening_ramp.height_mm = 0.3", "motion.opening_ramp.velocity_mm_deg = 0.01"}) {
        bool left_out = false;
        for (const char* const start : except) left_out = left_out || line.starts_with(start);
        if (!left_out) text += line + "\n";
    }
    return text;
}

std::vector<KeyCase> ramp_cases(const std::string& name,
                                const std::function<const ValveRamp&(const Scene&)>& ramp) {
    const std::string key = "motion." + name;
    const auto swinging = [&](const char* own) {
        std::string text =
            "motion.type = \"valve\"\nmotion.lift_mm = 10\nmotion.duration_crank_deg = 240\n"
            "motion.checking_height_mm = 1\nmotion.valve_arm_mm = 40\n";
        for (const char* const side : {"opening_ramp", "closing_ramp"})
            for (const auto& [member, value] :
                 {std::pair{"height", "height_deg = 0.5"}, {"velocity", "velocity_deg_deg = 0.02"}})
                if (name != side || std::string(member) != own)
                    text += std::string("motion.") + side + "." + value + "\n";
        return text;
    };
    const auto plain = [&](const char* own) {
        std::string text = lobe({"motion.opening_ramp"});
        for (const char* const side : {"opening_ramp", "closing_ramp"})
            for (const auto& [member, value] :
                 {std::pair{"height", "height_mm = 0.4"}, {"velocity", "velocity_mm_deg = 0.01"}})
                if (name != side || std::string(member) != own)
                    text += std::string("motion.") + side + "." + value + "\n";
        return text;
    };
    const auto height = [=](const Scene& s) { return ramp(s).height; };
    const auto velocity = [=](const Scene& s) { return ramp(s).velocity; };
    const auto end = [=](const Scene& s) { return ramp(s).end.value(); };
    const std::string by_height = plain("height"), by_velocity = plain("velocity");
    return {{key + ".height_mm", "0.3", 3e-4, height, by_height},
            {key + ".height_in", "0.01", 2.54e-4, height, by_height},
            {key + ".height_m", "0.0004", 4e-4, height, by_height},
            {key + ".height_deg", "0.5", 0.5 * degree, height, swinging("height")},
            {key + ".height_rad", "0.01", 0.01, height, swinging("height")},
            {key + ".velocity_mm_deg", "0.01", 1e-5 / degree, velocity, by_velocity},
            {key + ".velocity_in_deg", "0.0005", 1.27e-5 / degree, velocity, by_velocity},
            {key + ".velocity_mm_rad", "0.6", 6e-4, velocity, by_velocity},
            {key + ".velocity_in_rad", "0.03", 7.62e-4, velocity, by_velocity},
            {key + ".velocity_deg_deg", "0.02", 0.02, velocity, swinging("velocity")},
            {key + ".end_deg", "3", 3 * degree, end, plain("end")},
            {key + ".end_rad", "0.05", 0.05, end, plain("end")},
            {key + ".end_crank_deg", "6", 3 * degree, end, plain("end")}};
}

}  // namespace valve_cases_parts

std::vector<KeyCase> valve_cases() {
    using namespace valve_cases_parts;
    const auto of = [](double ValveSpec::*member) {
        return [member](const Scene& s) { return s.motion.valve.value().*member; };
    };
    const std::string whole = lobe({}), no_duration = lobe({"motion.duration"}),
                      no_height = lobe({"motion.checking"});
    const auto duration = of(&ValveSpec::duration), opening = of(&ValveSpec::opening),
               checking = of(&ValveSpec::checking_height), lash = of(&ValveSpec::lash);
    const auto centerline = [](const Scene& s) { return s.motion.valve.value().centerline.value(); };
    const auto speed = [](const Scene& s) { return s.motion.speed.value(); };
    const std::string arm =
        "motion.type = \"valve\"\nmotion.lift_mm = 10\nmotion.duration_crank_deg = 240\n"
        "motion.checking_height_mm = 1\nmotion.opening_ramp.height_deg = 0.5\n"
        "motion.opening_ramp.velocity_deg_deg = 0.02\n";
    std::vector<KeyCase> all = {
        {"motion.duration_deg", "120", 120 * degree, duration, no_duration},
        {"motion.duration_rad", "2", 2, duration, no_duration},
        {"motion.duration_crank_deg", "240", 120 * degree, duration, no_duration},
        {"motion.checking_height_mm", "1", 1e-3, checking, no_height},
        {"motion.checking_height_in", "0.05", 1.27e-3, checking, no_height},
        {"motion.checking_height_m", "0.001", 1e-3, checking, no_height},
        {"motion.lash_mm", "0.2", 2e-4, lash, whole},
        {"motion.lash_in", "0.01", 2.54e-4, lash, whole},
        {"motion.lash_m", "0.0002", 2e-4, lash, whole},
        {"motion.rocker_ratio", "1.5", 1.5, of(&ValveSpec::ratio), whole},
        {"motion.valve_arm_mm", "40", 0.04, of(&ValveSpec::ratio), arm},
        {"motion.valve_arm_in", "2", 0.0508, of(&ValveSpec::ratio), arm},
        {"motion.valve_arm_m", "0.05", 0.05, of(&ValveSpec::ratio), arm},
        {"motion.opening_deg", "58", 58 * degree, opening, whole},
        {"motion.opening_rad", "1", 1, opening, whole},
        {"motion.opening_crank_deg", "116", 58 * degree, opening, whole},
        {"motion.centerline_deg", "54", 54 * degree, centerline, whole},
        {"motion.centerline_rad", "1", 1, centerline, whole},
        {"motion.centerline_crank_deg", "-112", -56 * degree, centerline, whole},
        {"motion.engine_speed_rpm", "6000", 100 * std::numbers::pi, speed, whole},
        {"motion.engine_speed_rad_s", "600", 300, speed, whole},
    };
    for (const KeyCase& one : ramp_cases("opening_ramp", [](const Scene& s) -> const ValveRamp& {
             return s.motion.valve.value().opening_ramp;
         }))
        all.push_back(one);
    for (const KeyCase& one : ramp_cases("closing_ramp", [](const Scene& s) -> const ValveRamp& {
             return s.motion.valve.value().closing_ramp;
         }))
        all.push_back(one);
    return all;
}

std::vector<BrokenScene> broken_valves() {
    using namespace valve_cases_parts;
    const std::string jerk = "objective.jerk = 1\n";
    return {
        {"valve_without_duration", jerk + lobe({"motion.duration"}),
         "s.toml:2:1: motion.duration: missing; allowed: needed by type \"valve\""},
        {"valve_lift_as_angle", jerk + lobe({"motion.lift"}, "motion.lift_deg = 10\n"),
         "s.toml:3:19: motion.lift_deg: found an angle; allowed: a length, the lift of the valve"},
        {"valve_with_segments",
         jerk + lobe({}, "motion.segments = [{ kind = \"dwell\", angle_deg = 360 }]\n"),
         "s.toml:3:8: motion.segments: found this key in a motion of type \"valve\"; allowed: only in other "
         "types; a valve lobe is said by lift, duration and ramps"},
        {"lash_without_valve", jerk + "motion.type = \"RR\"\nmotion.lash_mm = 0.2\n",
         "s.toml:3:8: motion.lash_mm: found this key in a motion of type \"RR\"; allowed: only in type "
         "\"valve\""},
        {"checking_above_lift", jerk + lobe({"motion.checking"}, "motion.checking_height_mm = 11\n"),
         "s.toml:3:29: motion.checking_height_mm: found a height that the valve does not reach; allowed: a "
         "height "
         "below the lift"},
        {"ramp_end_on_ramp",
         jerk +
             lobe({"motion.checking"}, "motion.checking_height_mm = 0.25\nmotion.opening_ramp.end_deg = 2\n"),
         "s.toml:4:31: motion.opening_ramp.end_deg: found an angle where the checking point lies on the "
         "ramp, which "
         "says where it ends; allowed: no such key, or a ramp below the checking point"},
        {"ramp_end_too_far", jerk + lobe({}, "motion.opening_ramp.end_deg = 80\n"),
         "s.toml:3:31: motion.opening_ramp.end_deg: found 80 deg; allowed: above 0 and below 70 deg, where "
         "the "
         "ramp's velocity alone reaches the checking point"},
        {"ramp_in_degrees",
         jerk + lobe({"motion.opening_ramp.height"}, "motion.opening_ramp.height_deg = 0.4\n"),
         "s.toml:3:21: motion.opening_ramp.height_deg: found an angle; allowed: a length"},
        {"valve_longer_than_turn", jerk + lobe({"motion.duration"}, "motion.duration_crank_deg = 640\n"),
         "s.toml:3:29: motion.duration_crank_deg: found a lobe that takes 456.491 cam deg with its ramps; "
         "allowed: "
         "ramps and duration of less than one cam revolution: lower or faster ramps"},
    };
}

}  // namespace camopt::input
