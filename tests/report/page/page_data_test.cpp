// SPDX-License-Identifier: MIT
// The data of a page are the result's: curves those of the motion, marks those of the tables, poses those of
// the follower.
#include "core/units.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "report/cam/cam_files.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/page/result_page.hpp"
#include "report/view/shown_units.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "tests/report/sample_solution.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace camopt {
namespace page_data_test {

using nlohmann::json;

constexpr double printed = 1e-7;  // relative: eight digits

json data_of(const Solution& solution) {
    return json::parse(page_data(solution, {"scene.toml", "camopt solve scene.toml", "title = \"x\"\n"}));
}

const json& curve(const json& data, const std::string& key) {
    for (const json& one : data.at("curves"))
        if (one.at("key") == key) return one;
    throw std::runtime_error("no curve " + key);
}

void expect_close(const json& shown, double value) {
    ASSERT_TRUE(shown.is_number()) << shown;
    EXPECT_NEAR(shown.get<double>(), value, printed * std::abs(value) + 1e-12);
}

TEST(PageData, CurvesAreInShownUnits) {
    const Solution solution = test::sample_solution();
    const json data = data_of(solution);
    const ShownUnits units = shown_units(solution.scene);
    const auto rows = motion_rows(*solution.motion, solution.motion_peaks);
    const json& angles = data.at("angle").at("values");
    ASSERT_EQ(angles.size(), rows.size());
    const char* const keys[] = {"displacement", "velocity", "acceleration", "jerk"};
    for (std::size_t order = 0; order < 4; ++order) {
        const json& one = curve(data, keys[order]);
        EXPECT_EQ(one.at("unit"), units.motion[order].first.name);
        ASSERT_EQ(one.at("values").size(), rows.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            expect_close(angles[i], units.degrees_per_x * rows[i].x);
            const double y = solution.motion->at(rows[i].x, rows[i].side).derivative[order];
            expect_close(one.at("values")[i], units.motion[order].first.per_normalised * y);
        }
    }
}

TEST(PageData, ExactPointsAreMarkedAsGiven) {
    Solution solution = test::sample_solution();
    solution.scene.motion.via = {{0.5, 0.5, 2.0, {}}};
    const json data = data_of(solution);
    const json& given = curve(data, "displacement").at("marks").at(0);
    EXPECT_TRUE(given.at("given"));
    expect_close(given.at("at"), 45.0);
    expect_close(given.at("value"), 5.0);
    EXPECT_TRUE(curve(data, "velocity").at("marks").at(1).at("given"));
    EXPECT_EQ(curve(data, "acceleration").at("marks").size(), 2U);
}

TEST(PageData, DisplacementOutsideStrokeIsMarked) {
    Solution solution = test::cam_solution();
    EXPECT_TRUE(curve(data_of(solution), "displacement").at("marks").empty());
    ChainPart part = solution.motion->parts().front();
    part.y0 -= 0.32;
    solution.motion = std::make_shared<const MotionChain>(std::vector<ChainPart>{part});
    const json data = data_of(solution);
    const json& mark = curve(data, "displacement").at("marks").at(0);
    EXPECT_EQ(mark.at("words"), "−3.2 mm");
    EXPECT_NE(data.at("verdict").at("sentences").dump().find("3.2 mm below its start at 0 deg"),
              std::string::npos);
}

TEST(PageData, FlatFaceOmitsZeroPressureAngle) {
    Solution solution = test::cam_solution();
    solution.scene.cam = disk_spec({.follower = FollowerType::translating_flat});
    solution.scene.cam->set(DimensionIndex::base_radius, 30 * units::millimetre);
    solution.scene.limits.pressure_angle.reset();
    solution.cam = cam_report(solution.scene, solution.scene.cam->middle(), *solution.motion);
    EXPECT_THROW((void)curve(data_of(solution), "pressure_angle"), std::runtime_error);
    EXPECT_NO_THROW((void)curve(data_of(solution), "curvature"));
}

TEST(PageData, LocalOptimumReportsGap) {
    Solution solution = test::cam_solution();
    solution.certificate.verdict = Verdict::local;
    solution.certificate.lower_bound = solution.certificate.objective * (1.0 - 1.6e-6);
    solution.certificate.gap = 1.6e-6;
    const std::string sentences = data_of(solution).at("verdict").at("sentences").dump();
    EXPECT_NE(sentences.find("it is at most 0.0002 % from the optimum"), std::string::npos) << sentences;
    EXPECT_EQ(sentences.find("ruled out"), std::string::npos) << sentences;
}

TEST(PageData, CamMarksMatchSummary) {
    const Solution solution = test::cam_solution();
    const json data = data_of(solution);
    const CamSummary& summary = solution.cam->summary;
    const double degrees = shown_units(solution.scene).degrees_per_x;
    const json& pressure = curve(data, "pressure_angle").at("marks").at(0);
    expect_close(pressure.at("at"), degrees * summary.pressure_angle.at);
    EXPECT_NEAR(std::abs(pressure.at("value").get<double>()), summary.pressure_angle.value / units::degree,
                1e-6);
    const json& hertz = curve(data, "hertz_pressure").at("marks").at(0);
    expect_close(hertz.at("at"), degrees * summary.forces->hertz_pressure->at);
    expect_close(hertz.at("value"), summary.forces->hertz_pressure->value / 1e6);
    const json& torque = curve(data, "torque").at("marks").at(0);
    EXPECT_NEAR(std::abs(torque.at("value").get<double>()), summary.forces->torque.value,
                1e-6 * summary.forces->torque.value);
}

/// The drawn points pass the extremes nowhere, and come close to them: curve and mark are one figure.
TEST(PageData, CamCurvesReachTheirExtremes) {
    const Solution solution = test::cam_solution();
    const json data = data_of(solution);
    for (const char* const key : {"pressure_angle", "torque", "normal_force", "hertz_pressure", "force"}) {
        double most = 0.0;
        const json& one = curve(data, key);
        for (const json& value : one.at("values"))
            if (value.is_number()) most = std::max(most, std::abs(value.get<double>()));
        double marked = 0.0;
        for (const json& mark : one.at("marks"))
            marked = std::max(marked, std::abs(mark.at("value").get<double>()));
        EXPECT_LE(most, marked * (1.0 + 1e-6)) << key;
        EXPECT_GE(most, 0.995 * marked) << key;
    }
}

/// By row the roller's centre stands where the cam frame, turned, has the pitch point.
TEST(PageData, FollowerTouchesRotatedCam) {
    const Solution solution = test::cam_solution();
    const json data = data_of(solution);
    const json& drawing = data.at("drawing");
    const MotionChain motion = cam_motion(solution);
    const MotionScale scale = motion_scale(solution.scene);
    const json* roller = nullptr;
    for (const json& part : drawing.at("parts"))
        if (part.at("name") == "roller") roller = &part;
    ASSERT_NE(roller, nullptr);
    EXPECT_EQ(roller->at("kind"), "circle");
    expect_close(roller->at("radius"), 10.0);
    const json& angles = data.at("angle").at("values");
    ASSERT_EQ(roller->at("points").size(), 2 * angles.size());
    for (std::size_t i = 0; i < angles.size(); i += 17) {
        const double theta = angles[i].get<double>() * units::degree;
        const double x = std::min(theta / scale.unit_angle, motion.end());
        const MechanismPoint point = mechanism_point(
            solution.cam->cam, motion.at(x, x < motion.end() ? Side::right : Side::left), scale);
        const double turned = drawing.at("turned")[i].get<double>() * units::degree;
        EXPECT_NEAR(turned, theta, 1e-7);
        const double c = std::cos(turned), s = std::sin(turned);
        EXPECT_NEAR(roller->at("points")[2 * i].get<double>(),
                    1e3 * (c * point.pitch.x() - s * point.pitch.y()), 1e-3);
        EXPECT_NEAR(roller->at("points")[2 * i + 1].get<double>(),
                    1e3 * (s * point.pitch.x() + c * point.pitch.y()), 1e-3);
        const double dx =
            roller->at("points")[2 * i].get<double>() - drawing.at("contact")[2 * i].get<double>();
        const double dy =
            roller->at("points")[2 * i + 1].get<double>() - drawing.at("contact")[2 * i + 1].get<double>();
        EXPECT_NEAR(std::hypot(dx, dy), 10.0, 1e-3);
    }
}

TEST(PageData, UnloadedCamHasNoForceCharts) {
    Solution solution = test::cam_solution();
    const auto charts = [&] {
        const json data = data_of(solution);
        int count = 0;
        for (const json& one : data.at("curves")) count += one.at("group") == "forces" ? 1 : 0;
        return count;
    };
    const auto has_file = [&] {
        return std::ranges::any_of(cam_file_list(solution),
                                   [](const CamFile& file) { return file.name == "forces.svg"; });
    };
    EXPECT_GT(charts(), 1);
    EXPECT_TRUE(has_file());
    ForceSummary& forces = *solution.cam->summary.forces;
    forces.largest_force.value = forces.least_force.value = 0.0;
    EXPECT_EQ(charts(), 0);
    EXPECT_FALSE(has_file());
}

}  // namespace page_data_test
}  // namespace camopt
