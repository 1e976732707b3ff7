// SPDX-License-Identifier: MIT
// Overrides that cannot be applied or make a good scene wrong.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {
namespace {

constexpr const char* plain_scene = "title = \"x\"\n[motion]\ntype = \"DRD\"\n[objective]\njerk = 1\n";

}  // namespace

std::vector<BrokenScene> broken_overrides() {
    return {
        {"set_no_equals",
         plain_scene,
         "--set motion.rise_deg: found no '='; allowed: KEY=VALUE, for example motion.rise_deg=90",
         {"motion.rise_deg"}},
        {"set_no_key",
         plain_scene,
         "--set =3: found no dotted key before '='; allowed: KEY=VALUE, for example motion.rise_deg=90",
         {"=3"}},
        {"set_strange_key",
         plain_scene,
         "--set motion..rise=3: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90",
         {"motion..rise=3"}},
        {"set_no_value",
         plain_scene,
         "--set motion.rise_deg=: found no TOML value; allowed: a number, true, false, a word, a \"text\" or "
         "an [array]",
         {"motion.rise_deg="}},
        {"set_no_toml",
         plain_scene,
         "--set title=two words: found no TOML value; allowed: a number, true, false, a word, a \"text\" or "
         "an [array]",
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
         "--set motion.type=rr: motion.type: found \"rr\"; allowed: \"DRD\", \"RR\" or \"program\"",
         {"motion.type=rr"}},
        {"set_unknown_key",
         plain_scene,
         "--set spline.degrees=3: spline.degrees: found an unknown key; allowed: degree, segments, "
         "breakpoints, knots, continuity, end_jerk, design; did you mean 'degree'?",
         {"spline.degrees=3"}},
        {"set_unknown_table",
         plain_scene,
         "--set splines.degree=3: splines: found an unknown key; allowed: title, motion, spline, objective, "
         "cam, forces, limits, solver; did you mean 'spline'?",
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
         "\"text\" or an [array]",
         {"spline.breakpoints=[0, 1"}},
        {"set_later",
         plain_scene,
         "--set spline.knots=free: spline.knots: found \"free\", which is not available yet in this version "
         "of camopt; allowed: \"fixed\"",
         {"spline.knots=free"},
         true},
        {"set_solver",
         plain_scene,
         "--set solver.name=nlopt.slsq: solver.name: found \"nlopt.slsq\"; allowed: \"auto\", \"ipopt\", "
         "\"nlopt.slsqp\", \"structured\"; did you mean 'nlopt.slsqp'?",
         {"solver.name=nlopt.slsq"}},
        {"set_deep_key",
         plain_scene,
         "--set a.b.c.d.e.f.g.h.i=1: found no dotted key before '='; allowed: KEY=VALUE, for example "
         "motion.rise_deg=90",
         {"a.b.c.d.e.f.g.h.i=1"}},
    };
}

}  // namespace camopt::input
