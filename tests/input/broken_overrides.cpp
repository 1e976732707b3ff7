// SPDX-License-Identifier: MIT
// Overrides that cannot be applied or make a good scene wrong.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace broken_overrides_parts {

constexpr const char* plain_scene = "title = \"x\"\n[motion]\ntype = \"DRD\"\n[objective]\njerk = 1\n";

constexpr const char* program_scene =
    "[objective]\njerk = 1\n[motion]\ntype = \"program\"\n"
    "[[motion.segments]]\nkind = \"dwell\"\nangle_deg = 60\n"
    "[[motion.segments]]\nkind = \"spline\"\nangle_deg = 300\n";
constexpr const char* cam_scene =
    "[motion]\ntype = \"DRD\"\n[objective]\njerk = 1\n"
    "[cam]\ntype = \"disk\"\nfollower = \"translating_knife\"\nbase_radius_mm = 40\n";

}  // namespace broken_overrides_parts

std::vector<BrokenScene> broken_overrides() {
    using namespace broken_overrides_parts;
    return {
        {"set_no_equals",
         plain_scene,
         "--set motion.rise_deg: found no '='; allowed: KEY=VALUE, for example motion.rise_deg=90 or "
         "motion.segments[1].to=0.5",
         {"motion.rise_deg"}},
        {"set_no_key",
         plain_scene,
         "--set =3: found no dotted key before '='; allowed: KEY=VALUE, for example motion.rise_deg=90 or "
         "motion.segments[1].to=0.5",
         {"=3"}},
        {"set_strange_key",
         plain_scene,
         "--set motion..rise=3: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"motion..rise=3"}},
        {"set_no_value",
         plain_scene,
         "--set motion.rise_deg=: found no TOML value; allowed: a number, true, false, a word, a \"text\", "
         "an [array] or a { table }",
         {"motion.rise_deg="}},
        {"set_no_toml",
         plain_scene,
         "--set title=two words: found no TOML value; allowed: a number, true, false, a word, a \"text\", an "
         "[array] or a { table }",
         {"title=two words"}},
        {"set_two_lines",
         plain_scene,
         "--set spline.degree=3\ntitle = 5: found more than one line; allowed: one TOML value",
         {"spline.degree=3\ntitle = 5"}},
        {"set_bad_value",
         plain_scene,
         "--set spline.degree=4: spline.degree: found 4; allowed: 3 or 5",
         {"spline.degree=4"}},
        {"set_bad_type",
         plain_scene,
         "--set spline.degree=3.0: spline.degree: found 3.0, a number with a decimal point or exponent; "
         "allowed: 3 or 5, written without one",
         {"spline.degree=3.0"}},
        {"set_bare_word",
         plain_scene,
         "--set motion.type=rr: motion.type: found \"rr\"; allowed: \"DRD\", \"RR\", \"program\" or "
         "\"valve\"; did you "
         "mean 'RR'?",
         {"motion.type=rr"}},
        {"set_unknown_key",
         plain_scene,
         "--set spline.degrees=3: spline.degrees: found an unknown key; allowed: degree, segments, "
         "breakpoints, knots, continuity, end_jerk, design; did you mean 'degree'?",
         {"spline.degrees=3"}},
        {"set_unknown_table",
         plain_scene,
         "--set splines.degree=3: splines: found an unknown key; allowed: title, motion, spline, objective, "
         "cam, drawing, forces, measured, dynamics, drive, limits, solver; did you mean 'spline'?",
         {"splines.degree=3"}},
        {"set_into_text",
         plain_scene,
         "--set title.x=3: title: found \"x\", not a table; allowed: set title as a whole",
         {"title.x=3"}},
        {"set_cross_check",
         plain_scene,
         "--set spline.continuity=3: spline.continuity: found 3; allowed: 2 with degree 3",
         {"spline.continuity=3"}},
        {"set_breakpoints",
         plain_scene,
         "--set spline.breakpoints=[0, 0.7, 0.6, 1]: spline.breakpoints[2]: found 0.6 after 0.7; allowed: "
         "ascending breakpoints",
         {"spline.breakpoints=[0, 0.7, 0.6, 1]"}},
        {"set_open_array",
         plain_scene,
         "--set spline.breakpoints=[0, 1: found no TOML value; allowed: a number, true, false, a word, a "
         "\"text\", an [array] or a { table }",
         {"spline.breakpoints=[0, 1"}},
        {"set_solver",
         plain_scene,
         "--set solver.name=nlopt.slsq: solver.name: found \"nlopt.slsq\"; allowed: \"auto\", \"ipopt\", "
         "\"nlopt.slsqp\", \"structured\"; did you mean 'nlopt.slsqp'?",
         {"solver.name=nlopt.slsq"}},
        {"set_entry_beyond",
         program_scene,
         "--set motion.segments[2].to=1: motion.segments: found 2 entries, counted from 0; allowed: an "
         "existing entry",
         {"motion.segments[2].to=1"}},
        {"set_entry_of_no_array",
         plain_scene,
         "--set motion.segments[0].to=1: motion.segments: found no such array in the scene; allowed: an "
         "existing entry",
         {"motion.segments[0].to=1"}},
        {"set_entry_of_table",
         plain_scene,
         "--set motion[0].type=DRD: motion: found a table, not an array; allowed: set motion as a whole",
         {"motion[0].type=DRD"}},
        {"set_entry_of_text",
         plain_scene,
         "--set title[0]=x: title: found \"x\", not an array; allowed: set title as a whole",
         {"title[0]=x"}},
        {"set_array_as_table",
         program_scene,
         "--set motion.segments.to=1: motion.segments: found an array, not a table; allowed: set "
         "motion.segments as a whole, or in one of its entries, motion.segments[0] to motion.segments[1]",
         {"motion.segments.to=1"}},
        {"set_into_number",
         program_scene,
         "--set motion.segments[0].angle_deg.x=1: motion.segments[0].angle_deg: found 60, not a table; "
         "allowed: set motion.segments[0].angle_deg as a whole",
         {"motion.segments[0].angle_deg.x=1"}},
        {"set_strange_index",
         program_scene,
         "--set motion.segments[-1].to=1: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"motion.segments[-1].to=1"}},
        {"set_open_index",
         program_scene,
         "--set motion.segments[1.to=1: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"motion.segments[1.to=1"}},
        {"set_letter_index",
         program_scene,
         "--set motion.segments[a].to=1: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"motion.segments[a].to=1"}},
        {"set_after_index",
         program_scene,
         "--set motion.segments[0]x.to=1: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"motion.segments[0]x.to=1"}},
        {"set_huge_index",
         program_scene,
         "--set motion.segments[99999999999999999999].to=1: found no dotted key before '='; allowed: "
         "KEY=VALUE, for example motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"motion.segments[99999999999999999999].to=1"}},
        {"set_entry_unknown_key",
         program_scene,
         "--set motion.segments[1].ot=1: motion.segments[1].ot: found an unknown key; allowed: kind, "
         "angle_deg, angle_rad, angle_crank_deg, law, to, to_mm, to_in, to_m, to_deg, to_rad, end, via",
         {"motion.segments[1].ot=1"}},
        {"set_entry_bad_value",
         program_scene,
         "--set motion.segments[1].angle_deg=0: motion.segments[1].angle_deg: found 0; allowed: a number > 0 "
         "and <= 360, or a range { min = …, max = … }",
         {"motion.segments[1].angle_deg=0"}},
        {"set_entry_cross_check",
         program_scene,
         "s.toml:5:1: motion.segments: found angles that add up to 150 deg; allowed: 360 deg, or "
         "motion.closed = false for part of a revolution",
         {"motion.segments[1].angle_deg=90"}},
        {"set_entry_of_breakpoints",
         plain_scene,
         "--set spline.breakpoints=[0, 0.5, 1]: spline.breakpoints[2]: found 1 after 2; allowed: ascending "
         "breakpoints",
         {"spline.breakpoints=[0, 0.5, 1]", "spline.breakpoints[1]=2"}},
        {"set_range_descends",
         cam_scene,
         "--set cam.base_radius_mm={min=60,max=20}: cam.base_radius_mm: found a range from 60 to 20; "
         "allowed: min below max",
         {"cam.base_radius_mm={min=60,max=20}"}},
        {"set_range_bound",
         cam_scene,
         "--set cam.base_radius_mm={min=20,max=60}: cam.base_radius_mm: found a range from 70 to 60; "
         "allowed: min below max",
         {"cam.base_radius_mm={min=20,max=60}", "cam.base_radius_mm.min=70"}},
        {"set_bound_of_number",
         cam_scene,
         "--set cam.base_radius_mm.min=20: cam.base_radius_mm: found 40, not a table; allowed: set "
         "cam.base_radius_mm as a whole",
         {"cam.base_radius_mm.min=20"}},
        {"set_limit_without_cam",
         plain_scene,
         "--set limits.pressure_angle_deg=30: limits.pressure_angle_deg: found a limit of a cam without a "
         "cam; allowed: only together with a [cam] table",
         {"limits.pressure_angle_deg=30"}},
        {"set_follower",
         cam_scene,
         "s.toml:5:1: cam.roller_radius_mm: missing for the follower \"translating_roller\"; allowed: a "
         "number > 0, or a range { min = …, max = … }",
         {"cam.follower=translating_roller"}},
        {"set_deep_key",
         plain_scene,
         "--set a.b.c.d.e.f.g.h.i=1: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90 or motion.segments[1].to=0.5",
         {"a.b.c.d.e.f.g.h.i=1"}},
    };
}

}  // namespace camopt::input
