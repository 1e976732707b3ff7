// SPDX-License-Identifier: MIT
// Set points, regions, searched angles and moving laws that must be refused.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_set_points_parts {

/// Five lines; via follows.
const std::string rise =
    "objective.jerk = 1\n"
    "[motion]\n"
    "type = \"DRD\"\n"
    "lift_mm = 10\n"
    "rise_deg = 120\n";

/// A turn of 360 deg but for what follows on line 9: a segment of 120 deg.
const std::string turn =
    "objective.jerk = 1\n"
    "[motion]\n"
    "type = \"program\"\n"
    "lift_mm = 10\n"
    "segments = [\n"
    "{ kind = \"dwell\", angle_deg = 140 },\n"
    "{ kind = \"spline\", angle_deg = 50, to = 1 },\n"
    "{ kind = \"spline\", angle_deg = 50, to = 0 },\n";

}  // namespace broken_set_points_parts

std::vector<BrokenScene> broken_set_points() {
    using namespace broken_set_points_parts;
    return {
        {"point_beyond_the_rise", rise + "via = [{ at_deg = 130, displacement = 1 }]\n",
         "s.toml:6:19: motion.via[0].at_deg: found 130 deg; allowed: a location from 0 to 120 deg"},
        {"point_without_a_speed", rise + "via = [{ at_deg = 30, velocity_mm_s = 1 }]\n",
         "s.toml:6:23: motion.via[0].velocity_mm_s: found a value in mm/s without a speed; allowed: together "
         "with "
         "motion.speed_rpm or motion.speed_rad_s, or by the cam angle (velocity_mm_rad)"},
        {"point_in_another_unit", rise + "via = [{ at_deg = 30, velocity_deg_deg = 1 }]\n",
         "s.toml:6:23: motion.via[0].velocity_deg_deg: found a value in deg/deg where the lift is a length; "
         "allowed: a "
         "unit with mm, in or m, or a normalised value"},
        {"point_displacement_in_deg", rise + "via = [{ at_deg = 30, displacement_deg = 1 }]\n",
         "s.toml:6:23: motion.via[0].displacement_deg: found displacement_deg where the lift is a length; "
         "allowed: "
         "displacement, displacement_mm, displacement_in or displacement_m"},
        {"region_without_an_end", rise + "via = [{ from_deg = 30, velocity = 1 }]\n",
         "s.toml:6:8: motion.via[0].to: missing; allowed: both ends of a region, from and to"},
        {"region_without_velocity", rise + "via = [{ from_deg = 30, to_deg = 50 }]\n",
         "s.toml:6:8: motion.via[0]: found a region without a velocity; allowed: the velocity that holds "
         "from its "
         "beginning to its end"},
        {"region_with_acceleration",
         rise + "via = [{ from_deg = 30, to_deg = 50, velocity = 1, acceleration = 0 }]\n",
         "s.toml:6:67: motion.via[0].acceleration: found an acceleration in a region of constant velocity; "
         "allowed: "
         "none: it is 0 there"},
        {"region_backwards", rise + "via = [{ from_deg = 50, to_deg = 30, velocity = 1 }]\n",
         "s.toml:6:34: motion.via[0].to_deg: found 30 deg; allowed: a location after 50 deg, where the "
         "region "
         "begins"},
        {"regions_overlap",
         rise + "via = [{ from_deg = 30, to_deg = 50, velocity = 1 }, { from_deg = 45, to_deg = 60, velocity "
                "= 1 }]\n",
         "s.toml:6:67: motion.via[1].from_deg: found 45 deg to 60 deg, which overlaps motion.via[0]; "
         "allowed: regions "
         "that do not overlap"},
        {"region_free_knots",
         rise + "via = [{ from_deg = 30, to_deg = 50, velocity = 1 }]\n[spline]\nknots = \"free\"\n",
         "s.toml:8:9: spline.knots: found \"free\" with a region of constant velocity, whose ends are knots; "
         "allowed: "
         "\"fixed\", or exact points alone"},
        {"segment_point_at_its_end",
         turn + "{ kind = \"spline\", angle_deg = 120, to = 0, via = [{ at_deg = 120, velocity = 0 }] }]\n",
         "s.toml:9:63: motion.segments[3].via[0].at_deg: found 120 deg; allowed: a location after 0 and "
         "before "
         "120 deg, "
         "the end of the segment"},
        {"segment_region_from_a_dwell",
         "objective.jerk = 1\n[motion]\ntype = \"program\"\nclosed = false\nsegments = [\n"
         "{ kind = \"dwell\", angle_deg = 60 },\n"
         "{ kind = \"spline\", angle_deg = 60, to = 1, via = [{ from = 0, to = 0.5, velocity = 1 }] }]\n",
         "s.toml:7:60: motion.segments[1].via[0].from: found 0; allowed: a location after 0, where "
         "segments[0], a dwell, gives the velocity"},
        {"end_state_of_a_closed_program",
         turn.substr(0, turn.find("segments")) + "end = { velocity = 1 }\n" +
             turn.substr(turn.find("segments")) + "{ kind = \"dwell\", angle_deg = 120 }]\n",
         "s.toml:5:7: motion.end: found a state in a program that goes on where it ends; allowed: "
         "motion.closed = false, or set points in its segments"},
        {"state_next_to_a_dwell",
         "objective.jerk = 1\n[motion]\ntype = \"program\"\nclosed = false\nsegments = [\n"
         "{ kind = \"spline\", angle_deg = 60, to = 1, end = { velocity = 0 } },\n"
         "{ kind = \"dwell\", angle_deg = 20 }]\n",
         "s.toml:6:50: motion.segments[0].end: found a state between segments of kind \"spline\" and "
         "\"dwell\"; allowed: only between two segments of kind \"spline\": dwells and laws give the state "
         "where they join"},
        {"corridor_backwards",
         "objective.jerk = 1\n[motion]\ntype = \"DRD\"\nrise_deg = 90\n"
         "corridor = [{ from_deg = 50, to_deg = 40, displacement = { max = 0.5 } }]\n",
         "s.toml:5:13: motion.corridor[0]: found a stretch from 50 to 40 deg; allowed: from below to, both "
         "from 0 to 90 deg"},
        {"corridor_without_bound",
         "objective.jerk = 1\n[motion]\ntype = \"DRD\"\nrise_deg = 90\ncorridor = [{ from_deg = 50 }]\n",
         "s.toml:5:13: motion.corridor[0]: found no bound; allowed: min or max of displacement, velocity, "
         "acceleration or jerk"},
        {"corridor_of_a_length_for_an_angle",
         "objective.jerk = 1\n[motion]\ntype = \"DRD\"\nlift_deg = 30\n"
         "corridor = [{ velocity_mm_deg = { max = 0.5 } }]\n",
         "s.toml:5:15: motion.corridor[0].velocity_mm_deg: found a value in mm/deg where the lift is an "
         "angle; allowed: a unit with deg or rad, or a normalised value"},
        {"limit_of_one_side_upside_down",
         "objective.jerk = 1\n[motion]\ntype = \"DRD\"\n[limits]\nvelocity = { min = 2, max = 1 }\n",
         "s.toml:5:12: limits.velocity: found a range from 2 to 1; allowed: min below max"},
        {"load_backwards",
         "objective.jerk = 1\n[motion]\ntype = \"DRD\"\nspeed_rpm = 60\n[cam]\ntype = \"disk\"\n"
         "follower = \"translating_flat\"\nbase_radius_mm = 20\n[forces]\nload_n = [[20, 5], [10, 6]]\n",
         "s.toml:10:20: forces.load_n[1]: found the angle 10; allowed: a pair [angle, number], the angles "
         "ascending"},
        {"repeat_of_an_open_program",
         "objective.jerk = 1\n[motion]\ntype = \"program\"\nclosed = false\nrepeat = 2\n"
         "segments = [{ kind = \"spline\", angle_deg = 60, to = 1 }]\n",
         "s.toml:5:10: motion.repeat: found 2 in a program that is not closed; allowed: 1, or motion.closed "
         "= true"},
        {"stops_and_a_lift", "objective.jerk = 1\n[motion]\ntype = \"DRD\"\nlift_deg = 45\nstops = 8\n",
         "s.toml:5:1: motion.stops: found together with motion.lift_deg, which means the same; allowed: only "
         "one of the two"},
        {"segment_point_in_a_dwell",
         turn + "{ kind = \"dwell\", angle_deg = 120, via = [{ at = 0.5, velocity = 0 }] }]\n",
         "s.toml:9:42: motion.segments[3].via: found set points in a segment of kind \"dwell\"; allowed: "
         "only in kind "
         "\"spline\""},
        {"angles_that_cannot_add_up",
         "objective.jerk = 1\n[motion]\ntype = \"program\"\nsegments = [\n"
         "{ kind = \"spline\", angle_deg = { min = 60, max = 90 }, to = 1 },\n"
         "{ kind = \"spline\", angle_deg = { min = 60, max = 90 }, to = 0 }]\n",
         "s.toml:5:32: motion.segments[0].angle_deg: found ranges that let the angles add up to 120 to 180 "
         "deg; "
         "allowed: ranges with 360 deg between"},
        {"one_angle_range", turn + "{ kind = \"dwell\", angle_deg = { min = 60, max = 190 } }]\n",
         "s.toml:9:31: motion.segments[3].angle_deg: found the only range of the program; allowed: a number: "
         "the angles "
         "add up to 360 deg, so at least two ranges are needed"},
        {"measured_without_table", rise + "[measured]\nuse = \"start\"\n",
         "s.toml:6:1: measured.table: missing; allowed: table, or s_mm with theta_deg or step_deg"},
        {"measured_columns_without_table",
         rise + "[measured]\ncolumns = [\"s_mm\"]\nstep_deg = 1\ns_mm = [0]\n",
         "s.toml:7:1: measured.columns: found without a file; allowed: only with measured.table"},
        {"measured_zero_word", rise + "[measured]\ntable = \"m.csv\"\nzero = \"top\"\n",
         "s.toml:8:8: measured.zero: found \"top\"; allowed: \"start\" or \"nose\", or a table"},
        {"measured_twice", rise + "[measured]\ntable = \"m.csv\"\ns_mm = [0]\n",
         "s.toml:8:1: measured.s_mm: found together with measured.table, which means the same; allowed: only "
         "one of "
         "the two"},
    };
}

}  // namespace camopt::input
