// SPDX-License-Identifier: MIT
// A scene in inches is reported in inches, lbf, lbf in, ksi and lb; suggested changes name keys in these
// units.
#include "input/loading/load_scene.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/folders/result_folder.hpp"
#include "report/view/view.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <string>

namespace camopt {
namespace inch_report_test {

const std::string lobe =
    "title = \"Lobe\"\nobjective.jerk = 1\nspline.segments = 8\n"
    "motion = { type = \"RR\", lift_in = 0.4, rise_deg = 90, return_deg = 90, speed_rpm = 1000 }\n"
    "cam = { type = \"disk\", follower = \"translating_roller\", base_radius_in = 1.2, roller_radius_in = "
    "0.4 }\n"
    "[forces]\nmass_lb = 0.8\nspring_rate_lbf_in = 150\npreload_lbf = 80\ncontact_width_in = 0.5\n"
    "cam_modulus_ksi = 30000\n[limits]\nhertz_pressure_max_ksi = 400\ntorque_max_lbf_in = 300\n";

/// Numbers with a metric unit, but those of the list.
std::string metric_numbers(const std::string& text) {
    static const std::regex metric(
        "[0-9] (mm|µm|m/s|mm/rad|N|N m|N/mm|MPa|GPa|kg|kg m²)(?![A-Za-z0-9/])[^\n]*");
    std::string found;
    for (std::sregex_iterator match(text.begin(), text.end(), metric), end; match != end; ++match)
        found += match->str() + "\n";
    return found;
}

TEST(InchReport, HasNoMetricUnit) {
    const Solution solution = solve(scene_of_toml(lobe));
    ASSERT_TRUE(solution.motion);
    const std::string text = report_markdown(solution, {});
    EXPECT_EQ(metric_numbers(text), "") << text;
    for (const char* const unit : {" lbf", " lbf in", " ksi", " lb |", " lbf/in", " in/s²", " in |"})
        EXPECT_NE(text.find(unit), std::string::npos) << unit << "\n" << text;
    const View view(solution);
    for (const Curve& curve : view.curves) {
        if (curve.key == "force" || curve.key == "normal_force") {
            EXPECT_EQ(curve.unit.name, "lbf");
        }
        if (curve.key == "torque") {
            EXPECT_EQ(curve.unit.name, "lbf in");
        }
        if (curve.key == "hertz_pressure") {
            EXPECT_EQ(curve.unit.name, "ksi");
        }
    }
}

TEST(InchReport, SuggestedKeysAreInItsUnits) {
    const std::string weak =
        lobe.substr(0, lobe.find("[limits]")) + "[limits]\ncontact_force_min_lbf = 200\n";
    const Solution solution = solve(scene_of_toml(weak));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    int forces = 0;
    for (const Relaxation& row : solution.relaxation) {
        if (!row.needed) continue;
        EXPECT_EQ(row.key.find("_n_mm"), std::string::npos) << row.key;
        EXPECT_FALSE(row.key.ends_with("_n") || row.key.ends_with("_mm")) << row.key;
        const std::string setting = row.key + "=" + std::to_string(*row.needed);
        EXPECT_NO_THROW((void)scene_of_toml(weak, std::vector<std::string>{setting})) << setting;
        if (row.key == "forces.preload_lbf") ++forces;
    }
    EXPECT_EQ(forces, 1);
    EXPECT_EQ(metric_numbers(report_markdown(solution, {})), "");
}

TEST(InchReport, SuggestedKeysAreAsWritten) {
    const std::string written =
        "objective.jerk = 1\nspline.segments = 8\n"
        "motion = { type = \"RR\", lift_m = 0.01, rise_rad = 1.5, return_deg = 90, speed_rad_s = 100 }\n"
        "cam = { type = \"disk\", follower = \"translating_roller\", base_radius_in = 1.2, roller_radius_m = "
        "0.01 }\n"
        "[forces]\nmass_lb = 0.8\nspring_rate_n_m = 26000\npreload_lbf = 8\n"
        "[limits]\ncontact_force_min_lbf = 200\n";
    const Solution solution = solve(scene_of_toml(written));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    int rows = 0;
    for (const Relaxation& row : solution.relaxation) {
        if (row.key == "spline.segments" || row.key == "cam.offset_mm") continue;  // not written
        const std::string name = row.key.substr(row.key.find('.') + 1);
        EXPECT_NE(written.find(name + " ="), std::string::npos) << row.key;
        for (const CompanionChange& other : row.also)
            EXPECT_NE(written.find(other.key.substr(other.key.find('.') + 1) + " ="), std::string::npos);
        ++rows;
    }
    EXPECT_GE(rows, 4);
}

TEST(InchReport, RampsPerDegreeHoldExactly) {
    const Scene scene = testing_support::scene_named("lobe_ramps_in_inches");
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion);
    const double per_degree = units::inch / units::degree;
    for (const double at : {6.5, 10.0, 13.5}) {
        const double x = at * units::degree / scene.motion.rise;
        EXPECT_NEAR(solution.motion->at(x).derivative[1] * scene.motion.lift / scene.motion.rise,
                    0.0005 * per_degree, 1e-9 * per_degree);
    }
    EXPECT_EQ(metric_numbers(report_markdown(solution, {})), "");
}

}  // namespace inch_report_test
}  // namespace camopt
