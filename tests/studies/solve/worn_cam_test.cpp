// SPDX-License-Identifier: MIT
// A worn cam with a known lobe, measured in an unknown position: what is found of it, and the nearest motion.
#include "core/errors.hpp"
#include "core/units.hpp"
#include "input/loading/load_scene.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/solve/solution_tables.hpp"
#include "scene/cam_mechanism.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace worn_cam_test {

using testing_support::says;

constexpr double mm = 1e-3, um = 1e-6, degree = units::degree;
constexpr double lift = 10 * mm, turned = 37.3 * degree, worn_radius = 39.85 * mm;

const std::string head = R"(
[motion]
type = "program"
lift_mm = 10
segments = [{ kind = "spline", angle_deg = 80, to = 1 }, { kind = "dwell", angle_deg = 40 },
            { kind = "spline", angle_deg = 120, to = 0 }, { kind = "dwell", angle_deg = 120 }]
[spline]
segments = 12
)";
const std::string cam = R"(
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 40
roller_radius_mm = 10
offset_mm = 6
rotation = "counterclockwise"
)";

/// The lobe: s and its derivative by the cam angle.
FollowerState lobe_at(double theta, const Law& law) {
    theta -= units::turn * std::floor(theta / units::turn);
    const auto stroke = [&](double t, double angle, double sign) {
        const auto y = law.at(t).derivative;
        return FollowerState{lift * y[0], sign * lift * y[1] / angle, lift * y[2] / (angle * angle)};
    };
    if (theta < 80 * degree) return stroke(theta / (80 * degree), 80 * degree, 1.0);
    if (theta < 120 * degree) return {lift, 0.0, 0.0};
    if (theta < 240 * degree) return stroke((240 * degree - theta) / (120 * degree), 120 * degree, -1.0);
    return {};
}

/// 20 µm of noise, and outliers in the rows 41, 151 and 222.
class Scatter {
 public:
    explicit Scatter(unsigned seed, double noise = 20 * um) : random_(seed), noise_(0.0, noise) {}
    double operator()(int i) {
        return noise_(random_) + (i == 40 ? 0.35 : i == 150 ? -0.3 : i == 221 ? 0.5 : 0.0) * mm;
    }

 private:
    std::mt19937 random_;
    std::normal_distribution<double> noise_;
};

std::string points_text(unsigned seed) {
    DiskSpec disk;
    disk[DimensionIndex::base_radius] = worn_radius;
    disk[DimensionIndex::roller_radius] = 10 * mm;
    disk[DimensionIndex::offset] = 6 * mm;
    const CamSpec spec = disk_spec(disk);
    const auto formulas = spec.formulas();
    const std::vector<double> dimensions = spec.middle();
    const auto law = make_law("cycloidal");
    const Eigen::Rotation2Dd turn(-turned);
    Scatter scatter(seed);
    std::string x, y;
    for (int i = 0; i < 360; ++i) {
        const double theta = (i + 0.3) * degree;
        const MechanismPoint point = formulas->point(theta, {dimensions, lobe_at(theta, *law), theta}, 0);
        const Eigen::Vector2d at = turn * (point.contact.head<2>() + scatter(i) * point.normal.head<2>());
        x += fmt::format("{}{:.4f}", i > 0 ? ", " : "", at.x() / mm);
        y += fmt::format("{}{:.4f}", i > 0 ? ", " : "", at.y() / mm);
    }
    return fmt::format("x_mm = [{}]\ny_mm = [{}]\n", x, y);
}

Scene worn_scene(unsigned seed, const std::string& measured) {
    return scene_of_toml(head + "[limits]\nacceleration = 7\n" + cam + "[measured]\n" + points_text(seed) +
                         "register = [\"angle\", \"radius\"]\nuse = \"nearest\"\n" + measured);
}

std::vector<int> outlying_rows(const MeasuredMotion& measured) {
    std::vector<int> rows;
    for (const MeasuredOutlier& outlier : measured.outliers) rows.push_back(outlier.row);
    std::ranges::sort(rows);
    return rows;
}

TEST(WornCam, PositionIsFoundWithinStandardErrors) {
    for (const unsigned seed : {1U, 2U, 3U, 4U}) {
        const MeasuredMotion measured = *worn_scene(seed, "").measured;
        ASSERT_TRUE(measured.place && measured.place->angle && measured.place->zero);
        const MeasuredPlace& place = *measured.place;
        EXPECT_EQ(place.law, "cycloidal");
        EXPECT_NEAR(place.angle->value, -turned, 4.0 * place.angle->error);
        EXPECT_LT(place.angle->error, 0.05 * degree);
        EXPECT_NEAR(*place.base_radius, worn_radius, 4.0 * place.zero->error);
        EXPECT_LT(place.zero->error, 5 * um);
        EXPECT_EQ(outlying_rows(measured), (std::vector<int>{41, 151, 222}));
        EXPECT_EQ(measured.angle.size(), 360U);
        EXPECT_EQ(measured.untouched, 0);
    }
}

TEST(WornCam, NearestMotionIsProved) {
    const Solution solution = solve(worn_scene(5, "norm = \"rms\"\noutliers = \"exclude\"\n"));
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    EXPECT_EQ(outlying_rows(*solution.scene.measured), (std::vector<int>{41, 151, 222}));
    EXPECT_EQ(solution.scene.measured->angle.size(), 357U);
    const std::string words = measured_sentence(solution);
    EXPECT_TRUE(says(words, "outliers (excluded): "));
    EXPECT_TRUE(says(words, "row 151 at 150."));
    EXPECT_TRUE(says(words, "the cam is turned by −37."));
    const auto law = make_law("cycloidal");
    const double unit = solution.scene.motion.unit_angle();
    double largest = 0.0;
    for (int i = 0; i <= 240; ++i) {
        const double s = lift * solution.motion->at(i * degree / unit).derivative[0];
        largest = std::max(largest, std::abs(s - lobe_at(i * degree, *law).s));
    }
    EXPECT_LT(largest, 25 * um);  // the noise of one row is 20 µm
}

TEST(WornCam, LiftsAreFoundByAngleAlone) {
    const auto law = make_law("modified_sine");
    Scatter scatter(6, 5 * um);
    std::string lifts;
    for (int i = 0; i < 360; ++i)
        lifts += fmt::format("{}{:.4f}", i > 0 ? ", " : "",
                             (lobe_at((i - 200) * degree, *law).s + scatter(i)) / mm);
    const auto read = [&](const std::string& motion, const std::string& measured) {
        return scene_of_toml(motion + "[objective]\njerk = 1\n[measured]\ns_mm = [" + lifts +
                             "]\nstep_deg = 1\n" + measured);
    };
    const MeasuredMotion measured = *read(head, "register = [\"angle\"]\n").measured;
    ASSERT_TRUE(measured.place);
    EXPECT_EQ(measured.place->law, "modified_sine");
    EXPECT_FALSE(measured.place->zero);
    EXPECT_NEAR(std::remainder(measured.place->angle->value - 200 * degree, units::turn), 0.0,
                4.0 * measured.place->angle->error);
    EXPECT_LT(measured.place->angle->error, 0.02 * degree);
    EXPECT_EQ(outlying_rows(measured), (std::vector<int>{41, 151, 222}));
    const auto refused = [&](const std::string& motion, const std::string& words) {
        return testing_support::refusal([&] { (void)read(motion, words); });
    };
    EXPECT_TRUE(says(refused(head, "register = [\"angle\"]\nzero = \"nose\"\n"),
                     "measured.zero: found together with register = [\"angle\"]"));
    EXPECT_TRUE(says(refused(head, "register = [\"size\"]\n"),
                     "found \"size\" in the array; allowed: angle or radius"));
    EXPECT_TRUE(says(
        refused("motion = { type = \"DRD\", lift_mm = 10, rise_deg = 80 }\n", "register = [\"angle\"]\n"),
        "found a table of a whole revolution where the motion is a part of one"));
}

}  // namespace worn_cam_test
}  // namespace camopt
