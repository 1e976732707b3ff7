// SPDX-License-Identifier: MIT
#include "report/csv/lobe_csv.hpp"

#include "report/csv/csv_line.hpp"
#include "report/view/shown_units.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/valve/valve_report.hpp"

#include <fmt/format.h>

namespace camopt {

std::string lobe_csv(const Solution& solution, const LobeTable& table) {
    const MotionSpec& motion = solution.scene.motion;
    if (!motion.valve || !solution.motion)
        throw InputError("--lobe: found no valve lobe with a motion; allowed: with motion.type = \"valve\"");
    const double rows = 360.0 / table.step_deg;
    constexpr double rounding = 1e-9, most_rows = 1e6;
    if (!(rows >= 1.0 && rows <= most_rows) || std::abs(rows - std::round(rows)) > rounding * rows)
        throw InputError(fmt::format("--step-deg: found {}; allowed: with --lobe a step that divides 360 deg",
                                     table.step_deg));
    const bool swings = motion.lift_is_angle;
    const ShownUnit valve = length_shown(table.unit);
    const ShownUnit follower = swings ? degrees_shown : valve;
    const double degrees_per_x = degrees_shown.of(motion.unit_angle());
    const MotionChain turn = whole_turn(solution);
    const std::string& u = follower.name;
    std::string text = fmt::format(
        "theta_deg,crank_angle_deg,s_{0},valve_{1},v_{0}_deg,a_{0}_deg2,j_{0}_deg3\n", u, valve.name);
    const auto count = static_cast<long>(std::llround(rows));
    const double nose = degrees_shown.of(nose_angle(*motion.valve));
    const double centerline = as_written(2.0 * degrees_shown.of(motion.valve->centerline.value_or(0.0)));
    for (long i = 0; i < count; ++i) {
        const double theta = 360.0 * static_cast<double>(i) / static_cast<double>(count) - 180.0;
        const double from_start = theta + nose;
        const double x = (from_start - 360.0 * std::floor(from_start / 360.0)) / degrees_per_x;
        const MotionPoint point = turn.at(std::clamp(x, turn.begin(), turn.end()));
        const double s = motion.lift * point.derivative[0];
        CsvLine line;
        line.number(theta).number(2.0 * theta + centerline);
        const auto add = [&](double value) {
            if (table.digits)
                line.words(fmt::format("{:.{}g}", value + 0.0, *table.digits));
            else
                line.number(value + 0.0);
        };
        add(follower.of(s));
        add(valve.of(std::max(0.0, motion.valve->ratio * s - motion.valve->lash)));
        for (std::size_t r = 1; r < 4; ++r)
            add(follower.of(motion.lift * point.derivative[r]) /
                std::pow(degrees_per_x, static_cast<double>(r)));
        text += line.finish();
    }
    return text;
}

}  // namespace camopt
