// SPDX-License-Identifier: MIT
// Programs: keys of other motions, segments wrong in themselves, angles, ends.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_programs_parts {

/// Four lines; the segments follow.
const std::string program =
    "objective.jerk = 1\n"
    "[motion]\n"
    "type = \"program\"\n"
    "lift_mm = 80\n";

/// A dwell and a rise, 180 deg; line 10 follows.
const std::string rise =
    "objective.jerk = 1\n"
    "[motion]\n"
    "type = \"program\"\n"
    "lift_mm = 80\n"
    "[[motion.segments]]\n"
    "kind = \"dwell\"\n"
    "angle_deg = 60\n"
    "[[motion.segments]]\n"
    "kind = \"spline\"\n"
    "angle_deg = 120\n"
    "to = 1\n";

}  // namespace broken_programs_parts

std::vector<BrokenScene> broken_programs() {
    using namespace broken_programs_parts;
    return {
        {"program_rise", program + "rise_deg = 90\n",
         "s.toml:5:1: motion.rise_deg: found this key in a motion of type \"program\"; allowed: only in type "
         "\"DRD\" or \"RR\"; a program says the angle of each of its segments"},
        {"program_return", program + "return_rad = 1\n",
         "s.toml:5:1: motion.return_rad: found this key in a motion of type \"program\"; allowed: only in "
         "type \"DRD\" or \"RR\"; a program says the angle of each of its segments"},
        {"program_symmetric", program + "symmetric = false\n",
         "s.toml:5:1: motion.symmetric: found this key in a motion of type \"program\"; allowed: only in "
         "type \"DRD\" or \"RR\""},
        {"program_via", program + "via = [{ at = 0.5, velocity = 1 }]\n",
         "s.toml:5:1: motion.via: found this key in a motion of type \"program\"; allowed: only in type "
         "\"DRD\" or \"RR\"; a program has set points in its segments, via in each"},
        {"program_in_drd",
         "objective.jerk = 1\n"
         "[motion]\n"
         "type = \"DRD\"\n"
         "[[motion.segments]]\n"
         "kind = \"spline\"\n"
         "angle_deg = 90\n",
         "s.toml:4:10: motion.segments: found this key in a motion of type \"DRD\"; allowed: only in type "
         "\"program\""},
        {"program_closed_in_rr",
         "objective.jerk = 1\n"
         "[motion]\n"
         "type = \"RR\"\n"
         "closed = true\n",
         "s.toml:4:1: motion.closed: found this key in a motion of type \"RR\"; allowed: only in type "
         "\"program\""},
        {"program_without_segments", program,
         "s.toml:2:1: motion.segments: found no segment; allowed: the segments of the program"},
        {"program_no_segment", program + "segments = []\n",
         "s.toml:5:12: motion.segments: found no segment; allowed: the segments of the program"},
        {"program_segments_number", program + "segments = 3\n",
         "s.toml:5:12: motion.segments: found 3; allowed: an array of tables"},
        {"program_segment_number", program + "segments = [3]\n",
         "s.toml:5:13: motion.segments[0]: found 3; allowed: a table of kind, angle_deg, angle_rad, "
         "angle_crank_deg, law, to, "
         "to_mm, to_in, to_m, to_deg, to_rad, end, via"},
        {"program_segment_empty", program + "segments = [{}]\n",
         "s.toml:5:13: motion.segments[0].kind: missing; allowed: \"dwell\", \"law\" or \"spline\""},
        {"program_kind_missing",
         program + "[[motion.segments]]\n"
                   "angle_deg = 60\n",
         "s.toml:5:1: motion.segments[0].kind: missing; allowed: \"dwell\", \"law\" or \"spline\""},
        {"program_kind_unknown",
         program + "[[motion.segments]]\n"
                   "kind = \"rise\"\n"
                   "angle_deg = 60\n",
         "s.toml:6:8: motion.segments[0].kind: found \"rise\"; allowed: \"dwell\", \"law\" or \"spline\""},
        {"program_angle_missing",
         program + "[[motion.segments]]\n"
                   "kind = \"dwell\"\n",
         "s.toml:5:1: motion.segments[0].angle_deg: missing; allowed: a number > 0 and <= 360, or a range { "
         "min "
         "= …, max = … }"},
        {"program_angle_zero",
         program + "[[motion.segments]]\n"
                   "kind = \"dwell\"\n"
                   "angle_deg = 0\n",
         "s.toml:7:13: motion.segments[0].angle_deg: found 0; allowed: a number > 0 and <= 360, or a range { "
         "min = …, max = … }"},
        {"program_angle_over_turn",
         program + "[[motion.segments]]\n"
                   "kind = \"spline\"\n"
                   "angle_rad = 7\n",
         "s.toml:7:13: motion.segments[0].angle_rad: found 7; allowed: a number > 0 and <= "
         "6.283185307179586, or a range { min = …, max = … }"},
        {"program_angle_twice",
         program + "[[motion.segments]]\n"
                   "kind = \"spline\"\n"
                   "angle_rad = 1\n"
                   "angle_deg = 1\n",
         "s.toml:8:1: motion.segments[0].angle_deg: found together with motion.segments[0].angle_rad, which "
         "means "
         "the same; allowed: only one of the two"},
        {"program_angle_without_unit",
         program + "[[motion.segments]]\n"
                   "kind = \"spline\"\n"
                   "angle = 1\n",
         "s.toml:7:1: motion.segments[0].angle: found an unknown key; allowed: kind, angle_deg, angle_rad, "
         "angle_crank_deg, law, to, to_mm, to_in, to_m, to_deg, to_rad, end, via; did you mean 'angle_deg'?"},
        {"program_segment_key_unknown",
         program + "[[motion.segments]]\n"
                   "kind = \"spline\"\n"
                   "angle_deg = 360\n"
                   "velocity = 1\n",
         "s.toml:8:1: motion.segments[0].velocity: found an unknown key; allowed: kind, angle_deg, "
         "angle_rad, angle_crank_deg, law, to, to_mm, to_in, to_m, to_deg, to_rad, end, via; did you mean "
         "'motion.via.velocity'?"},
        {"program_law_missing",
         rise + "[[motion.segments]]\n"
                "kind = \"law\"\n"
                "angle_deg = 180\n",
         "s.toml:12:1: motion.segments[2].law: found no law in a segment of kind \"law\"; allowed: a law of "
         "the catalogue"},
        {"program_law_unknown",
         rise + "[[motion.segments]]\n"
                "kind = \"law\"\n"
                "law = \"cycloydal\"\n"
                "angle_deg = 180\n",
         "s.toml:14:7: motion.segments[2].law: found \"cycloydal\"; allowed: a law of the catalogue: "
         "\"cycloidal\", \"modified_sine\"; did you mean 'cycloidal'?"},
        {"program_law_in_spline",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "law = \"cycloidal\"\n"
                "angle_deg = 180\n",
         "s.toml:14:7: motion.segments[2].law: found \"cycloidal\" in a segment of kind \"spline\"; allowed: "
         "a law only in kind \"law\""},
        {"program_law_in_dwell",
         rise + "[[motion.segments]]\n"
                "kind = \"dwell\"\n"
                "law = \"cycloidal\"\n"
                "angle_deg = 180\n",
         "s.toml:14:7: motion.segments[2].law: found \"cycloidal\" in a segment of kind \"dwell\"; allowed: "
         "a law only in kind \"law\""},
        {"program_to_in_dwell",
         rise + "[[motion.segments]]\n"
                "kind = \"dwell\"\n"
                "to = 1\n"
                "angle_deg = 180\n",
         "s.toml:14:6: motion.segments[2].to: found a displacement in a segment of kind \"dwell\"; allowed: "
         "only in kind \"law\" or \"spline\"; a dwell keeps its displacement"},
        {"program_to_nan",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "to = nan\n"
                "angle_deg = 180\n",
         "s.toml:14:6: motion.segments[2].to: found nan; allowed: a finite number"},
        {"program_to_twice",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "to = 0\n"
                "to_mm = 0\n"
                "angle_deg = 180\n",
         "s.toml:15:1: motion.segments[2].to_mm: found together with motion.segments[2].to, which means the "
         "same; "
         "allowed: only one of the two"},
        {"program_to_angle_for_length",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "to_deg = 10\n"
                "angle_deg = 180\n",
         "s.toml:14:1: motion.segments[2].to_deg: found to_deg where the lift is a length; allowed: to, "
         "to_mm, to_in or to_m"},
        {"program_to_length_for_angle",
         "objective.jerk = 1\n"
         "[motion]\n"
         "type = \"program\"\n"
         "lift_deg = 8\n"
         "segments = [{ kind = \"spline\", angle_deg = 360, to_in = 1 }]\n",
         "s.toml:5:49: motion.segments[0].to_in: found to_in where the lift is an angle; allowed: to, to_deg "
         "or to_rad"},
        {"program_only_dwells",
         program + "[[motion.segments]]\n"
                   "kind = \"dwell\"\n"
                   "angle_deg = 360\n",
         "s.toml:5:1: motion.segments: found dwells only; allowed: at least one segment with kind = \"law\" "
         "or "
         "kind = \"spline\""},
        {"program_only_laws",
         program + "[[motion.segments]]\n"
                   "kind = \"law\"\n"
                   "angle_deg = 360\n"
                   "law = \"cycloidal\"\n",
         "s.toml:5:1: motion.segments[0].to: found no displacement, in a program of laws and dwells only; "
         "allowed: the displacement at its end: nothing is optimised that could choose it"},
        {"program_turn_not_full",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 170\n",
         "s.toml:5:1: motion.segments: found angles that add up to 350 deg; allowed: 360 deg, or "
         "motion.closed = false for part of a revolution"},
        {"program_turn_exceeded",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 180.000001\n",
         "s.toml:5:1: motion.segments: found angles that add up to 360.000001 deg; allowed: 360 deg, or "
         "motion.closed = false for part of a revolution"},
        {"program_open_turn_exceeded",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 190\n",
         "s.toml:5:1: motion.segments: found angles that add up to 370 deg; allowed: at most 360 deg, one "
         "revolution",
         {"motion.closed=false"}},
        {"program_ends_high",
         rise + "[[motion.segments]]\n"
                "kind = \"dwell\"\n"
                "angle_deg = 180\n",
         "s.toml:11:6: motion.segments[1].to: found a closed program that ends at 1 lifts; allowed: 0, where "
         "it began, or no `to`, or motion.closed = false"},
        {"program_ends_high_law",
         rise + "[[motion.segments]]\n"
                "kind = \"law\"\n"
                "law = \"cycloidal\"\n"
                "to_mm = 20\n"
                "angle_deg = 90\n"
                "[[motion.segments]]\n"
                "kind = \"dwell\"\n"
                "angle_deg = 90\n",
         "s.toml:15:9: motion.segments[2].to_mm: found a closed program that ends at 0.25 lifts; allowed: 0, "
         "where it began, or no `to`, or motion.closed = false"},
        {"program_breakpoints_of_turn",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 180\n"
                "[spline]\n"
                "breakpoints = [0, 1, 3]\n",
         "s.toml:16:22: spline.breakpoints[2]: found 3; allowed: 1, the end of a segment"},
        {"program_breakpoints_short",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 180\n"
                "[spline]\n"
                "breakpoints = [0, 0.5, 0.9]\n",
         "s.toml:16:24: spline.breakpoints[2]: found 0.9; allowed: 1, the end of a segment"},
        {"program_breakpoints_start",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 180\n"
                "[spline]\n"
                "breakpoints = [0.1, 1]\n",
         "s.toml:16:16: spline.breakpoints[0]: found 0.1; allowed: 0, the start of a segment"},
        {"program_limit_without_speed",
         rise + "[[motion.segments]]\n"
                "kind = \"spline\"\n"
                "angle_deg = 180\n"
                "[limits]\n"
                "velocity_mm_s = 100\n",
         "s.toml:16:1: limits.velocity_mm_s: found a limit in mm/s without a speed; allowed: together with "
         "motion.speed_rpm or motion.speed_rad_s"},
    };
}

}  // namespace camopt::input
