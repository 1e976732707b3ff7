// SPDX-License-Identifier: MIT
// Solves through the C face: the numbers of the C++ face, bit for bit, and every error.
#include "core/units.hpp"
#include "report/cam/cam_files.hpp"
#include "report/csv/motion_csv.hpp"
#include "report/json/certificate_json.hpp"
#include "shop/dxf/cam_dxf.hpp"
#include "studies/delivered/delivered.hpp"
#include "tests/bindings/c/c_face.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace camopt {
namespace c_solve_test {

using namespace testing_support;

/// Also NaN is NaN.
void expect_same(double c, double cpp) {
    if (std::isnan(cpp))
        EXPECT_TRUE(std::isnan(c)) << c;
    else
        EXPECT_EQ(c, cpp);
}

void expect_same_summary(const camopt_summary& c, const Solution& cpp) {
    EXPECT_STREQ(camopt_verdict_name(c.verdict), name_of(cpp.certificate.verdict));
    EXPECT_STREQ(c.reason, name_of(cpp.certificate.reason));
    EXPECT_EQ(c.has_motion, cpp.motion ? 1 : 0);
    EXPECT_EQ(c.has_cam, cpp.cam ? 1 : 0);
    EXPECT_EQ(c.interrupted, 0);
    expect_same(c.objective, cpp.motion ? cpp.certificate.objective : std::nan(""));
    expect_same(c.lower_bound, cpp.certificate.lower_bound.value_or(std::nan("")));
    expect_same(c.gap, cpp.certificate.gap.value_or(std::nan("")));
    expect_same(c.any_curve, cpp.any_curve_limit ? cpp.any_curve_limit->objective : std::nan(""));
    EXPECT_EQ(c.iterations, cpp.solver.iterations);
    EXPECT_EQ(c.exchange_rounds, cpp.solver.exchange_rounds);
    EXPECT_GT(c.seconds_total, 0.0);
}

void expect_same_peaks(const camopt_peaks& c, const Peaks& cpp) {
    EXPECT_EQ(c.velocity, cpp.velocity.value);
    EXPECT_EQ(c.velocity_at, cpp.velocity.at);
    EXPECT_EQ(c.acceleration, cpp.acceleration.value);
    EXPECT_EQ(c.acceleration_at, cpp.acceleration.at);
    EXPECT_EQ(c.jerk, cpp.jerk.value);
    EXPECT_EQ(c.jerk_at, cpp.jerk.at);
    EXPECT_EQ(c.torque, cpp.torque.value);
    EXPECT_EQ(c.torque_at, cpp.torque.at);
    EXPECT_EQ(c.rms_velocity, cpp.rms_velocity);
    EXPECT_EQ(c.rms_acceleration, cpp.rms_acceleration);
    EXPECT_EQ(c.rms_jerk, cpp.rms_jerk);
}

void expect_same_motion(const CSolution& c, const Solution& cpp) {
    camopt_peaks peaks{};
    peaks.size = sizeof peaks;
    EXPECT_OK(camopt_solution_peaks(c.get(), &peaks));
    expect_same_peaks(peaks, cpp.peaks);
    EXPECT_OK(camopt_solution_motion_peaks(c.get(), &peaks));
    expect_same_peaks(peaks, cpp.motion_peaks);
    constexpr std::size_t count = 37;
    std::array<double, count> x{}, y{}, dy{}, d2y{}, d3y{}, again{};
    EXPECT_OK(camopt_motion_samples(c.get(), count, x.data(), y.data(), dy.data(), d2y.data(), d3y.data()));
    EXPECT_EQ(x.front(), cpp.motion->begin());
    EXPECT_EQ(x.back(), cpp.motion->end());
    for (std::size_t i = 0; i < count; ++i) {
        const MotionPoint point = cpp.motion->at(x[i], i + 1 == count ? Side::left : Side::right);
        EXPECT_EQ((std::array{y[i], dy[i], d2y[i], d3y[i]}), point.derivative);
        std::array<double, 4> alone{};
        EXPECT_OK(camopt_motion_at(c.get(), x[i], alone.data()));
        EXPECT_EQ(alone, point.derivative);
    }
    EXPECT_OK(camopt_motion_at_all(c.get(), x.data(), count, nullptr, nullptr, again.data(), nullptr));
    EXPECT_EQ(again, d2y);
}

using ListFunction = camopt_error (*)(const camopt_solution*, std::size_t, double*, std::size_t,
                                      std::size_t*);

std::vector<double> list_of(const CSolution& c, std::size_t index, ListFunction list) {
    std::size_t count = 0;
    EXPECT_OK(list(c.get(), index, nullptr, 0, &count));
    std::vector<double> numbers(count);
    EXPECT_OK(list(c.get(), index, numbers.data(), count, &count));
    EXPECT_EQ(list(c.get(), index, numbers.data(), count - 1, &count), CAMOPT_ERROR_CAPACITY);
    EXPECT_EQ(count, numbers.size());
    EXPECT_EQ(list(c.get(), index, nullptr, 1, &count), CAMOPT_ERROR_NULL);
    return numbers;
}

void expect_same_spline(const CSolution& c, std::size_t index, const SplineCurve& cpp) {
    camopt_spline spline{};
    spline.size = sizeof spline;
    EXPECT_OK(camopt_spline_at(c.get(), index, &spline));
    EXPECT_EQ(spline.degree, cpp.degree());
    EXPECT_EQ(spline.continuity, cpp.continuity());
    EXPECT_EQ(spline.begin, cpp.begin());
    EXPECT_EQ(spline.end, cpp.end());
    EXPECT_EQ(list_of(c, index, camopt_spline_breakpoints), cpp.breakpoints());
    EXPECT_EQ(list_of(c, index, camopt_spline_knots), cpp.knots());
    const Eigen::VectorXd coefficients = cpp.coefficients();
    EXPECT_EQ(list_of(c, index, camopt_spline_coefficients),
              std::vector<double>(coefficients.begin(), coefficients.end()));
    EXPECT_EQ(spline.breakpoint_count, cpp.breakpoints().size());
    EXPECT_EQ(spline.knot_count, cpp.knots().size());
    EXPECT_EQ(spline.coefficient_count, static_cast<std::size_t>(coefficients.size()));
    EXPECT_EQ(spline.knot_count, spline.coefficient_count + static_cast<std::size_t>(spline.degree) + 1);
}

void expect_same_splines(const CSolution& c, const Solution& cpp) {
    std::vector<const SplineCurve*> curves;
    if (cpp.curve) curves.push_back(&*cpp.curve);
    for (const SegmentReport& segment : cpp.segments)
        if (segment.curve) curves.push_back(&*segment.curve);
    std::size_t count = 0;
    EXPECT_OK(camopt_spline_count(c.get(), &count));
    ASSERT_EQ(count, curves.size());
    for (std::size_t i = 0; i < count; ++i) expect_same_spline(c, i, *curves[i]);
    camopt_spline spline{};
    spline.size = sizeof spline;
    EXPECT_EQ(camopt_spline_at(c.get(), count, &spline), CAMOPT_ERROR_ARGUMENT);
}

void expect_same_constraints(const CSolution& c, const Solution& cpp) {
    std::size_t count = 0;
    EXPECT_OK(camopt_constraint_count(c.get(), &count));
    ASSERT_EQ(count, cpp.constraints.size());
    for (std::size_t i = 0; i < count; ++i) {
        const ConstraintReport& report = cpp.constraints[i];
        camopt_constraint constraint{};
        constraint.size = sizeof constraint;
        EXPECT_OK(camopt_constraint_at(c.get(), i, &constraint));
        EXPECT_EQ(constraint.name, report.name);
        EXPECT_EQ(constraint.key, report.key);
        EXPECT_EQ(constraint.unit, report.unit);
        EXPECT_EQ(constraint.limit, report.limit);
        expect_same(constraint.worst, report.worst);
        EXPECT_EQ(constraint.at, report.at);
        EXPECT_EQ(constraint.active, report.active ? 1 : 0);
        EXPECT_EQ(constraint.no_contact, report.no_contact ? 1 : 0);
    }
}

void expect_same_documents(const CSolution& c, const Solution& cpp) {
    EXPECT_EQ(text_of(c, CAMOPT_CERTIFICATE_JSON), certificate_json(cpp.certificate));
    EXPECT_EQ(text_of(c, CAMOPT_MOTION_CSV), motion_csv(cpp));
    EXPECT_NE(text_of(c, CAMOPT_MOTION_SVG).find("</svg>"), std::string::npos);
    EXPECT_NE(text_of(c, CAMOPT_REPORT_MARKDOWN).find("\n"), std::string::npos);
    const std::string verdict = std::string("\"verdict\": \"") + name_of(cpp.certificate.verdict);
    EXPECT_NE(text_of(c, CAMOPT_RESULT_JSON).find(verdict), std::string::npos);
    EXPECT_NE(text_of(c, CAMOPT_SUMMARY_TEXT).find("objective"), std::string::npos);
}

class CSolveOfScene : public ::testing::TestWithParam<const char*> {};

TEST_P(CSolveOfScene, EqualsCppExactly) {
    const CSolution c = c_solved_file(GetParam());
    const Solution cpp = cpp_solved_file(GetParam());
    ASSERT_TRUE(cpp.motion);
    expect_same_summary(summary_of(c), cpp);
    expect_same_motion(c, cpp);
    expect_same_splines(c, cpp);
    expect_same_constraints(c, cpp);
    expect_same_documents(c, cpp);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CSolveOfScene,
                         ::testing::Values("drd_cubic_12", "cam_tolerances", "drd_quintic_end_jerk",
                                           "rr_unequal_return", "drd_physical_limits", "swing_limits",
                                           "cam_roller", "cam_laws_and_splines", "cam_forces", "given_wedge",
                                           "given_drum"));

std::vector<camopt_profile_point> profile_of(const CSolution& c, std::size_t points,
                                             std::size_t station = 0) {
    std::size_t count = 0;
    EXPECT_OK(camopt_profile(c.get(), points, station, nullptr, 0, &count));
    std::vector<camopt_profile_point> profile(count);
    EXPECT_OK(camopt_profile(c.get(), points, station, profile.data(), count, &count));
    EXPECT_EQ(camopt_profile(c.get(), points, station, profile.data(), count - 1, &count),
              CAMOPT_ERROR_CAPACITY);
    EXPECT_EQ(count, profile.size());
    return profile;
}

TEST(CSolve, MakesTheCamOfCpp) {
    const CSolution c = c_solved_file("cam_roller");
    const Solution cpp = cpp_solved_file("cam_roller");
    ASSERT_TRUE(cpp.cam);
    const MotionChain motion = cam_motion(cpp);
    const auto points = sampled_profile(cpp.cam->cam, motion, motion_scale(cpp.scene), {.count = 90});
    const auto shown = profile_of(c, 90);
    ASSERT_EQ(shown.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(shown[i].theta_deg, points[i].theta / units::degree);
        for (int k = 0; k < 2; ++k) {
            EXPECT_EQ(shown[i].pitch_mm[k], points[i].pitch[k] / units::millimetre);
            EXPECT_EQ(shown[i].cam_mm[k], points[i].contact[k] / units::millimetre);
            EXPECT_EQ(shown[i].normal[k], points[i].normal[k]);
        }
        EXPECT_EQ(shown[i].cam_mm[2], 0.0);
        EXPECT_EQ(shown[i].pressure_angle_deg, points[i].pressure_angle / units::degree);
        EXPECT_EQ(shown[i].cam_radius_mm, points[i].cam_radius / units::millimetre);
        EXPECT_EQ(shown[i].regularity, points[i].regularity);
        EXPECT_NEAR(std::abs(shown[i].pitch_radius_mm * points[i].pitch_curvature), 1e3, 1e-9);
    }
    EXPECT_GT(profile_of(c, 0).size(), 200U);  // within 1 µm
    EXPECT_EQ(text_of(c, CAMOPT_PROFILE_CSV), cam_view(cpp, CamView::table));
    EXPECT_EQ(text_of(c, CAMOPT_PROFILE_DXF), cam_dxf(cpp).text);
    EXPECT_EQ(text_of(c, CAMOPT_PROFILE_SVG), cam_view(cpp, CamView::picture));
}

TEST(CSolve, NamesTheNumbersOfTheCam) {
    const CScene scene = c_scene_of_file("cam_roller");
    EXPECT_OK(camopt_set_toml(scene.get(), "cam.base_radius_mm", "{ min = 14, max = 40 }"));
    EXPECT_OK(camopt_set_number(scene.get(), "objective.base_radius", 0.2));
    const CSolution c = c_solved(scene);
    std::size_t count = 0;
    EXPECT_OK(camopt_parameter_count(c.get(), &count));
    ASSERT_EQ(count, 3U);
    const char* const names[] = {"base_radius", "roller_radius", "offset"};
    for (std::size_t i = 0; i < count; ++i) {
        camopt_parameter parameter{};
        parameter.size = sizeof parameter;
        EXPECT_OK(camopt_parameter_at(c.get(), i, &parameter));
        EXPECT_STREQ(parameter.name, names[i]);
        EXPECT_STREQ(parameter.unit, "mm");
        EXPECT_EQ(parameter.is_variable, i == 0 ? 1 : 0);
        if (i == 0) {
            EXPECT_GE(parameter.value, 14.0);
            EXPECT_LE(parameter.value, 40.0);
        } else {
            EXPECT_NEAR(parameter.value, i == 1 ? 8.0 : 5.0, 1e-12);
        }
    }
    camopt_parameter parameter{};
    parameter.size = sizeof parameter;
    EXPECT_EQ(camopt_parameter_at(c.get(), 3, &parameter), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(std::string_view(camopt_error_text()), "index: found 3; allowed: 0 to 2");
}

/// The cam goes further by what the return spring of the train bends.
TEST(CSolve, GivesOutputAndCam) {
    std::array<double, 4> cam{}, output{};
    const CSolution prescribed = c_solved(c_scene_of_file("splinedyne_slide"));
    EXPECT_OK(camopt_motion_at(prescribed.get(), 1.0, cam.data()));
    EXPECT_OK(camopt_output_at(prescribed.get(), 1.0, output.data()));
    EXPECT_NEAR(output[0], 1.0, 1e-9);
    EXPECT_GT(cam[0], 1.01);
    const CSolution plain = c_solved(c_scene_of_file("cam_roller"));
    EXPECT_OK(camopt_motion_at(plain.get(), 0.3, cam.data()));
    EXPECT_OK(camopt_output_at(plain.get(), 0.3, output.data()));
    EXPECT_EQ(cam, output);
    EXPECT_EQ(camopt_output_at(plain.get(), -0.1, output.data()), CAMOPT_ERROR_ARGUMENT);
}

TEST(CSolve, NamesTheSpringThatWasChosen) {
    const CScene scene = c_scene_of_file("cam_forces");
    EXPECT_OK(camopt_set_toml(scene.get(), "forces.preload_n", "{ min = 20, max = 400 }"));
    EXPECT_OK(camopt_set_number(scene.get(), "solver.starts", 1));
    const CSolution c = c_solved(scene);
    std::size_t count = 0;
    EXPECT_OK(camopt_parameter_count(c.get(), &count));
    ASSERT_EQ(count, 4U);
    camopt_parameter parameter{};
    parameter.size = sizeof parameter;
    EXPECT_OK(camopt_parameter_at(c.get(), 3, &parameter));
    EXPECT_STREQ(parameter.name, "preload");
    EXPECT_STREQ(parameter.unit, "N");
    EXPECT_EQ(parameter.is_variable, 1);
    EXPECT_GE(parameter.value, 20.0);
    EXPECT_LE(parameter.value, 400.0);
}

TEST(CSolve, MakesCamsOfOtherKinds) {
    const CScene scene = c_scene_of_file("tappet_75");
    EXPECT_OK(camopt_set_number(scene.get(), "spline.segments", 8));
    EXPECT_OK(camopt_unset(scene.get(), "limits.pressure_angle_deg"));
    const CSolution tappet = c_solved(scene);
    const Solution cpp = cpp_solved(toml_of(scene));
    ASSERT_TRUE(cpp.cam);
    const auto shown = profile_of(tappet, 180);
    const MechanismProfile profile =
        mechanism_profile(cpp.cam->cam, cam_motion(cpp), motion_scale(cpp.scene), 180);
    ASSERT_EQ(shown.size(), profile.points.size());
    for (std::size_t i = 0; i < shown.size(); ++i)
        EXPECT_EQ(shown[i].cam_mm[0], profile.points[i].contact.x() / units::millimetre);
    EXPECT_EQ(text_of(tappet, CAMOPT_PROFILE_DXF), cam_dxf(cpp).text);
    EXPECT_NE(text_of(tappet, CAMOPT_PROFILE_CSV).find("theta_deg,s_mm"), std::string::npos);
    EXPECT_NE(text_of(tappet, CAMOPT_PROFILE_SVG).find("</svg>"), std::string::npos);
    std::size_t count = 0;
    EXPECT_OK(camopt_parameter_count(tappet.get(), &count));
    std::size_t written = 0;
    for (const CamDimension& dimension : cpp.scene.cam->dimensions)
        written += dimension.value.key.empty() ? 0 : 1;
    ASSERT_EQ(count, written);
    camopt_parameter parameter{};
    parameter.size = sizeof parameter;
    EXPECT_OK(camopt_parameter_at(tappet.get(), 0, &parameter));
    EXPECT_STREQ(parameter.name, "roller_radius");
    EXPECT_NEAR(parameter.value, 30.0, 1e-12);
}

TEST(CSolve, ReportsProfileOfEachSpatialStation) {
    const CSolution barrel = c_solved_file("barrel_paper_cup");
    std::size_t stations = 0;
    EXPECT_OK(camopt_station_count(barrel.get(), &stations));
    ASSERT_GE(stations, 4U);
    const char* name = nullptr;
    EXPECT_OK(camopt_station_name(barrel.get(), 1, &name));
    EXPECT_STREQ(name, "0 % of the roller, flank -");
    EXPECT_EQ(camopt_station_name(barrel.get(), stations, &name), CAMOPT_ERROR_ARGUMENT);
    EXPECT_NE(profile_of(barrel, 90, 0)[5].cam_mm[2], profile_of(barrel, 90, stations - 1)[5].cam_mm[2]);
    std::size_t count = 0;
    EXPECT_EQ(camopt_profile(barrel.get(), 90, stations, nullptr, 0, &count), CAMOPT_ERROR_ARGUMENT);
    camopt_text text{};
    EXPECT_EQ(camopt_solution_text(barrel.get(), CAMOPT_PROFILE_DXF, &text), CAMOPT_ERROR_ABSENT);
    EXPECT_EQ(text.data, nullptr);
}

TEST(CSolve, RunsForwardCheckOnRequest) {
    camopt_solve_options options{};
    options.size = sizeof options;
    options.forward_check = 1;
    const CScene scene = c_scene_of_file("cam_roller");
    const std::string with = text_of(c_solved(scene, &options), CAMOPT_RESULT_JSON);
    const std::string without = text_of(c_solved(scene), CAMOPT_RESULT_JSON);
    EXPECT_NE(with.find("\"deviation_mm\""), std::string::npos);
    EXPECT_EQ(without.find("\"deviation_mm\""), std::string::npos);
}

TEST(CSolve, SuggestsChangesForInfeasibleScene) {
    const CSolution c = c_solved_file("infeasible_velocity_cap");
    const Solution cpp = cpp_solved_file("infeasible_velocity_cap");
    const camopt_summary summary = summary_of(c);
    EXPECT_EQ(summary.verdict, CAMOPT_INFEASIBLE);
    EXPECT_EQ(summary.has_motion, 0);
    EXPECT_TRUE(std::isnan(summary.objective));
    std::size_t count = 0;
    EXPECT_OK(camopt_relaxation_count(c.get(), &count));
    ASSERT_EQ(count, cpp.relaxation.size());
    ASSERT_GE(count, 1U);
    camopt_relaxation relaxation{};
    relaxation.size = sizeof relaxation;
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_OK(camopt_relaxation_at(c.get(), i, &relaxation));
        EXPECT_EQ(relaxation.key, cpp.relaxation[i].key);
        EXPECT_EQ(relaxation.given, cpp.relaxation[i].given);
        expect_same(relaxation.needed, cpp.relaxation[i].needed.value_or(std::nan("")));
        expect_same(relaxation.solved, cpp.relaxation[i].solved.value_or(std::nan("")));
        EXPECT_EQ(relaxation.ruled_out, cpp.relaxation[i].ruled_out ? 1 : 0);
        EXPECT_EQ(relaxation.also, cpp.relaxation[i].also.size());
    }
    EXPECT_EQ(camopt_relaxation_at(c.get(), count, &relaxation), CAMOPT_ERROR_ARGUMENT);
}

TEST(CSolve, ReportsMissingPartsOfSolution) {
    const CSolution none = c_solved_file("infeasible_velocity_cap");
    camopt_peaks peaks{};
    peaks.size = sizeof peaks;
    std::array<double, 4> y{};
    std::size_t count = 7;
    camopt_text text{};
    const char* name = nullptr;
    const camopt_error absent[] = {
        camopt_solution_peaks(none.get(), &peaks),
        camopt_solution_motion_peaks(none.get(), &peaks),
        camopt_motion_at(none.get(), 0.5, y.data()),
        camopt_motion_at_all(none.get(), y.data(), 1, y.data(), nullptr, nullptr, nullptr),
        camopt_motion_samples(none.get(), 4, y.data(), nullptr, nullptr, nullptr, nullptr),
        camopt_station_count(none.get(), &count),
        camopt_station_name(none.get(), 0, &name),
        camopt_profile(none.get(), 10, 0, nullptr, 0, &count),
        camopt_solution_text(none.get(), CAMOPT_MOTION_CSV, &text),
        camopt_solution_text(none.get(), CAMOPT_MOTION_SVG, &text),
        camopt_solution_text(none.get(), CAMOPT_PROFILE_CSV, &text),
        camopt_solution_text(none.get(), CAMOPT_PROFILE_DXF, &text),
        camopt_solution_text(none.get(), CAMOPT_PROFILE_SVG, &text)};
    for (std::size_t i = 0; i < std::size(absent); ++i) EXPECT_EQ(absent[i], CAMOPT_ERROR_ABSENT) << i;
    EXPECT_EQ(count, 7U);
    EXPECT_EQ(text.data, nullptr);
    EXPECT_OK(camopt_spline_count(none.get(), &count));
    EXPECT_EQ(count, 0U);
    EXPECT_OK(camopt_parameter_count(none.get(), &count));
    EXPECT_EQ(count, 0U);
    EXPECT_FALSE(text_of(none, CAMOPT_REPORT_MARKDOWN).empty());
}

TEST(CSolve, RefusesArgumentsOutOfRange) {
    const CSolution c = c_solved(c_scene(paper_toml));
    std::array<double, 4> y{1, 2, 3, 4};
    const double outside[] = {0.5, 1.5};
    camopt_text text{};
    camopt_summary summary{};
    EXPECT_EQ(camopt_motion_at(c.get(), -0.01, y.data()), CAMOPT_ERROR_ARGUMENT);
    EXPECT_STREQ(camopt_error_text(), "x: found -0.01; allowed: 0 to 1");
    EXPECT_EQ(camopt_motion_at(c.get(), std::nan(""), y.data()), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_motion_at_all(c.get(), outside, 2, y.data(), nullptr, nullptr, nullptr),
              CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_motion_samples(c.get(), 1, y.data(), nullptr, nullptr, nullptr, nullptr),
              CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_solution_text(c.get(), static_cast<camopt_document>(9), &text), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_solution_summary(c.get(), &summary), CAMOPT_ERROR_ARGUMENT);  // size is 0
    EXPECT_EQ(y, (std::array<double, 4>{1, 2, 3, 4}));
    camopt_solve_options options{};
    options.size = 3;
    camopt_solution* solution = nullptr;
    EXPECT_EQ(camopt_solve(c_scene(paper_toml).get(), &options, &solution), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(solution, nullptr);
    const CSolution cam = c_solved_file("cam_roller");
    std::size_t count = 0;
    EXPECT_EQ(camopt_profile(cam.get(), 1, 0, nullptr, 0, &count), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_profile(cam.get(), 100, 1, nullptr, 0, &count), CAMOPT_ERROR_ARGUMENT);
    EXPECT_EQ(camopt_profile(cam.get(), 100'000'000, 0, nullptr, 0, &count), CAMOPT_ERROR_ARGUMENT);
}

TEST(CSolve, FillsStructsOfLaterHeaders) {
    struct Later {
        camopt_summary known;
        double unknown;
    } later{};
    later.known.size = sizeof later;
    later.unknown = 42.0;
    EXPECT_OK(camopt_solution_summary(c_solved(c_scene(paper_toml)).get(), &later.known));
    EXPECT_EQ(later.known.size, sizeof(camopt_summary));
    EXPECT_EQ(later.unknown, 42.0);
}

TEST(CSolve, RefusesNulls) {
    const CScene scene = c_scene(paper_toml);
    const CSolution c = c_solved(scene);
    const camopt_solution* const s = c.get();
    camopt_solution* made = nullptr;
    std::size_t n = 0;
    double y = 0.0;
    camopt_text text{};
    camopt_summary summary{};
    camopt_peaks peaks{};
    camopt_parameter parameter{};
    camopt_constraint constraint{};
    camopt_relaxation relaxation{};
    camopt_spline spline{};
    const char* name = nullptr;
    const camopt_error codes[] = {camopt_solve(nullptr, nullptr, &made),
                                  camopt_solve(scene.get(), nullptr, nullptr),
                                  camopt_solution_summary(nullptr, &summary),
                                  camopt_solution_summary(s, nullptr),
                                  camopt_solution_peaks(nullptr, &peaks),
                                  camopt_solution_peaks(s, nullptr),
                                  camopt_solution_motion_peaks(nullptr, &peaks),
                                  camopt_solution_motion_peaks(s, nullptr),
                                  camopt_parameter_count(nullptr, &n),
                                  camopt_parameter_count(s, nullptr),
                                  camopt_parameter_at(nullptr, 0, &parameter),
                                  camopt_parameter_at(s, 0, nullptr),
                                  camopt_constraint_count(nullptr, &n),
                                  camopt_constraint_count(s, nullptr),
                                  camopt_constraint_at(nullptr, 0, &constraint),
                                  camopt_constraint_at(s, 0, nullptr),
                                  camopt_relaxation_count(nullptr, &n),
                                  camopt_relaxation_count(s, nullptr),
                                  camopt_relaxation_at(nullptr, 0, &relaxation),
                                  camopt_relaxation_at(s, 0, nullptr),
                                  camopt_relaxation_also(s, 0, 0, nullptr),
                                  camopt_motion_at(nullptr, 0.5, &y),
                                  camopt_motion_at(s, 0.5, nullptr),
                                  camopt_output_at(nullptr, 0.5, &y),
                                  camopt_output_at(s, 0.5, nullptr),
                                  camopt_motion_at_all(nullptr, &y, 1, &y, nullptr, nullptr, nullptr),
                                  camopt_motion_at_all(s, nullptr, 1, &y, nullptr, nullptr, nullptr),
                                  camopt_motion_samples(nullptr, 2, &y, nullptr, nullptr, nullptr, nullptr),
                                  camopt_spline_count(nullptr, &n),
                                  camopt_spline_count(s, nullptr),
                                  camopt_spline_at(nullptr, 0, &spline),
                                  camopt_spline_at(s, 0, nullptr),
                                  camopt_spline_breakpoints(nullptr, 0, &y, 1, &n),
                                  camopt_spline_breakpoints(s, 0, &y, 1, nullptr),
                                  camopt_spline_knots(nullptr, 0, &y, 1, &n),
                                  camopt_spline_knots(s, 0, &y, 1, nullptr),
                                  camopt_spline_coefficients(nullptr, 0, &y, 1, &n),
                                  camopt_spline_coefficients(s, 0, &y, 1, nullptr),
                                  camopt_station_count(nullptr, &n),
                                  camopt_station_name(nullptr, 0, &name),
                                  camopt_profile(nullptr, 10, 0, nullptr, 0, &n),
                                  camopt_solution_text(nullptr, CAMOPT_RESULT_JSON, &text),
                                  camopt_solution_text(s, CAMOPT_RESULT_JSON, nullptr)};
    for (std::size_t i = 0; i < std::size(codes); ++i) EXPECT_EQ(codes[i], CAMOPT_ERROR_NULL) << i;
    EXPECT_EQ(made, nullptr);
    const CSolution cam = c_solved_file("cam_roller");
    EXPECT_EQ(camopt_station_count(cam.get(), nullptr), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_station_name(cam.get(), 0, nullptr), CAMOPT_ERROR_NULL);
    EXPECT_EQ(camopt_profile(cam.get(), 10, 0, nullptr, 0, nullptr), CAMOPT_ERROR_NULL);
    EXPECT_OK(camopt_motion_at_all(s, nullptr, 0, nullptr, nullptr, nullptr, nullptr));
    EXPECT_OK(camopt_motion_samples(s, 2, nullptr, nullptr, nullptr, nullptr, nullptr));
}

TEST(CSolve, ReportsInvalidScenesAndMissingSolvers) {
    const CScene incomplete = c_scene(paper_toml);
    EXPECT_OK(camopt_unset(incomplete.get(), "motion.type"));
    camopt_solution* solution = nullptr;
    EXPECT_EQ(camopt_solve(incomplete.get(), nullptr, &solution), CAMOPT_ERROR_INPUT);
    EXPECT_NE(std::string_view(camopt_error_text()).find("motion.type: missing"), std::string_view::npos);
    EXPECT_EQ(solution, nullptr);
}

}  // namespace c_solve_test
}  // namespace camopt
