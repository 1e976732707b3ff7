// SPDX-License-Identifier: MIT
// Measured cams with known errors: what an inspection finds of their alignment and of their form.
#include "studies/inspect/inspection.hpp"

#include "core/units.hpp"
#include "profiles/sampling.hpp"
#include "report/csv/motion_csv.hpp"
#include "studies/delivered/delivered.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/solved_scene.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>

namespace camopt {
namespace inspection_test {

using namespace testing_support;

using Eigen::Vector2d;
using Eigen::Vector4d;

constexpr double um = 1e-6, mm = 1e-3, degree = units::degree;

const Solution& nominal() {
    return solved(scene_named("inspected_cam"));
}

/// The known errors of a measured cam.
struct Errors {
    Vector4d alignment = {40.0 * um, 2.0 * degree, 8.0 * um, -6.0 * um};  ///< ρ, α, x, y
    double bump = 15.0 * um, noise = 1.0 * um;
    double bump_at = 200.0 * degree, bump_width = 30.0 * degree;
    int rows = 720;

    [[nodiscard]] double form(double angle) const {
        const double part = (angle - bump_at) / bump_width;
        return std::abs(part) < 0.5 ? 0.5 * bump * (1.0 + std::cos(units::turn * part)) : 0.0;
    }
};

input::InspectedTable lift_table(const Errors& errors, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, errors.noise);
    const Solution& solution = nominal();
    const MotionChain turn = solution.whole_turn();
    const MotionScale scale = motion_scale(solution.scene);
    input::InspectedTable table{"m.csv", false, false, {}, {}};
    for (int i = 0; i < errors.rows; ++i) {
        const double theta = units::turn * i / errors.rows;
        double angle = theta - errors.alignment[1];
        angle -= units::turn * std::floor(angle / units::turn);
        const double s = state_of(motion_at(turn, angle / scale.unit_angle), scale).s;
        table.rows.emplace_back(theta, s + errors.alignment[0] + errors.alignment[2] * std::cos(angle) +
                                           errors.alignment[3] * std::sin(angle) + errors.form(angle) +
                                           noise(random));
        table.lines.push_back(i + 2);
    }
    return table;
}

input::InspectedTable point_table(const Errors& errors, unsigned seed, double probe) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, errors.noise);
    const Solution& solution = nominal();
    const MotionChain turn = solution.whole_turn();
    const MotionScale scale = motion_scale(solution.scene);
    input::InspectedTable table{"p.csv", true, false, {}, {}};
    for (int i = 0; i < errors.rows; ++i) {
        const double angle = units::turn * (i + 0.3) / errors.rows;
        const MechanismPoint point =
            mechanism_point(solution.cam->cam, motion_at(turn, angle / scale.unit_angle), scale);
        const double distance = probe + errors.alignment[0] + errors.form(angle) + noise(random);
        const Vector2d centre = point.contact.head<2>() + distance * point.normal.head<2>();
        table.rows.emplace_back(Eigen::Rotation2Dd(errors.alignment[1]) * centre +
                                errors.alignment.tail<2>());
        table.lines.push_back(i + 2);
    }
    return table;
}

void expect_found(const Inspection& found, const Errors& errors) {
    ASSERT_EQ(found.fitted, 4);
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(found.alignment[k], errors.alignment[k], 4.0 * found.error[k]) << k;
        EXPECT_LT(found.error[k], k == 1 ? 0.003 * degree : 0.3 * um) << k;
    }
    EXPECT_NEAR(found.worst.front().around, errors.bump, 1.0 * um);
    EXPECT_NEAR(found.noise, errors.noise, 0.3 * errors.noise);
    for (const InspectedRow& row : found.rows) EXPECT_FALSE(row.outlier) << row.line;
}

TEST(Inspection, FindsLobeErrorInDisplacements) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Errors errors;
        const Inspection found = inspect_cam(nominal(), lift_table(errors, seed));
        expect_found(found, errors);
        EXPECT_NEAR(found.worst.front().angle, errors.bump_at + errors.alignment[1], 5.0 * degree);
        RecordProperty(fmt::format("bump_um_{}", seed), fmt::format("{}", found.worst.front().around / um));
    }
}

TEST(Inspection, FindsLobeErrorInPoints) {
    const Errors errors;
    const Inspection found = inspect_cam(nominal(), point_table(errors, 4, 0.0));
    expect_found(found, errors);
    EXPECT_NEAR(found.worst.front().angle, errors.bump_at, 5.0 * degree);
    // Where the cam is inclined the follower moves further than the cam's surface.
    EXPECT_GT(found.worst.front().follower, found.worst.front().aligned);
}

TEST(Inspection, FindsLobeErrorWithProbe) {
    const Errors errors;
    expect_found(inspect_cam(nominal(), point_table(errors, 5, 3.0 * mm), 3.0 * mm), errors);
}

TEST(Inspection, SearchesLargeOffsetsOfAngle) {
    Errors errors;
    errors.alignment[1] = -130.0 * degree;
    expect_found(inspect_cam(nominal(), lift_table(errors, 5)), errors);
    expect_found(inspect_cam(nominal(), point_table(errors, 5, 0.0)), errors);
}

/// The bump's slope is bump · π / width at most: 1.57 um/deg, its second derivative 0.16 um/deg².
TEST(Inspection, JudgesSlopesOfLiftsAndPoints) {
    Errors errors;
    errors.noise = 0.02 * um;
    const double steepest = errors.bump * std::numbers::pi / errors.bump_width;
    const double bent =
        2.0 * errors.bump * std::numbers::pi * std::numbers::pi / (errors.bump_width * errors.bump_width);
    for (const bool points : {false, true}) {
        const input::InspectedTable table = points ? point_table(errors, 7, 0.0) : lift_table(errors, 7);
        const auto judged = [&](double part) {
            return inspect_cam(nominal(), table, 0.0, {100.0 * um, true, {part * steepest, part * bent}});
        };
        const Inspection wide = judged(1.6), narrow = judged(0.7);
        EXPECT_TRUE(wide.in_tolerance());
        EXPECT_FALSE(narrow.in_tolerance());
        EXPECT_TRUE(narrow.out.empty());  // the profile is in tolerance
        ASSERT_EQ(narrow.derivatives.size(), 2U);
        for (const ErrorDerivative& one : narrow.derivatives) {
            EXPECT_FALSE(one.out.empty());
            EXPECT_NEAR(std::abs(one.worst), one.order == 1 ? steepest : bent,
                        0.3 * (one.order == 1 ? steepest : bent));
        }
    }
}

TEST(Inspection, SeparatesBaseCircleFromLobe) {
    Errors errors;
    errors.bump_at = 300.0 * degree;  // in the dwell at 0
    const Inspection found = inspect_cam(nominal(), lift_table(errors, 6), 0.0, {8.0 * um});
    EXPECT_NEAR(found.base.most, errors.bump, 3.0 * um);
    EXPECT_LT(found.lobe.most, 5.0 * um);
    EXPECT_EQ(found.base.rows + found.lobe.rows, errors.rows);
    EXPECT_NEAR(found.base.rows, 240, 5);
    ASSERT_EQ(found.out.size(), 1U);
    EXPECT_NEAR(found.out[0][0], 294.0 * degree, 4.0 * degree);
    EXPECT_NEAR(found.out[0][1], 310.0 * degree, 4.0 * degree);
    EXPECT_EQ(found.out[0][2], found.base.most);
}

TEST(Inspection, NamesOutliersWithTheirLines) {
    const Errors errors;
    input::InspectedTable table = lift_table(errors, 7);
    table.rows[100].y() += 80.0 * um;
    table.rows[500].y() -= 9.0 * um;
    const Inspection found = inspect_cam(nominal(), table);
    std::vector<int> lines;
    for (const InspectedRow& row : found.rows)
        if (row.outlier) lines.push_back(row.line);
    EXPECT_EQ(lines, (std::vector<int>{102, 502}));
    for (int k = 0; k < 4; ++k) EXPECT_NEAR(found.alignment[k], errors.alignment[k], 4.0 * found.error[k]);
}

TEST(Inspection, OwnTablesReadBackWithoutDeviation) {
    const Solution& solution = nominal();
    for (const std::string& text : {motion_csv(solution), uniform_table(solution, {}).text}) {
        const Inspection found = inspect_cam(solution, input::inspected_table_of(text, "own.csv"));
        for (const DeviationFigures* figures : {&found.raw, &found.all}) {
            EXPECT_LT(figures->most, 1e-15);
            EXPECT_GT(figures->least, -1e-15);
        }
    }
    Errors none;
    none.alignment.setZero();
    none.bump = none.noise = 0.0;
    std::string points = "x_mm;y_mm\n";
    for (const Vector2d& point : point_table(none, 0, 0.0).rows)
        points += fmt::format("{};{}\n", point.x() / mm, point.y() / mm);
    const Inspection found = inspect_cam(solution, input::inspected_table_of(points, "own.csv"));
    EXPECT_LT(found.raw.most, 1e-14);
    EXPECT_GT(found.raw.least, -1e-14);
}

TEST(Inspection, PartOfRevolutionHasNoEccentricity) {
    input::InspectedTable table = lift_table({}, 8);
    table.rows.resize(300);
    table.lines.resize(300);
    const Inspection found = inspect_cam(nominal(), table);
    EXPECT_EQ(found.fitted, 2);
    EXPECT_EQ(found.error[2], 0.0);
    EXPECT_NEAR(found.alignment[1], 2.0 * degree, 0.1 * degree);
}

TEST(Inspection, RoundPartKeepsItsAngle) {
    input::InspectedTable table = lift_table({}, 9);
    const std::vector<Vector2d> rows = table.rows;
    table.rows.assign(rows.begin() + 500, rows.begin() + 700);  // of the dwell
    table.lines.resize(200);
    const Inspection found = inspect_cam(nominal(), table);
    EXPECT_EQ(found.alignment[1], 0.0);
    EXPECT_EQ(found.lobe.rows, 0);
}

TEST(Inspection, RefusesWhatDoesNotFit) {
    const Solution& without_cam = solved(scene_named("prescribed_laws"));
    const auto refused = [&](const std::string& text, double probe = 0.0) {
        return refusal(
            [&] { (void)inspect_cam(without_cam, input::inspected_table_of(text, "t.csv"), probe); });
    };
    std::string points = "x_mm,y_mm\n", degrees = "theta_deg,s_deg\n", lifts = "theta_deg,s_mm\n";
    for (int i = 0; i < 9; ++i) {
        points += fmt::format("{},40\n", i);
        degrees += fmt::format("{},0\n", i);
        lifts += fmt::format("{},0\n", i);
    }
    EXPECT_EQ(
        refused(points),
        "t.csv: found points of a cam where the scene has no cam; allowed: displacements s_mm, s_in or s_m");
    EXPECT_EQ(refused(degrees),
              "t.csv: found angles where the lift is a length; allowed: displacements s_mm, s_in or s_m");
    EXPECT_EQ(refused(lifts, mm),
              "--probe-radius-mm: found with displacements; allowed: with points of the cam");
}

}  // namespace inspection_test
}  // namespace camopt
