// SPDX-License-Identifier: MIT
// Cams of the example scenes as points of their surface, read back as given cams: the motion returns.
#include "input/loading/load_scene.hpp"
#include "input/scene_text.hpp"
#include "scene/cam_flanks.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "studies/spatial/spatial_forward_check.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"
#include "tests/support/source_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>

namespace camopt {
namespace given_cam_test {

using testing_support::says;

constexpr double um = 1e-6;

/// A scene of the examples, solved without a proof.
Solution solved_example(const std::string& name) {
    return solve_without_explaining(testing_support::scene_named(name), {}, nullptr, {.look = true});
}

struct Points {
    std::string first, second;  ///< columns
    std::vector<double> a, b;   ///< SI

    [[nodiscard]] std::string toml() const {
        const auto list = [](const std::vector<double>& numbers) {
            std::string text;
            for (const double number : numbers)
                text += fmt::format("{}{:.17g}", text.empty() ? "" : ",", number);
            return text;
        };
        return fmt::format("{} = [{}]\n{} = [{}]\n", first, list(a), second, list(b));
    }
};

/// Of one side along the motion, each moved by `error` along its normal; centers: of the roller.
Points plane_points(const Solution& solution, int side, int count, bool centers,
                    const std::function<double()>& error) {
    const DrivenMechanism& cam = solution.cam->cam;
    const MotionChain motion = cam_motion(solution);
    Points points{"x_m", "y_m", {}, {}};
    for (const MechanismPoint& point :
         mechanism_profile(cam, motion, motion_scale(solution.scene), count, side).points) {
        const Eigen::Vector3d at = (centers ? point.pitch : point.contact) + error() * point.normal;
        if (!points.a.empty() && std::hypot(at.x() - points.a.back(), at.y() - points.b.back()) < 1e-9)
            continue;
        points.a.push_back(at.x());
        points.b.push_back(at.y());
    }
    return points;
}

/// Of a flank, or of the groove's middle, on a cylinder.
Points drum_points(const Solution& solution, int flank, int count, double radius,
                   const std::function<double()>& error) {
    const CamFlanks cam = solved_flanks(solution);
    const MotionChain motion = cam_motion(solution);
    const FollowerMotion turn = follower_motion(motion, motion_scale(solution.scene));
    Points points{"theta_rad", "z_m", {}, {}};
    double before = 0.0;
    for (int i = 0; i <= count; ++i) {
        const double theta = turn.begin() + (turn.end() - turn.begin()) * i / count;
        const FollowerState state = turn.state(theta);
        const auto place = [&](double height) -> Eigen::Vector3d {
            const RollerAxis axis = cam.axis(theta, state.s);
            if (flank == 0) return axis.foot + height * axis.direction;
            return cam.point(theta, state, {height, flank}).contact;
        };
        double low = -cam.roller_length, high = 2.0 * cam.roller_length;
        const bool falls = place(low).head<2>().norm() > place(high).head<2>().norm();
        for (int k = 0; k < 80; ++k) {
            const double middle = 0.5 * (low + high);
            const bool outside = place(middle).head<2>().norm() > radius;
            (outside == falls ? low : high) = middle;
        }
        const Eigen::Vector3d at = place(low);
        if (!at.allFinite()) continue;  // at rest the roller has no flank
        double angle = std::atan2(at.y(), at.x());
        if (!points.a.empty()) angle = before + std::remainder(angle - before, units::turn);
        if (!points.a.empty() && std::abs(angle - before) < 1e-9) continue;
        before = angle;
        points.a.push_back(angle);
        points.b.push_back(at.z() + error());
    }
    if (points.a.front() > points.a.back()) {
        std::ranges::reverse(points.a);
        std::ranges::reverse(points.b);
    }
    return points;
}

/// The scene with the dimensions that were found, and the cam as given.
Scene given_scene(const Solution& solution, const std::string& measured) {
    Scene scene = solution.scene;
    for (std::size_t d = 0; d < scene.cam->dimensions.size(); ++d)
        if (scene.cam->dimensions[d].value.is_variable()) {
            Dimension& value = scene.cam->dimensions[d].value;
            value.low = value.high = solution.cam->cam.dimensions[d];
        }
    scene.objective.sought.reset();
    scene.objective.dimensions = {};
    scene.measured.reset();
    scene.measured_rows.reset();
    if (scene.forces) scene.forces->fix();
    for (ProgramSegment& segment : scene.motion.segments) segment.angle_range.reset();
    scene.spline.free_knots = false;
    return scene_of_toml(input::scene_text(scene) + "\n[measured]\nuse = \"given\"\n" + measured);
}

struct Returned {
    double largest = 0.0, rms = 0.0;  ///< of the difference, in lifts
    double error = 0.0;               ///< its standard error
};

Returned returned(const Solution& nominal, const std::string& measured) {
    const Solution given = solve(given_scene(nominal, measured));
    EXPECT_EQ(given.certificate.reason, Reason::given_cam);
    if (!given.motion) return {infinity, infinity, 0.0};
    Returned found{0.0, 0.0, given.measured->noise->error[0]};
    constexpr int places = 2000;
    const double begin = nominal.motion->begin(), end = nominal.motion->end();
    for (int i = 0; i < places; ++i) {
        const double x = begin + (end - begin) * (i + 0.5) / places;
        const double off = given.motion->at(x).derivative[0] - nominal.motion->at(x).derivative[0];
        found.largest = std::max(found.largest, std::abs(off));
        found.rms += off * off / places;
    }
    found.rms = std::sqrt(found.rms);
    return found;
}

std::vector<std::string> points_of(const Solution& nominal, int count, const std::function<double()>& error) {
    const DrivenMechanism& cam = nominal.cam->cam;
    std::vector<std::string> all;
    if (const std::optional<CamFlanks> flanks = cam.formulas->flanks(cam.dimensions)) {
        const Eigen::Vector3d foot = flanks->axis(0.0, 0.5 * nominal.scene.motion.lift).foot;
        const double radius = foot.head<2>().norm() - 0.5 * flanks->roller_length;
        for (const int side : {1, 2, 0}) {
            const int flank = side == 0 ? 0 : side == 1 ? 1 : -1;
            all.push_back(drum_points(nominal, flank, count, radius, error).toml() +
                          fmt::format("radius_m = {:.17g}\n", radius) +
                          (side == 0 ? "of = \"center\"\n" : fmt::format("side = {}\n", side)));
        }
        return all;
    }
    for (int side = 0; side < cam.formulas->stations(); ++side)
        all.push_back(plane_points(nominal, side, count, false, error).toml() +
                      fmt::format("side = {}\n", side + 1));
    if (cam.formulas->contact() == ContactKind::roller)
        all.push_back(plane_points(nominal, 0, count, true, error).toml() + "of = \"center\"\n");
    return all;
}

/// In lifts. The point at which a flat face touches runs over the sharp places of these cams between two
/// points.
double largest_without_noise(const std::string& name) {
    static const std::map<std::string, double> of_flat_faces = {
        {"valve_exhaust", 1e-4}, {"cam_flat", 5e-5}, {"valve_intake", 5e-6}};
    const auto own = of_flat_faces.find(name);
    return own == of_flat_faces.end() ? 1e-6 : own->second;
}

void expect_return(const std::string& name, int count) {
    SCOPED_TRACE(name);
    const Solution nominal = solved_example(name);
    ASSERT_TRUE(nominal.motion && nominal.cam);
    for (const std::string& points : points_of(nominal, count, [] { return 0.0; })) {
        SCOPED_TRACE(points.substr(points.rfind("]\n") + 2));
        const Returned exact = returned(nominal, points);
        EXPECT_LT(exact.largest, largest_without_noise(name));
    }
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 20 * um);
    for (const std::string& points : points_of(nominal, count, [&] { return noise(random); })) {
        SCOPED_TRACE(points.substr(points.rfind("]\n") + 2));
        const Returned noisy = returned(nominal, points);
        EXPECT_LT(noisy.rms, 3.0 * noisy.error);
        ::testing::Test::RecordProperty(name, fmt::format("{:.3g} of {:.3g}", noisy.rms, noisy.error));
    }
}

TEST(GivenCam, MotionReturnsFromPoints) {
    for (const char* const name :
         {"cam_roller", "cam_arm_flat", "linear_press", "linear_arm", "cylinder_slide"})
        expect_return(name, 1440);
}

/// An eccentric circle in four arcs: y = −e cos θ + √(R² − e² sin² θ) of its roller's centre.
TEST(GivenCam, ArcsAreFollowedExactly) {
    const Solution given = solve(scene_of_toml(R"(
measured.use = "given"
[motion]
type = "program"
lift_mm = 10
[cam]
type = "disk"
follower = "translating_roller"
base_radius_mm = 35
roller_radius_mm = 10
[[cam.piece]]
to_mm = [50, -5]
center_mm = [0, -5]
[[cam.piece]]
to_mm = [0, -55]
center_mm = [0, -5]
[[cam.piece]]
to_mm = [-50, -5]
center_mm = [0, -5]
[[cam.piece]]
to_mm = [0, 45]
center_mm = [0, -5]
[limits]
pressure_angle_deg = 5
)"));
    ASSERT_TRUE(given.motion);
    const auto exact = [](long double x) {
        constexpr long double turn = 2.0L * std::numbers::pi_v<long double>, e = 0.5L, r = 5.0L;
        const long double sine = std::sin(turn * x);
        return -e * std::cos(turn * x) + std::sqrt(r * r - e * e * sine * sine) - 4.5L;
    };
    const std::array<double, 4> size = {1.0, given.motion_peaks.velocity.value,
                                        given.motion_peaks.acceleration.value, given.motion_peaks.jerk.value};
    constexpr std::array<double, 4> allowed = {1e-11, 1e-8, 1e-6, 1e-4};
    for (int i = 0; i < 400; ++i) {
        const double x = (i + 0.5) / 400;
        constexpr long double h = 1e-3L;
        const auto at = [&](int k) { return exact(x + k * h); };
        const std::array<long double, 4> wanted = {
            exact(x), (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h),
            (-30 * at(0) + 16 * (at(1) + at(-1)) - (at(2) + at(-2))) / (12 * h * h),
            (-13 * (at(1) - at(-1)) + 8 * (at(2) - at(-2)) - (at(3) - at(-3))) / (8 * h * h * h)};
        for (std::size_t order = 0; order < 4; ++order)
            EXPECT_NEAR(given.motion->at(x).derivative[order], static_cast<double>(wanted[order]),
                        allowed[order] * size[order])
                << order << " at " << x;
    }
    EXPECT_EQ(given.certificate.verdict, Verdict::feasible);
    EXPECT_EQ(given.certificate.reason, Reason::given_cam);
    ASSERT_EQ(given.constraints.size(), 1U);
    EXPECT_NEAR(given.constraints[0].worst, std::asin(5.0 / 50.0) / units::degree, 1e-6);
    EXPECT_GT(given.certificate.worst_violation, 0.0);
}

/// A drum that is turned on the table, and higher; a plate farther along and higher.
TEST(GivenCam, RegistrationFindsAngleAndHeight) {
    const Scene drum = testing_support::scene_named("given_drum");
    const MeasuredRows& rows = drum.measured_rows.value();
    Points points{"theta_rad", "z_m", {}, rows.z};
    for (const double theta : rows.theta) points.a.push_back(theta + 37.3 * units::degree);
    for (double& z : points.b) z += 250 * um;
    const std::string registered = "register = [\"angle\", \"radius\"]\n";
    Scene plain = drum;
    plain.measured.reset();
    plain.measured_rows.reset();
    const Scene turned =
        scene_of_toml(input::scene_text(plain) + "\n[measured]\nuse = \"given\"\nradius_m = 0.055\n" +
                      registered + points.toml());
    const MeasuredPlace& place = turned.measured->place.value();
    EXPECT_EQ(place.law, "modified_sine");
    EXPECT_NEAR(place.angle->value, 37.3 * units::degree, 4.0 * place.angle->error);
    EXPECT_NEAR(place.zero->value, 250 * um, 4.0 * place.zero->error);
    EXPECT_LT(place.angle->error, 0.05 * units::degree);

    const Solution plate = solved_example("linear_press");
    Points moved = plane_points(plate, 0, 720, false, [] { return 0.0; });
    const double slide = plate.cam->cam.formulas->length(plate.cam->cam.dimensions);
    for (double& x : moved.a) x += 5.0 * units::degree * slide;
    for (double& y : moved.b) y += 250 * um;
    const Scene found = given_scene(plate, registered + moved.toml());
    const MeasuredPlace& at = found.measured->place.value();
    const double lean = plate.scene.cam->find("inclination")->middle();
    EXPECT_NEAR(at.zero->value, 250 * um / std::cos(lean), 5 * um);
    EXPECT_NEAR(at.angle->value, 5.0 * units::degree - 250 * um * std::tan(lean) / slide,
                0.1 * units::degree);
}

/// The middle of a guide before its rise: on the line from the pivot to its first point.
void add_inner_dwell(const Solution& nominal, Points& points, const std::function<double()>& error) {
    const Points exact = plane_points(nominal, 0, 16, true, [] { return 0.0; });
    const double x = exact.a.front(), y = exact.b.front(), length = std::hypot(x, y);
    for (int k = 1; k <= 60; ++k) {
        const double part = 1.0 - 0.003 * k, off = error() / length;
        points.a.insert(points.a.begin(), part * x - off * y);
        points.b.insert(points.b.begin(), part * y + off * x);
    }
}

/// Turned on the table, a remote lever's cam about its axis and a guide about the pivot of its body.
TEST(GivenCam, RegistrationFindsTurnedCamsAndGuides) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 5 * um);
    constexpr const char* laws =
        "motion.segments = [{ kind = 'law', law = 'modified_trapezoid', angle_deg = 105, to = 1 }, "
        "{ kind = 'dwell', angle_deg = 75 }, { kind = 'law', law = 'modified_trapezoid', angle_deg = 105, to "
        "= 0 }, "
        "{ kind = 'dwell', angle_deg = 75 }]";
    for (const auto& [scene, turned] :
         {std::pair(testing_support::scene_named("tappet_75").with(laws, "limits.pressure_angle_deg = 40"),
                    12.7),
          std::pair(testing_support::scene_named("inverse_feeder"), -8.4)}) {
        const Solution nominal = solve_without_explaining(scene, {}, nullptr, {.look = true});
        SCOPED_TRACE(nominal.scene.title);
        ASSERT_TRUE(nominal.motion);
        const bool guide = nominal.scene.cam->type == "inverse";
        Points points = plane_points(nominal, 0, 1440, guide, [&] { return noise(random); });
        if (guide) add_inner_dwell(nominal, points, [&] { return noise(random); });
        const double c = std::cos(turned * units::degree), s = std::sin(turned * units::degree);
        for (std::size_t i = 0; i < points.a.size(); ++i) {
            const double x = points.a[i], y = points.b[i];
            points.a[i] = c * x - s * y;
            points.b[i] = s * x + c * y;
        }
        const Scene found = given_scene(
            nominal, "register = [\"angle\"]\n" + points.toml() + (guide ? "of = \"center\"\n" : ""));
        const MeasuredPlace& place = found.measured->place.value();
        EXPECT_TRUE(place.points);
        EXPECT_NEAR(place.angle->value, turned * units::degree, 4.0 * place.angle->error);
        EXPECT_LT(place.angle->error, 0.02 * units::degree);
    }
    const Solution nominal = solved_example("inverse_feeder");
    const Points points = plane_points(nominal, 0, 720, false, [] { return 0.0; });
    EXPECT_TRUE(says(testing_support::refusal(
                         [&] { (void)given_scene(nominal, "register = [\"radius\"]\n" + points.toml()); }),
                     "a guide is turned about its pivot"));
}

/// A scene made by a program, without a file: rows of its follower.
TEST(GivenCam, RowsInMemoryAreItsMotion) {
    Scene scene;
    scene.motion.type = MotionType::program;
    scene.motion.lift = 0.01;
    ProgramSegment around;
    around.kind = SegmentKind::spline;
    around.angle = units::turn;
    scene.motion.segments = {around};
    MeasuredMotion rows;
    rows.given = true;
    for (int i = 0; i < 360; ++i) {
        rows.angle.push_back(i * units::degree);
        rows.displacement.push_back(0.005 * (1.0 - std::cos(rows.angle.back())));
    }
    scene.measured = rows;
    const Solution given = solve(scene);
    ASSERT_TRUE(given.motion);
    EXPECT_EQ(given.certificate.reason, Reason::given_cam);
    for (int i = 0; i < 100; ++i) {
        const double x = (i + 0.5) / 100.0;
        EXPECT_NEAR(given.motion->at(x).derivative[0], 0.5 * (1.0 - std::cos(units::turn * x)), 1e-8);
        EXPECT_NEAR(given.motion->at(x).derivative[2],
                    2.0 * std::numbers::pi * std::numbers::pi * std::cos(units::turn * x), 1e-3);
    }
}

/// Its curve through a turn ends where it begins, but for rounding.
TEST(GivenCam, ForwardCheckFollowsClosedDrums) {
    const ForwardCheckReport check = check_flanks(solve(testing_support::scene_named("given_drum")));
    EXPECT_LT(check.relative, 1e-9);
}

/// Every example with a cam whose solve delivers a motion.
TEST(GivenCam, EveryExampleReturnsItsMotion) {
    int tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() + "/scenes")) {
        if (entry.path().extension() != ".toml") continue;
        const std::string name = entry.path().stem().string();
        std::ifstream file(entry.path());
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        if (text.find("\n[cam]") == std::string::npos || text.find("use = \"given\"") != std::string::npos)
            continue;
        if (name == "cam_infeasible" || name == "cam_undercut")
            continue;  // no motion; a cam it does not touch
        if (text.find("prescribe = \"output\"") != std::string::npos)
            continue;  // refused: the motion of a given cam is the cam's
        expect_return(name, 3600);
        ++tried;
    }
    EXPECT_GE(tried, 25);
}

}  // namespace given_cam_test
}  // namespace camopt
