// SPDX-License-Identifier: MIT
// Measured motions: fitted by least squares in the scene's own space, with a true error.
#include "core/text/text_file.hpp"
#include "input/loading/load_scene.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "objectives/deviation_rules.hpp"
#include "objectives/scene_model.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/solve/solution_tables.hpp"
#include "report/view/view.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/solution_parts.hpp"
#include "studies/measured/measured_fit.hpp"
#include "studies/solve/solve.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"
#include "tests/support/source_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

namespace camopt {
namespace measured_test {

using namespace testing_support;

constexpr double lift = 12e-3, rise = 2.0;

Scene measured_scene(int rows, const std::function<double(double)>& y, int segments = 16) {
    Scene scene = paper_objective(MotionType::drd, 3, segments);
    scene.motion.lift = lift;
    scene.motion.rise = rise;
    scene.measured.emplace();
    scene.measured->name = "measured.csv";
    for (int k = 0; k <= rows; ++k) {
        const double x = static_cast<double>(k) / rows;
        scene.measured->angle.push_back(rise * x);
        scene.measured->displacement.push_back(lift * y(x));
    }
    return scene;
}

double cycloid(double x) {
    return make_law("cycloidal")->at(x).derivative[0];
}

double mean_square(const Scene& scene, const Motion& motion) {
    double sum = 0.0;
    const MeasuredMotion& table = *scene.measured;
    for (std::size_t k = 0; k < table.angle.size(); ++k) {
        const double error =
            motion.at(std::min(table.angle[k] / rise, 1.0)).derivative[0] - table.displacement[k] / lift;
        sum += error * error;
    }
    return sum / static_cast<double>(table.angle.size());
}

TEST(Measured, MotionInSpaceIsReproduced) {
    Scene plain = paper_objective(MotionType::drd, 3, 12);
    const Solution optimum = solve(plain);
    const Scene scene = measured_scene(
        300, [&](double x) { return optimum.motion->at(x).derivative[0]; }, 12);
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.measured);
    EXPECT_EQ(solution.measured->rows, 301);
    EXPECT_LT(solution.measured->largest_error, 1e-9);
    ASSERT_TRUE(solution.measured->objective);
    EXPECT_NEAR(*solution.measured->objective, optimum.certificate.objective, 1e-5);
    EXPECT_NEAR(solution.measured->peaks.velocity.value, optimum.peaks.velocity.value, 1e-6);
}

TEST(Measured, SparseTableIsReportedAsFollowingNoise) {
    const Solution sparse = solve(measured_scene(24, cycloid, 16));
    EXPECT_EQ(measured_sentence(sparse).find('%'), std::string::npos);  // no gain over noise
    ASSERT_TRUE(sparse.measured);
    EXPECT_EQ(sparse.measured->freedom, 13);  // 16 + 3 coefficients, six of them fixed by the ends
    EXPECT_TRUE(follows_noise(*sparse.measured));
    EXPECT_NE(measured_sentence(sparse).find("follows the noise"), std::string::npos);
    const Solution dense = solve(measured_scene(25, cycloid, 16));
    EXPECT_FALSE(follows_noise(*dense.measured));
    EXPECT_EQ(measured_sentence(dense).find("follows the noise"), std::string::npos);
}

TEST(Measured, ResidualCurveIsTableMinusFit) {
    const Scene scene =
        measured_scene(90, [](double x) { return cycloid(x) + 1e-3 * std::sin(91.0 * x) * x * (1 - x); });
    const Solution solution = solve(scene);
    const View view(solution);
    const auto residual = std::ranges::find(view.curves, "residual", &Curve::key);
    ASSERT_NE(residual, view.curves.end());
    ASSERT_EQ(residual->points.size(), 91u);
    double largest = 0.0;
    for (std::size_t k = 0; k < residual->points.size(); ++k) {
        const double x = static_cast<double>(k) / 90;
        const double error =
            1e3 * (scene.measured->displacement[k] - lift * solution.measured->motion->at(x).derivative[0]);
        EXPECT_NEAR(residual->points[k][1], error, 1e-10);
        largest = std::max(largest, std::abs(error));
    }
    ASSERT_EQ(residual->marks.size(), 1u);
    EXPECT_NEAR(std::abs(residual->marks[0].value), largest, 1e-10);
    EXPECT_NEAR(solution.measured->largest_error * lift * 1e3, largest, 1e-10);
    EXPECT_EQ(view.curves.front().points.size(), 91u);
}

TEST(Measured, LobeInInchesIsReadWithoutHeader) {
    const Scene scene = scene_named("measured_lobe");
    ASSERT_EQ(scene.measured->angle.size(), 131u);
    EXPECT_NEAR(scene.measured->angle[65], 65.0 * units::degree, 1e-12);
    EXPECT_DOUBLE_EQ(scene.measured->displacement[65], 0.393615 * units::inch);
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.measured);
    EXPECT_EQ(solution.measured->rows, 131);
    EXPECT_FALSE(follows_noise(*solution.measured));
    EXPECT_LT(solution.measured->largest_error * scene.motion.lift, 0.0015 * units::inch);
    EXPECT_NE(measured_sentence(solution).find(" in (rms "), std::string::npos)
        << measured_sentence(solution);
}

/// Every table that camopt writes of a motion is a measured table of the same motion.
TEST(Measured, OwnTablesGiveTheSameMotion) {
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "camopt_own_tables";
    std::filesystem::create_directories(folder);
    const std::string text =
        "motion = { type = \"RR\", lift_mm = 9, rise_deg = 80, return_deg = 70, "
        "speed_rpm = 100 }\nspline.segments = 12\nobjective.jerk = 1\n"
        "cam = { type = \"disk\", follower = \"translating_roller\", base_radius_mm = "
        "30, roller_radius_mm = 8 }\n";
    const auto write = [&](const char* name, const std::string& words) {
        std::ofstream(folder / name, std::ios::binary) << words;
    };
    write("s.toml", text);
    const Solution solution = solve(load_scene(folder / "s.toml"));
    const View view(solution);
    UniformTableOptions inches;
    inches.columns = {"theta_rad", "s_in", "theta_deg", "s_mm"};
    UniformTableOptions steps;
    steps.step_deg = 0.75;
    steps.digits = 9;
    write("s.toml", text + "measured.table = \"t.csv\"\n");
    for (const std::string& table :
         {motion_csv(view), uniform_table(view, {}).text, uniform_table(view, inches).text,
          uniform_table(view, steps).text,
          profile_csv(view, profile_rows(solution, view.delivered, default_sampling(*view.delivered.cam)))}) {
        write("t.csv", table);
        const Scene scene = load_scene(folder / "s.toml");
        const MeasuredReport report = measured_report(scene, solution.reference_peaks);
        EXPECT_GT(report.rows, 100);
        EXPECT_LT(report.largest_error, 1e-8) << table.substr(0, 60);
    }
    std::filesystem::remove_all(folder);
}

/// To the digits of the table, for every kind of motion: its deviation from its own scene is 0.
TEST(Measured, ExportsOfExampleScenesReadBack) {
    const test::TemporaryFolder folder;
    const std::filesystem::path file = std::filesystem::path(folder.path()) / "s.toml";
    for (const char* const name : {"drd_cubic_12", "drd_quintic_12", "rr_unequal_return", "drd_symmetric",
                                   "cam_drdrd", "cam_flat", "swing_limits", "servo_drd"}) {
        const std::string text = read_text_file(source_folder() + "/scenes/" + name + ".toml");
        const Solution solution = solve(scene_of_toml(text, std::vector<std::string>{"solver.starts=1"}));
        ASSERT_TRUE(solution.motion) << name;
        std::ofstream(file.parent_path() / "t.csv", std::ios::binary)
            << uniform_table(View(solution), {}).text;
        std::ofstream(file, std::ios::binary) << text << "\n[measured]\ntable = \"t.csv\"\n";
        const Scene scene = load_scene(file);
        const MeasuredReport report = measured_report(scene, solution.reference_peaks);
        EXPECT_GT(report.rows, 100) << name;
        EXPECT_LT(report.largest_error, 1e-8) << name;
        EXPECT_TRUE(scene.measured->outliers.empty()) << name;
    }
}

TEST(Measured, FitKeepsEndsAndReportsError) {
    const Scene scene = measured_scene(180, cycloid);
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.measured);
    const MeasuredReport& report = *solution.measured;
    for (int order = 0; order < 3; ++order) {
        EXPECT_NEAR(report.motion->at(0.0).derivative[order], 0.0, 1e-9);
        EXPECT_NEAR(report.motion->at(1.0, Side::left).derivative[order], order == 0 ? 1.0 : 0.0, 1e-9);
    }
    double largest = 0.0;
    for (int k = 0; k <= 180; ++k)
        largest =
            std::max(largest, std::abs(report.motion->at(k / 180.0).derivative[0] - cycloid(k / 180.0)));
    EXPECT_NEAR(report.largest_error, largest, 1e-15);
    EXPECT_GT(report.largest_error, 1e-8);
    EXPECT_LT(report.largest_error, 1e-4);
    EXPECT_NEAR(report.rms_error, std::sqrt(mean_square(scene, *report.motion)), 1e-14);
    // The cycloid by the references 1.76, 5.53, 69; the fit comes close to it.
    EXPECT_NEAR(*report.objective, 0.4 * 2 / 1.76 + 0.4 * 2 * M_PI / 5.53 + 0.2 * 4 * M_PI * M_PI / 69, 0.03);
    EXPECT_LT(solution.certificate.objective, *report.objective);
}

/// No other motion of the space has a smaller mean square: every admissible change makes it larger.
TEST(Measured, NoMotionInSpaceIsNearer) {
    const Scene scene =
        measured_scene(90, [](double x) { return cycloid(x) + 2e-3 * std::sin(91.0 * x) * x * (1 - x); });
    const MotionFamily family = scene_family(scene, DesignKind::coefficients);
    const Eigen::VectorXd best = nearest_design(family, scene);
    const double least = mean_square(scene, family.motion(best));
    ASSERT_TRUE(family.equalities().empty());  // ends are built in: every entry is free
    for (int j = 0; j < family.size(); ++j)
        for (const double step : {1e-5, -1e-5}) {
            Eigen::VectorXd moved = best;
            moved[j] += step;
            EXPECT_GT(mean_square(scene, family.motion(moved)), least) << j;
        }
}

/// Where nothing was measured the fit is the smoothest one, not whatever a singular system gives.
TEST(Measured, TableGapIsBridgedSmoothly) {
    Scene scene = measured_scene(300, cycloid, 24);
    MeasuredMotion& table = *scene.measured;
    MeasuredMotion seen = table;
    seen.angle.clear();
    seen.displacement.clear();
    for (std::size_t k = 0; k < table.angle.size(); ++k) {
        const double x = table.angle[k] / rise;
        if (x > 0.3 && x < 0.7) continue;
        seen.angle.push_back(table.angle[k]);
        seen.displacement.push_back(table.displacement[k]);
    }
    table = seen;
    const MotionFamily family = scene_family(scene, DesignKind::coefficients);
    const auto motion = family.motion(nearest_design(family, scene));
    for (int k = 0; k <= 100; ++k) {
        const double x = k / 100.0;
        EXPECT_NEAR(motion.at(x).derivative[0], cycloid(x), 0.02) << x;
    }
}

Scene nearest_scene(bool rms, double noise) {
    Scene scene = measured_scene(
        120, [&](double x) { return cycloid(x) + noise * std::sin(97.0 * x) * x * (1.0 - x); }, 8);
    scene.objective = {};
    (rms ? scene.objective.deviation_rms : scene.objective.deviation) = 1.0;
    return scene;
}

/// Two ways to one number: the normal equations, and a quadratic program with its proof.
TEST(NearestMotion, LeastRmsIsLeastSquares) {
    Scene scene = nearest_scene(true, 2e-3);
    scene.limits.jerk = 400.0;  // far from active: it bounds what the proof must look at
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const MotionFamily family = scene_family(scene, DesignKind::coefficients);
    const double least = std::sqrt(mean_square(scene, family.motion(nearest_design(family, scene))));
    EXPECT_NEAR(solution.certificate.objective, least / 1e-3, 1e-6);
    EXPECT_LE(*solution.certificate.lower_bound, least / 1e-3 + 1e-9);
    EXPECT_GE(*solution.certificate.lower_bound, least / 1e-3 * (1.0 - 1e-4));
}

/// No admissible change makes the largest deviation smaller: of a convex problem that is its optimum.
TEST(NearestMotion, LargestDeviationCannotBeLowered) {
    const Scene scene = nearest_scene(false, 2e-3);
    const Solution solution = solve(scene);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    const std::vector<MeasuredRow> rows = measured_rows(scene, 0.0, 1.0);
    const double least = deviation_of(rows, *solution.motion).largest.value;
    EXPECT_NEAR(solution.certificate.objective, least / 1e-3, 1e-9);
    EXPECT_LT(*solution.certificate.gap, 1e-6);
    EXPECT_NE(measured_sentence(solution).find("no motion of this spline space"), std::string::npos);
    const MotionFamily family = scene_family(scene, DesignKind::coefficients);
    const Eigen::VectorXd squares = nearest_design(family, scene);
    EXPECT_LT(least, deviation_of(rows, family.motion(squares)).largest.value);
    int level = 0;  // as many rows as free numbers and one more lie at the largest deviation
    for (const MeasuredRow& row : rows)
        level += std::abs(std::abs(solution.motion->at(row.x).derivative[0] - row.y) - least) < 1e-8 ? 1 : 0;
    EXPECT_GE(level, 2);
}

TEST(NearestMotion, LimitsKeepItAway) {
    Scene scene = nearest_scene(false, 0.0);
    const Solution free = solve(scene);
    scene.limits.acceleration = 5.8;  // the cycloid has 2π
    const Solution limited = solve(scene);
    ASSERT_EQ(limited.certificate.verdict, Verdict::optimal) << limited.certificate.reason;
    EXPECT_LE(limited.peaks.acceleration.value, 5.8 * (1.0 + 1e-9));
    EXPECT_GT(limited.certificate.objective, free.certificate.objective + 0.5);
    scene.limits.acceleration = 3.0;  // no rise has less than 4
    EXPECT_EQ(solve(scene).certificate.verdict, Verdict::infeasible);
}

/// Of free breakpoints the nearest motion is no farther than with those it began from.
TEST(NearestMotion, FreeBreakpointsComeNearer) {
    for (const bool rms : {false, true}) {
        Scene scene = nearest_scene(rms, 2e-3);
        scene.spline.segments = 5;
        const Solution fixed = solve(scene);
        scene.spline.free_knots = true;
        scene.solver.starts = 1;
        const Solution free = solve(scene);
        ASSERT_TRUE(fixed.motion && free.motion) << rms;
        EXPECT_LT(free.certificate.objective, 0.99 * fixed.certificate.objective) << rms;
        const Deviation found = deviation_of(measured_rows(scene, 0.0, 1.0), *free.motion);
        EXPECT_NEAR(free.certificate.objective, (rms ? found.rms : found.largest.value) / 1e-3, 1e-6) << rms;
        EXPECT_NE(free.certificate.verdict, Verdict::optimal) << rms;
    }
}

TEST(NearestMotion, NeedsTable) {
    Scene scene = nearest_scene(false, 0.0);
    scene.measured.reset();
    EXPECT_EQ(refusal([&] { (void)solve(scene); }),
              "objective.deviation: found a weight > 0 without [measured]; allowed: 0, or a table "
              "[measured] to deviate from");
}

TEST(NearestLaw, IsNamedWithItsAngles) {
    for (const char* const key : {"modified_sine", "cycloidal", "modified_trapezoid", "polynomial_345"}) {
        const auto law = make_law(key);
        const Scene scene = measured_scene(
            120, [&](double x) { return law->at(std::clamp((x - 0.03) / 0.92, 0.0, 1.0)).derivative[0]; });
        const MeasuredReport report = measured_report(scene, {});
        ASSERT_EQ(report.laws.size(), 1U);
        EXPECT_EQ(report.laws[0].law, law->info().title);
        EXPECT_NEAR(report.laws[0].begin, 0.03, 1e-6);
        EXPECT_NEAR(report.laws[0].end, 0.95, 1e-6);
        EXPECT_LT(report.laws[0].largest, 1e-9);
    }
}

TEST(Measured, TooFewRowsAreRefused) {
    const Scene scene = measured_scene(9, cycloid, 64);
    EXPECT_EQ(refusal([&] { (void)solve(scene); }),
              "measured: found 10 rows for a spline with 61 free numbers; allowed: as many rows at least, or "
              "fewer spline.segments");
}

TEST(Measured, FaultsNameTheRow) {
    const auto fault_of = [](const std::function<void(MeasuredMotion&)>& change) {
        Scene scene = measured_scene(20, cycloid);
        change(*scene.measured);
        const auto fault = find_fault(scene);
        return fault ? fault->member + ": found " + fault->found + "; allowed: " + fault->allowed : "none";
    };
    EXPECT_EQ(fault_of([](MeasuredMotion&) {}), "none");
    EXPECT_EQ(fault_of([](MeasuredMotion& m) { m.angle[7] = m.angle[6]; }).substr(0, 18),
              "measured.theta[7]:");
    EXPECT_EQ(fault_of([](MeasuredMotion& m) { m.displacement[3] = std::nan(""); }),
              "measured.s[3]: found nan; allowed: a finite number");
    EXPECT_EQ(
        fault_of([](MeasuredMotion& m) {
            for (double& s : m.displacement) s *= 0.5;
        }),
        "measured.s[20]: found 6 mm at 114.592 deg; allowed: 12 mm, to 0.6 mm: what the scene requires at "
        "114.592 deg");
    EXPECT_EQ(fault_of([](MeasuredMotion& m) {
                  m.angle.resize(5);
                  m.displacement.resize(5);
              }),
              "measured.theta: found 5 rows; allowed: 8 to 1000000 rows");
    EXPECT_EQ(fault_of([](MeasuredMotion& m) {
                  for (double& angle : m.angle) angle *= 0.9;
              }).substr(0, 19),
              "measured.theta[20]:");
}

/// A pressure angle that is not convex over base radius and motion together: searched from starts.
TEST(Measured, StartIsFirstSearchPoint) {
    Scene scene = measured_scene(180, cycloid, 8);
    scene.measured->start = true;
    scene.objective.torque = 0.5;
    scene.objective.reference.torque = 5.46;
    scene.solver.starts = 1;
    const Solution searched = solve(scene);
    ASSERT_TRUE(searched.motion) << searched.certificate.reason;
    ASSERT_TRUE(searched.measured);
    EXPECT_TRUE(searched.measured->started);
    EXPECT_EQ(searched.solver.starts, 1);
    scene.measured->start = false;
    const Solution compared = solve(scene);
    EXPECT_FALSE(compared.measured->started);
    EXPECT_NEAR(searched.certificate.objective, compared.certificate.objective, 1e-5);
}

}  // namespace measured_test
}  // namespace camopt
