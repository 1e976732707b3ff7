// SPDX-License-Identifier: MIT
// Values out of range, unknown names.
#include "tests/input/broken_scenes.hpp"

namespace camopt::input {

std::vector<BrokenScene> broken_values() {
    return {
        {"lift_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = 0\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_mm: found 0; allowed: a number > 0"},
        {"lift_negative",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_in = -0.5\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_in: found -0.5; allowed: a number > 0"},
        {"lift_nan",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = nan\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_mm: found nan; allowed: a number > 0"},
        {"lift_infinite",
         "[motion]\n"
         "type = \"DRD\"\n"
         "lift_mm = inf\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:11: motion.lift_mm: found inf; allowed: a number > 0"},
        {"rise_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "rise_deg = 0\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:12: motion.rise_deg: found 0; allowed: a number > 0 and <= 360"},
        {"rise_over_turn",
         "[motion]\n"
         "type = \"DRD\"\n"
         "rise_deg = 361\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:12: motion.rise_deg: found 361; allowed: a number > 0 and <= 360"},
        {"rise_over_turn_rad",
         "[motion]\n"
         "type = \"DRD\"\n"
         "rise_rad = 6.3\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:12: motion.rise_rad: found 6.3; allowed: a number > 0 and <= 6.283185307179586"},
        {"speed_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "speed_rpm = 0\n"
         "[objective]\n"
         "jerk = 1\n",
         "s.toml:3:13: motion.speed_rpm: found 0; allowed: a number > 0"},
        {"degree_even",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "degree = 4\n",
         "s.toml:6:10: spline.degree: found 4; allowed: 3 or 5"},
        {"segments_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 0\n",
         "s.toml:6:12: spline.segments: found 0; allowed: an integer from 1 to 65536"},
        {"segments_too_many",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "segments = 65537\n",
         "s.toml:6:12: spline.segments: found 65537; allowed: an integer from 1 to 65536"},
        {"continuity_low",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "continuity = 1\n",
         "s.toml:6:14: spline.continuity: found 1; allowed: an integer from 2 to 4"},
        {"weight_negative",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = -1\n",
         "s.toml:4:8: objective.jerk: found -1; allowed: a number >= 0"},
        {"weight_infinite",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = inf\n",
         "s.toml:4:8: objective.jerk: found inf; allowed: a number >= 0"},
        {"reference_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "reference = { jerk = 0 }\n",
         "s.toml:5:22: objective.reference.jerk: found 0; allowed: a number > 0"},
        {"limit_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "velocity = 0\n",
         "s.toml:6:12: limits.velocity: found 0; allowed: a number > 0, or a table { min = …, max = … }, "
         "where one may be missing"},
        {"limit_negative_in_time",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[limits]\n"
         "velocity_mm_s = -3\n",
         "s.toml:6:17: limits.velocity_mm_s: found -3; allowed: a number > 0, or a table { min = …, max = … "
         "}, where one may be missing"},
        {"tolerance_too_small",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "tolerance = 1e-13\n",
         "s.toml:6:13: solver.tolerance: found 1e-13; allowed: a number from 1e-12 to 0.01"},
        {"gap_too_large",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "gap = 0.5\n",
         "s.toml:6:7: solver.gap: found 0.5; allowed: a number from 1e-12 to 0.01"},
        {"max_seconds_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "max_seconds = 0\n",
         "s.toml:6:15: solver.max_seconds: found 0; allowed: a number > 0"},
        {"starts_zero",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "starts = 0\n",
         "s.toml:6:10: solver.starts: found 0; allowed: an integer from 1 to 100000"},
        {"seed_negative",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "seed = -1\n",
         "s.toml:6:8: solver.seed: found -1; allowed: an integer from 0 to 4294967295"},
        {"knots_unknown",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "knots = \"loose\"\n",
         "s.toml:6:9: spline.knots: found \"loose\"; allowed: \"fixed\" or \"free\""},
        {"end_jerk_unknown",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "end_jerk = \"none\"\n",
         "s.toml:6:12: spline.end_jerk: found \"none\"; allowed: \"free\" or \"zero\""},
        {"design_unknown",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[spline]\n"
         "design = \"Auto\"\n",
         "s.toml:6:10: spline.design: found \"Auto\"; allowed: \"auto\", \"ordinates\", \"coefficients\" or "
         "\"states\"; did you mean 'auto'?"},
        {"tie_break_unknown",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "tie_break = \"jerk\"\n",
         "s.toml:5:13: objective.tie_break: found \"jerk\"; allowed: \"rms_jerk\" or \"none\"; did you mean "
         "'rms_jerk'?"},
        {"law_misspelt",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "reference = \"modified_sin\"\n",
         "s.toml:5:13: objective.reference: found \"modified_sin\"; allowed: a law of the catalogue: "
         "\"cycloidal\", \"modified_sine\", or a table of numbers; did you mean 'modified_sine'?"},
        {"law_unknown",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "reference = \"magic\"\n",
         "s.toml:5:13: objective.reference: found \"magic\"; allowed: a law of the catalogue: \"cycloidal\", "
         "\"modified_sine\", or a table of numbers"},
        {"solver_misspelt",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "name = \"ipop\"\n",
         "s.toml:6:8: solver.name: found \"ipop\"; allowed: \"auto\", \"ipopt\", \"nlopt.slsqp\", "
         "\"structured\"; did you mean 'ipopt'?"},
        {"solver_unknown",
         "[motion]\n"
         "type = \"DRD\"\n"
         "[objective]\n"
         "jerk = 1\n"
         "[solver]\n"
         "name = \"snopt\"\n",
         "s.toml:6:8: solver.name: found \"snopt\"; allowed: \"auto\", \"ipopt\", \"nlopt.slsqp\", "
         "\"structured\"; did you mean 'ipopt'?"},
    };
}

}  // namespace camopt::input
