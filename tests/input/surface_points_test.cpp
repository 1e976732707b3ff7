// SPDX-License-Identifier: MIT
// Points of cams with a known motion: what their follower does on them, and scenes that read such points.
#include "core/errors.hpp"
#include "core/numbers/robust_fit.hpp"
#include "core/units.hpp"
#include "input/scene_parts.hpp"
#include "input/scene_reader.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "profiles/factory/cam_formulas.hpp"
#include "scene/cam_mechanism.hpp"
#include "tests/report/temporary_folder.hpp"
#include "tests/support/refusal.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

namespace camopt::input {
namespace surface_points_test {

using Eigen::Vector2d;

constexpr double mm = 1e-3, um = 1e-6, degree = units::degree;

/// Cycloidal: rise of 80°, dwell of 40°, return of 120°, dwell.
FollowerState state_at(double theta, double lift) {
    const auto part = [&](double t, double angle, double sign) {
        FollowerState state;
        state.s = lift * (t - std::sin(units::turn * t) / units::turn);
        state.velocity = sign * lift * (1.0 - std::cos(units::turn * t)) / angle;
        state.acceleration = sign * sign * lift * units::turn * std::sin(units::turn * t) / (angle * angle);
        return state;
    };
    theta -= units::turn * std::floor(theta / units::turn);
    if (theta < 80.0 * degree) return part(theta / (80.0 * degree), 80.0 * degree, 1.0);
    if (theta < 120.0 * degree) return {lift, 0.0, 0.0};
    if (theta < 240.0 * degree)
        return part((240.0 * degree - theta) / (120.0 * degree), 120.0 * degree, -1.0);
    return {};
}

CamSpec cam_with(const Follower& follower, Rotation rotation) {
    using enum DimensionIndex;
    DiskSpec disk;
    disk.follower = follower.type;
    disk.rotation = rotation;
    const std::array<double, dimension_count> sizes = {40 * mm, 10 * mm, 6 * mm, 100 * mm, 80 * mm, 5 * mm};
    for (int i = 0; i < dimension_count; ++i)
        if (follower.dimensions[static_cast<std::size_t>(i)])
            disk[static_cast<DimensionIndex>(i)] = sizes[static_cast<std::size_t>(i)];
    return disk_spec(disk);
}

double lift_of(const Follower& follower) {
    return follower.oscillates ? 0.1 : 10 * mm;
}

/// Points, or centres of a probe, at 720 cam angles; `error`: along the normal, of each.
std::vector<Vector2d> points_on(
    const CamSpec& cam, double lift, double probe,
    const std::function<double(int)>& error = [](int) { return 0.0; }) {
    const auto formulas = cam.formulas();
    const std::vector<double> dimensions = cam.middle();
    std::vector<Vector2d> points;
    for (int i = 0; i < 720; ++i) {
        const double theta = units::turn * (i + 0.3) / 720;
        const MechanismPoint point = formulas->point(theta, {dimensions, state_at(theta, lift), theta}, 0);
        points.push_back(point.contact.head<2>() + (probe + error(i)) * point.normal.head<2>());
    }
    return points;
}

TEST(SurfacePoints, GiveMotionOfEveryFollower) {
    for (const Follower& follower : followers)
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise})
            for (const double probe : {0.0, 3 * mm}) {
                const CamSpec cam = cam_with(follower, rotation);
                const double lift = lift_of(follower);
                const SurfaceMotion motion =
                    motion_on_points(points_on(cam, lift, probe), false,
                                     *cam_under_follower(cam, {.probe_radius = probe}, lift));
                const double length = follower.oscillates ? 80 * mm : 1.0;
                EXPECT_GT(motion.angle.size(), 690U) << follower.name;
                for (std::size_t k = 0; k < motion.angle.size(); ++k)
                    EXPECT_NEAR(length * motion.displacement[k], length * state_at(motion.angle[k], lift).s,
                                0.5 * um)
                        << follower.name << " at " << motion.angle[k] / degree;
            }
}

TEST(SurfacePoints, NoiseRemainsThatOfThePoints) {
    for (const Follower& follower : followers) {
        const CamSpec cam = cam_with(follower, Rotation::counterclockwise);
        const double lift = lift_of(follower);
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0.0, 20 * um);
        const std::vector<Vector2d> points = points_on(cam, lift, 0.0, [&](int i) {
            return noise(random) + (i == 144 || i == 240 || i == 360 ? 300 * um : 0.0);
        });
        const SurfaceMotion motion = motion_on_points(points, false, *cam_under_follower(cam, {}, lift));
        std::vector<double> off;
        for (std::size_t k = 0; k < motion.angle.size(); ++k)
            off.push_back(motion.displacement[k] - state_at(motion.angle[k], lift).s);
        const double length = follower.oscillates ? 80 * mm : 1.0;
        EXPECT_NEAR(length * spread_of(off), 20 * um, 4 * um) << follower.name;
        EXPECT_LT(std::abs(length * median_of(off)), 3 * um) << follower.name;
        std::vector<std::size_t> named;
        for (const std::size_t row :
             outliers_of(motion.displacement, local_fits(motion.angle, motion.displacement, units::turn)))
            named.push_back(motion.rows[row]);
        std::ranges::sort(named);
        EXPECT_EQ(named, (std::vector<std::size_t>{144, 240, 360})) << follower.name;
    }
}

/// A dent narrower than the roller: it rests on the edges.
TEST(SurfacePoints, RollerRestsOnEdgesOfHollow) {
    const CamSpec cam = cam_with(followers[0], Rotation::counterclockwise);
    const auto point_at = [](double direction) {
        const double across = (direction - 1.0) / (3.0 * degree);
        const double radius = 40 * mm - 1 * mm * std::exp(-across * across);
        return Vector2d(radius * std::cos(direction), radius * std::sin(direction));
    };
    std::vector<Vector2d> points, fine;
    for (int i = 0; i < 720; ++i) points.push_back(point_at(units::turn * i / 720));
    for (int i = 0; i < 20000; ++i) fine.push_back(point_at(units::turn * i / 20000));
    const FollowerGeometry follower = cam.formulas()->follower(cam.middle(), 0).value();
    const SurfaceMotion motion = motion_on_points(points, false, *cam_under_follower(cam, {}, 10 * mm));
    EXPECT_GT(motion.untouched, 5);
    for (std::size_t k = 0; k < motion.angle.size(); k += 3) {
        const Eigen::Rotation2Dd turn(motion.angle[k]);
        double highest = 0.0;
        for (const Vector2d& point : fine) {
            const Vector2d seen = turn * point;
            const double across = seen.x() - follower.offset, square = 100 * mm * mm - across * across;
            if (square > 0.0) highest = std::max(highest, seen.y() + std::sqrt(square));
        }
        EXPECT_NEAR(motion.displacement[k], highest - follower.rest_position(), 2 * um)
            << motion.angle[k] / degree;
    }
}

class SurfaceScene : public ::testing::Test {
 protected:
    [[nodiscard]] Scene read(const std::string& table, const std::string& measured) const {
        std::ofstream(folder_.path() + "/m.csv", std::ios::binary) << table;
        std::ofstream(folder_.path() + "/s.toml", std::ios::binary) << scene + "[measured]\n" + measured;
        const KnownNames known = {.laws = {"modified_sine"}, .solvers = {}, .cam_formulas = cam_formulas};
        const std::filesystem::path file = std::filesystem::path(folder_.path()) / "s.toml";
        const Scene read = read_scene_file(file, known);
        EXPECT_EQ(read_scene(whole_scene_text(file), "s.toml", known).measured->displacement,
                  read.measured->displacement);
        return read;
    }
    [[nodiscard]] std::string refused(const std::string& table, const std::string& measured) const {
        std::string words = testing_support::refusal([&] { (void)read(table, measured); });
        const std::string path = folder_.path() + "/";
        for (std::size_t at = words.find(path); at != std::string::npos; at = words.find(path))
            words.erase(at, path.size());
        return words;
    }
    /// The points of the scene's own cam.
    [[nodiscard]] static std::string table(const char* header, bool polar, double probe = 0.0) {
        std::string text = std::string(header) + "\n";
        const CamSpec cam = cam_with(followers[0], Rotation::counterclockwise);
        for (const Vector2d& point : points_on(cam, 10 * mm, probe)) {
            if (polar)
                text += fmt::format("{:.7f},{:.7f}\n", std::atan2(point.y(), point.x()) / degree,
                                    point.norm() / mm);
            else
                text += fmt::format("{:.7f},{:.7f}\n", point.x() / mm, point.y() / mm);
        }
        return text;
    }
    static void expect_motion(const Scene& scene) {
        const MeasuredMotion& motion = *scene.measured;
        EXPECT_GT(motion.angle.size(), 700U);
        for (std::size_t k = 0; k < motion.angle.size(); ++k)
            EXPECT_NEAR(motion.displacement[k], state_at(motion.angle[k], 10 * mm).s, 0.1 * um);
    }

    test::TemporaryFolder folder_;
    const std::string scene = R"(
[motion]
type = "program"
lift_mm = 10
segments = [{ kind = "spline", angle_deg = 80, to = 1 }, { kind = "dwell", angle_deg = 40 },
            { kind = "spline", angle_deg = 120, to = 0 }, { kind = "dwell", angle_deg = 120 }]
[objective]
jerk = 1
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 40
roller_radius_mm = 10
offset_mm = 6
)";
};

TEST_F(SurfaceScene, PointsBecomeMotionOfItsFollower) {
    expect_motion(read(table("x_mm,y_mm", false), "table = \"m.csv\"\n"));
    expect_motion(read(table("theta_deg,r_mm", true), "table = \"m.csv\"\n"));
    expect_motion(read(table("x_mm,y_mm", false, 3 * mm), "table = \"m.csv\"\nprobe_radius_mm = 3\n"));
}

TEST_F(SurfaceScene, NamesWhatPointsNeed) {
    const std::string points = table("x_mm,y_mm", false);
    EXPECT_EQ(
        refused(points, "table = \"m.csv\"\nzero = \"nose\"\n"),
        "s.toml:17:1: measured.zero: found with points of the cam; allowed: with displacements; register = "
        "[\"angle\"] finds the angle of points");
    EXPECT_EQ(
        refused("theta_deg,s_mm\n0,0\n", "table = \"m.csv\"\nprobe_radius_mm = 1\n"),
        "s.toml:17:1: measured.probe_radius_mm: found with displacements; allowed: with points of the cam");
    EXPECT_EQ(refused(points.substr(0, points.size() / 2), "table = \"m.csv\"\n").substr(0, 26),
              "m.csv:2: points: found no ");
    EXPECT_EQ(refused("", "x_mm = [1]\n"), "s.toml:15:1: measured.y_mm: missing; allowed: x_mm with y_mm");
}

}  // namespace surface_points_test
}  // namespace camopt::input
