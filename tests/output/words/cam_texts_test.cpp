// SPDX-License-Identifier: MIT
// What terminal summary and report say about cams, programs and scenes that have no motion.
#include "input/loading/load_scene.hpp"
#include "input/scene_reader.hpp"
#include "output/report/result_folder.hpp"
#include "output/view/cam_words.hpp"
#include "output/view/key_words.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/view/tables.hpp"
#include "output/view/view.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"
#include "studies/check/check_cam.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/search/plan.hpp"
#include "studies/solve/solve.hpp"
#include "tests/output/sample_solution.hpp"
#include "tests/support/source_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace camopt {
namespace cam_texts_test {

bool says(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

std::string remarks_of(const Solution& solution) {
    std::string text;
    for (const std::string& remark : cam_remarks(solution)) text += remark + "\n";
    return text;
}

TEST(KeyWords, NamesAndUnitsOfKeys) {
    const KeyWords angle = key_words("limits.pressure_angle_deg");
    EXPECT_EQ(angle.words, "pressure angle");
    EXPECT_EQ(angle.unit, "deg");
    EXPECT_TRUE(angle.limit);
    EXPECT_EQ(key_words("limits.cam_radius_min_mm", "face turns back").words, "cam radius (face turns back)");
    EXPECT_EQ(key_words("limits.acceleration_mm_s2").unit, "mm/s²");
    EXPECT_EQ(key_words("limits.contact_moment_min_nm").unit, "N m");
    EXPECT_EQ(key_words("limits.velocity").unit, "");
    EXPECT_FALSE(key_words("cam.base_radius_mm").limit);
    EXPECT_EQ(key_words("cam.base_radius_mm.max").words, "largest base radius");
    EXPECT_EQ(key_words("cam.base_radius_mm.max").unit, "mm");
}

TEST(KeyWords, ListNumbersCountFromOne) {
    EXPECT_EQ(key_words("motion.via[0].velocity_mm_deg").words, "velocity of set point 1");
    EXPECT_EQ(key_words("motion.via[0].velocity_mm_deg").unit, "mm/deg");
    EXPECT_EQ(key_words("motion.segments[2].via[1].acceleration_m_s2").unit, "m/s²");
    EXPECT_EQ(key_words("motion.segments[2].angle_deg").words, "angle of segment 3");
    EXPECT_EQ(key_words("motion.segments[2].end.velocity").words, "velocity at the end of segment 3");
    EXPECT_EQ(key_words("motion.via[1].to_deg").words, "last angle of set point 2");
    EXPECT_EQ(key_words("motion.segments[2].via[0]").words, "set point 1 of segment 3");
    EXPECT_EQ(key_words("motion.segments[2].via[1].acceleration_m_s2").words,
              "acceleration of set point 2 of segment 3");
    EXPECT_EQ(key_words("motion.segments[2].to").unit, "");
    EXPECT_EQ(key_words("motion.segments[2].to").words, "last displacement of segment 3");
}

TEST(KeyWords, ChangeIsRoundedToFeasibleSide) {
    EXPECT_EQ(change_words({"cam.base_radius_mm", 30.0, 31.41231}), "increase the base radius to 31.413 mm");
    EXPECT_EQ(change_words({"motion.start.velocity_mm_s", 1200.0, 799.99}),
              "reduce the velocity at the start to 799.99 mm/s");
    EXPECT_EQ(change_words({"spline.segments", 7.0, 14.0}), "use 14 segments");
    EXPECT_EQ(change_words({"spline.breakpoints", 7.0, 14.0}), "use 14 segments (every interval cut in two)");
    EXPECT_EQ(change_words({"spline.breakpoints", 7.0, 28.0}), "use 28 segments (every interval cut in 4)");
    EXPECT_EQ(change_words({"cam.offset_mm", 0.0, -1.25}), "reduce the offset to −1.25 mm");
    EXPECT_EQ(change_words({"limits.pressure_angle_deg", 30.0, 33.1}),
              "raise the pressure angle limit to 33.1 deg");
    EXPECT_EQ(change_words({"limits.acceleration_rad_s2", 300.0, 323.3}),
              "raise the acceleration limit to 323.3 rad/s²");
    EXPECT_EQ(change_words({"limits.cam_radius_min_mm", 4.0, 2.50009}),
              "lower the cam radius limit to 2.5 mm");
    EXPECT_EQ(change_words({"cam.base_radius_mm", 30.0, std::nullopt}), "");
    EXPECT_EQ(change_words({"motion.via[1].displacement_mm", 0.35, 0.18}),
              "change the displacement of set point 2 (motion.via[1].displacement_mm) from 0.35 to 0.18 mm");
    EXPECT_EQ(change_words({"motion.speed_rpm", 300.0, 280.0}), "reduce the speed to 280 rpm");
}

TEST(KeyWords, ChangeNamesTheReducedSide) {
    EXPECT_EQ(change_words({"motion.segments[2].angle_deg",
                            50.0,
                            54.0,
                            54.0,
                            false,
                            {{"motion.segments[3].angle_deg", 40.0, 36.0}}}),
              "lengthen the angle of segment 3 (motion.segments[2].angle_deg) from 50 to 54 deg, taken from "
              "the angle "
              "of segment 4 (motion.segments[3].angle_deg), which becomes 36 deg");
    EXPECT_EQ(change_words({"motion.rise_deg", 75.0, 95.0, 95.0, false, {{"motion.return_deg", 75.0, 95.0}}}),
              "lengthen the rise to 95 deg, with the return at 95 deg");
}

TEST(CamWords, ListFollowerDimensionsAndPrimeRadius) {
    EXPECT_EQ(dimensions_text(test::cam_solution()),
              "base radius 30 mm, roller radius 10 mm, offset 0 mm, prime radius 40 mm");
    Solution free = test::infeasible_cam_solution();
    free.scene.cam->set(DimensionIndex::base_radius, Dimension(0.02, 0.06));
    EXPECT_EQ(dimensions_text(free), "base radius free, roller radius 10 mm, offset 0 mm, prime radius free");
}

TEST(CamRemarks, SayWhetherTheCamIsUndercut) {
    EXPECT_TRUE(says(remarks_of(test::cam_solution()), "No undercut: "));
    const std::string undercut = remarks_of(test::undercut_solution());
    EXPECT_TRUE(says(undercut, "UNDERCUT at "));
    EXPECT_TRUE(says(undercut, "or a smaller roller helps"));
}

TEST(CamRemarks, NameActiveLimitAndSmallestSize) {
    Solution solution = test::cam_solution();
    EXPECT_TRUE(says(remarks_of(solution), "No limit is active"));
    EXPECT_TRUE(says(remarks_of(solution), "every motion needs a prime radius of at least "));
    EXPECT_TRUE(says(remarks_of(solution), "this cam has 40 mm"));
    EXPECT_TRUE(says(remarks_of(solution), "the sector of the motion, 90 deg"));
    solution.constraints.back().active = true;
    EXPECT_TRUE(says(remarks_of(solution), "Active limits: the pressure angle at "));
    solution.scene.cam->set(DimensionIndex::base_radius, Dimension(0.03, 0.06));
    EXPECT_TRUE(says(remarks_of(solution), "; the base radius is the least allowed."));
}

Solution eccentric(const std::string& motion) {
    const Scene scene = input::read_scene(
        "[motion]\ntype = \"program\"\nlift_mm = 30\nspeed_rpm = 500\n" + motion +
            "segments = [{ kind = \"law\", law = \"simple_harmonic\", angle_deg = 180, to = 1.0 }, "
            "{ kind = \"law\", law = \"simple_harmonic\", angle_deg = 180, to = 0.0 }]\n"
            "[cam]\ntype = \"disk\"\nfollower = \"translating_flat\"\nbase_radius_mm = 25\n"
            "[forces]\nmass_kg = 0.9\nspring_rate_n_m = 1000\npreload_n = 2.5\n",
        "s.toml", known_names(), {});
    return solve(scene);
}

// F = 0.9 · 15 mm ω² cos θ + 1000 · 15 mm (1 − cos θ) + 2.5.
TEST(CamRemarks, NameWhereTheFollowerLeaves) {
    EXPECT_FALSE(says(remarks_of(test::cam_solution()), "LIFTS OFF"));
    Solution solution = eccentric("");
    EXPECT_TRUE(
        says(remarks_of(solution),
             "LIFTS OFF the cam at 142.661 deg and returns at 217.339 deg: it needs a stiffer spring or"));
    ASSERT_TRUE(solution.cam->summary.forces->lift_off_speed);
    EXPECT_NEAR(solution.cam->summary.forces->lift_off_speed->value, std::sqrt(32.5 / 0.0135), 1e-6);
    EXPECT_NEAR(solution.cam->summary.forces->lift_off_speed->at, 1.0, 1e-4);
    const std::vector<CamFigure> figures = cam_figures(solution);
    const auto speed = std::ranges::find(figures, "the follower lifts off above", &CamFigure::name);
    ASSERT_NE(speed, figures.end());
    EXPECT_EQ(speed->value, "468.539 rpm");
    EXPECT_TRUE(says(remarks_of(eccentric("phase_deg = 30\n")), "at 172.661 deg and returns at 247.339 deg"));
    solution.cam->summary.forces->least_force.at = 0.0;  // a spring has nothing to press with there
    EXPECT_TRUE(says(remarks_of(solution), "217.339 deg: it needs more preload."));
}

TEST(SegmentTable, JerkIsFiniteAcrossSmoothJoint) {
    const Solution solution = eccentric("");
    // y = (1 − cos πx) / 2 by the segment: J = π³ / 2.
    const double jerk = 0.5 * std::pow(std::numbers::pi, 3);
    EXPECT_NEAR(solution.peaks.jerk.value, jerk, 1e-9);
    EXPECT_NEAR(solution.motion_peaks.jerk.value, jerk, 1e-9);
    for (const SegmentReport& segment : solution.segments) {
        EXPECT_EQ(segment.continuity, 3);
        EXPECT_NEAR(segment.peaks->jerk.value, jerk, 1e-9);
    }
}

TEST(CurvatureCurve, HasNoGapsAtItsLimit) {
    const auto solved = [](const std::string& rest) {
        return solve(input::read_scene(
            "[motion]\ntype = \"program\"\nlift_mm = 30\n"
            "segments = [{ kind = \"law\", law = \"cycloidal\", angle_deg = 90, to = 1.0 }, "
            "{ kind = \"law\", law = \"cycloidal\", angle_deg = 90, to = 0.0 }, "
            "{ kind = \"dwell\", angle_deg = 180 }]\n"
            "[cam]\ntype = \"disk\"\nfollower = \"translating_flat\"\nbase_radius_mm = 51\n" +
                rest,
            "s.toml", known_names(), {}));
    };
    const double least = solved("").cam->summary.convex_radius->value;
    ASSERT_GT(least, 0.0);
    ASSERT_LT(least, 51e-3 / 8.0);
    const Solution solution =
        solved(fmt::format("[limits]\ncam_radius_min_mm = {:.9f}\n", 0.999 * least / 1e-3));
    const View view(solution);
    const auto curve = std::ranges::find(view.curves, "curvature", &Curve::key);
    ASSERT_NE(curve, view.curves.end());
    EXPECT_TRUE(std::ranges::all_of(curve->values, [](double value) { return std::isfinite(value); }));
}

TEST(CamRemarks, ZeroForceIsNotLiftOff) {
    Solution solution = test::cam_solution();
    solution.cam->summary.forces->least_force = {-1e-9, 0.75};
    EXPECT_FALSE(says(remarks_of(solution), "LIFTS OFF"));
    EXPECT_TRUE(says(remarks_of(solution), "just reaches 0 at 67.5 deg"));
}

TEST(CamRemarks, ZeroRegularityIsCusp) {
    Solution solution = test::cam_solution();
    solution.cam->summary.regularity = {0.0, 0.5};
    EXPECT_TRUE(says(remarks_of(solution), "A CUSP at 45 deg"));
    EXPECT_FALSE(says(remarks_of(solution), "UNDERCUT"));
    solution.cam->summary.regularity = {-1e-6, 0.5};
    EXPECT_TRUE(says(remarks_of(solution), "UNDERCUT at 45 deg"));
}

TEST(CamRemarks, ReportForwardCheck) {
    Solution solution = test::cam_solution();
    EXPECT_FALSE(says(remarks_of(solution), "Forward check"));
    solution.cam->forward_check = ForwardCheckReport{1.2e-9, 3e-8, 0.5, 2001, 0.1};
    EXPECT_TRUE(says(remarks_of(solution),
                     "over 2001 points of the cam moves as designed within 1.2e-6 mm "
                     "(3e-8 of the prime radius, at 45 deg)"));
    solution.cam->forward_check->relative = 0.02;
    EXPECT_TRUE(says(remarks_of(solution), "DEPARTS from the designed motion by"));
    solution.cam->forward_check->deviation = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(says(remarks_of(solution), "no point was found where the follower touches the cam"));
}

TEST(CheckCam, SampleMovesFollowerAsDesigned) {
    const Solution solution = test::cam_solution();
    const ForwardCheckReport check = check_cam(solution);
    EXPECT_LT(check.deviation, 1e-9);
    EXPECT_GE(check.points, 2000);
    EXPECT_GT(check_cam(test::undercut_solution()).relative, 1e-3);
}

TEST(CheckCam, EarlyReturnIsFollowedByDwell) {
    Solution solution = test::cam_solution();
    EXPECT_EQ(cam_motion(solution).end(), 1.0);
    solution.scene.motion.type = MotionType::rr;
    EXPECT_DOUBLE_EQ(cam_motion(solution).end(), 4.0);
    EXPECT_EQ(cam_motion(solution).at(3.0).derivative[0], 0.0);
}

// The rest of the turn, half before the rise and half after it; open between the far ends, and said why.
TEST(CheckCam, SingleRiseIncludesDwellArcs) {
    Solution solution = test::cam_solution();
    ASSERT_EQ(solution.scene.motion.type, MotionType::drd);
    const MotionChain drawn = drawn_motion(solution);
    EXPECT_DOUBLE_EQ(drawn.begin(), -1.5);
    EXPECT_DOUBLE_EQ(drawn.end(), 2.5);
    for (const double x : {-1.5, -0.1}) EXPECT_EQ(drawn.at(x).derivative[0], 0.0);
    for (const double x : {1.1, 2.5}) EXPECT_EQ(drawn.at(x, Side::left).derivative[0], 1.0);
    EXPECT_EQ(drawn.at(0.3).derivative, solution.motion->at(0.3).derivative);
    EXPECT_NE(open_because(solution).find("no return is given"), std::string::npos);
    solution.scene.motion.type = MotionType::rr;
    EXPECT_EQ(open_because(solution), "");
    EXPECT_DOUBLE_EQ(drawn_motion(solution).end(), 4.0);
}

TEST(SolutionText, CamHasItsOwnSection) {
    const std::string text = summary_text(test::cam_solution(), {});
    for (const char* part :
         {"cam: translating roller, the cam turning counterclockwise", "dimensions: base radius 30 mm",
          "largest pressure angle", "least convex radius of the cam", "least force on the follower",
          "largest Hertz pressure", "No undercut"})
        EXPECT_TRUE(says(text, part)) << part;
}

TEST(SolutionText, SceneWithoutCamIsUnchanged) {
    const std::string text = summary_text(test::sample_solution(), {});
    for (const char* part : {"cam:", "joint", "undercut", "starts"}) EXPECT_FALSE(says(text, part)) << part;
    EXPECT_TRUE(says(summary_text(test::infeasible_solution(), {}),
                     "Any one of these changes suffices: raise the velocity limit to 312.5 mm/s."));
}

TEST(SolutionText, IsHonestAboutALocalOptimum) {
    Solution solution = test::cam_solution();
    solution.solver.convex = false;
    solution.solver.starts = 8;
    solution.certificate.verdict = Verdict::local;
    const std::string text = summary_text(solution, {});
    EXPECT_TRUE(says(text,
                     "Local optimum, the best of 8 starts: no small change improves it, and it is proved to "
                     "be at most 0.00001 % from the optimum."));
    EXPECT_TRUE(says(text, "bound of the convex relaxation 1.1259609"));
    EXPECT_TRUE(says(report_markdown(solution), "(convex relaxation): 1.1259609"));
    solution.certificate.verdict = Verdict::feasible;
    EXPECT_TRUE(says(summary_text(solution, {}), "Feasible, the best of 8 starts"));
    solution.certificate.verdict = Verdict::optimal;  // proved is proved
    EXPECT_TRUE(says(summary_text(solution, {}), "Proved optimal"));
    solution.certificate.verdict = Verdict::failed;
    solution.certificate.reason = Reason::no_feasible_point;
    solution.motion.reset();
    EXPECT_TRUE(says(summary_text(solution, {}), "from 8 starts; infeasibility is not proved"));
}

TEST(SolutionText, SaysTheGapThatIsProved) {
    Certificate certificate;
    EXPECT_EQ(gap_words(certificate), "");
    certificate.objective = 1.0;
    certificate.lower_bound = 1.0 - 1.6e-6;
    certificate.gap = 1.6e-6;
    EXPECT_EQ(gap_words(certificate), "at most 0.0002 % from the optimum");
    certificate.objective = 0.010;  // the gap is relative to 1: the bound says more
    certificate.lower_bound = 0.0096;
    certificate.gap = 4e-4;
    EXPECT_EQ(gap_words(certificate), "at most 5 % from the optimum");
    certificate.lower_bound = 0.001;
    EXPECT_EQ(gap_words(certificate), "");
    for (const Verdict verdict : {Verdict::local, Verdict::feasible}) {
        certificate.verdict = verdict;
        certificate.lower_bound = certificate.objective - 1.6e-8;
        certificate.gap = 1.6e-8;
        EXPECT_TRUE(says(verdict_sentence(certificate), "proved to be at most 0.0002 % from the optimum"));
    }
}

/// The motion of the sample, moved by so many lifts.
Solution moved_by(double lifts) {
    Solution solution = test::cam_solution();
    ChainPart part = solution.motion->parts().front();
    part.y0 += lifts;
    solution.motion = std::make_shared<const MotionChain>(std::vector<ChainPart>{part});
    return solution;
}

TEST(SolutionText, NamesAnExcursionAndItsAngle) {
    EXPECT_TRUE(excursion_sentences(test::cam_solution()).empty());
    EXPECT_EQ(excursion_sentences(moved_by(-0.32)),
              std::vector<std::string>{"The follower goes 3.2 mm below its start at 0 deg."});
    EXPECT_EQ(excursion_sentences(moved_by(0.1)),
              std::vector<std::string>{"The follower goes 1 mm above its top at 90 deg."});
    EXPECT_TRUE(says(summary_text(moved_by(0.1), {}), "1 mm above its top at 90 deg"));
    EXPECT_TRUE(says(report_markdown(moved_by(0.1)), "1 mm above its top at 90 deg"));
}

TEST(SolutionText, NamesTheSegmentOfAnExcursion) {
    Solution solution = test::program_solution();
    EXPECT_TRUE(excursion_sentences(solution).empty());
    solution.segments[1].to = 0.9;  // the spline ends at 1
    EXPECT_EQ(excursion_sentences(solution),
              std::vector<std::string>{
                  "The output goes 1 mm above the stroke of segment 2 (0 to 9 mm) at 150 deg."});
}

TEST(SolutionText, SignedPeaksShowOtherSide) {
    const Solution solution = test::sample_solution();
    const SignedPeaks peaks = signed_peaks(solution, 2);
    EXPECT_DOUBLE_EQ(peaks.largest.value, 8.0);
    ASSERT_TRUE(peaks.opposite);
    EXPECT_NEAR(peaks.opposite->value, -8.0, 1e-12);
    EXPECT_NEAR(peaks.opposite->at, 0.75, 1e-9);
    EXPECT_FALSE(signed_peaks(solution, 1).opposite);
    EXPECT_TRUE(says(report_markdown(solution), "−32 m/s² at 67.5 deg"));
}

TEST(SolutionText, ProgramHasTableOfSegments) {
    const Solution solution = test::program_solution();
    const TextTable table = segment_table(solution);
    ASSERT_EQ(table.rows.size(), 4U);
    EXPECT_EQ(table.rows[1],
              (std::vector<std::string>{"2 spline", "60", "150", "90", "0", "10", "2", "8", "32", "C2"}));
    EXPECT_EQ(table.rows[0][6], "–");
    EXPECT_EQ(table.rows[3][0], "4 modified sine");
    EXPECT_EQ(table.rows[3][6], "1.7596");
    const std::string text = summary_text(solution, {});
    EXPECT_TRUE(says(text, "modified sine"));
    // The normalised peak is the spline's; the physical one the law's: 3.5192 · 10 mm / (π/2 rad).
    EXPECT_TRUE(says(text, "V = 2 "));
    EXPECT_TRUE(says(text, "22.4039 mm/rad"));
}

TEST(InfeasibleWords, NameConflictingLimitsAndLocation) {
    EXPECT_EQ(conflict_sentence(test::infeasible_cam_solution()),
              "The pressure angle limit from 23.4 to 27.9 deg and at 45 deg conflicts with the cam radius "
              "limit at 81 "
              "deg: no spline of 4 cubic segments satisfies all limits.");
    EXPECT_EQ(conflict_sentence(test::cam_solution()), "");
    Solution alone = test::infeasible_cam_solution();
    alone.conflict.resize(1);
    EXPECT_EQ(conflict_sentence(alone),
              "The pressure angle limit at 23.4 deg cannot be satisfied by any spline of 4 cubic segments "
              "that makes the lift in its angle.");
    alone.explanation = Explanation{.together = {},
                                    .any_motion = {"limits.pressure_angle_deg"},
                                    .alone = {},
                                    .set_points = {},
                                    .finest = 0,
                                    .unsettled = {},
                                    .seconds = 0.0,
                                    .allowed = 30.0};
    EXPECT_EQ(
        conflict_sentence(alone),
        "The pressure angle limit at 23.4 deg cannot be satisfied by any motion that makes the lift in its "
        "angle.");
}

TEST(InfeasibleWords, SeparatelyImpossibleLimitsDoNotConflict) {
    Solution solution = test::infeasible_cam_solution();
    solution.explanation.emplace();
    solution.explanation->alone = {"limits.pressure_angle_deg", "limits.cam_radius_min_mm"};
    const std::string text = conflict_sentence(solution);
    EXPECT_FALSE(says(text, "conflicts with")) << text;
    EXPECT_TRUE(says(
        text, "The pressure angle limit from 23.4 to 27.9 deg and at 45 deg cannot be satisfied by any "));
    EXPECT_TRUE(
        says(text, "The cam radius limit at 81 deg cannot be satisfied by any spline of 4 cubic segments"));
}

TEST(InfeasibleWords, ReportWhatTimeLeftUnsettled) {
    Solution solution = test::infeasible_cam_solution();
    solution.explanation.emplace();
    Explanation& explanation = *solution.explanation;
    explanation.seconds = explanation.allowed = 30.0;
    explanation.finest = 32;
    explanation.unsettled = {"cam.offset_mm", "together"};
    explanation.end = ExplanationEnd::time_limit;
    explanation.own_limit = false;
    const auto text = [&] {
        std::string all;
        for (const std::string& remark : infeasible_remarks(solution)) all += remark + "\n";
        return all;
    };
    EXPECT_TRUE(says(text(),
                     "The search for changes ended after 30 s of 30 s (the rest of solver.max_seconds); "
                     "others may suffice. Not decided: offset, all limits together."))
        << text();
    EXPECT_TRUE(says(text(), "More segments were tried without success, up to 32.")) << text();
    explanation.own_limit = true;
    EXPECT_TRUE(says(text(), "of 30 s (solver.explain_seconds)")) << text();
    explanation.end = ExplanationEnd::interrupted;
    EXPECT_TRUE(says(text(), "The search for changes was interrupted after 30 s; others may suffice."))
        << text();
    EXPECT_FALSE(says(text(), "max_seconds")) << text();
    explanation.end = ExplanationEnd::enough;
    EXPECT_TRUE(says(text(), "ended with these (solver.explain_changes)")) << text();
}

TEST(InfeasibleWords, LawViolatingLimitIsBlamed) {
    Solution solution = test::program_solution();
    solution.conflict = {{"limits.velocity_mm_s", 3.75, 1.0}};
    EXPECT_EQ(conflict_sentence(solution),
              "The velocity limit at 338 deg cannot be satisfied: the motion there is the law modified sine, "
              "regardless of the splines.");
    solution.conflict.front().at = 1.0;
    EXPECT_TRUE(
        says(conflict_sentence(solution), "any spline of 4 cubic segments in each of its parts that"));
}

TEST(InfeasibleWords, FreeDisplacementsExonerateTheLaw) {
    Solution solution = test::program_solution();
    solution.conflict = {{"limits.velocity_mm_s", 3.75, 1.0}};
    solution.scene.motion.segments[1].to.reset();  // then the spline decides how far the law moves
    EXPECT_FALSE(says(conflict_sentence(solution), "regardless of the splines"));
}

TEST(InfeasibleWords, NameTheChangesThatWouldDo) {
    const Solution solution = test::infeasible_cam_solution();
    EXPECT_EQ(
        sufficient_changes(solution.relaxation),
        "increase the base radius to 31.413 mm, or lengthen the rise to 68.15 deg, or raise the pressure "
        "angle limit to 33.1 deg, or lower the cam radius limit to 2.5 mm");
    EXPECT_EQ(hopeless_changes(solution.relaxation), "roller radius");
    const std::string report = report_markdown(solution);
    EXPECT_TRUE(says(report, "## Why this spline has no motion, and what would have to change"));
    Solution sure = solution;
    sure.explanation.emplace();
    sure.explanation->any_motion = {"limits.pressure_angle_deg"};
    EXPECT_TRUE(says(report_markdown(sure), "## Why no motion exists, and what would have to change"));
    sure.certificate.verdict = Verdict::failed;
    EXPECT_TRUE(says(report_markdown(sure), "## No motion was found, and what would have to change"));
    EXPECT_TRUE(says(report, "Any one of these changes suffices: increase the base radius to 31.413 mm"));
    EXPECT_TRUE(says(report, "cam.roller_radius_mm | 10 | tried without success"));
    EXPECT_FALSE(says(report, "profile.svg"));
}

TEST(Report, ReportsCamWithPictures) {
    const std::string text = report_markdown(test::cam_solution());
    for (const char* part :
         {"## The cam", "| base radius | 30 mm |", "| largest pressure angle |", "- No undercut",
          "![The cam to scale](profile.svg)", "(profile_diagrams.svg)", "- Cam: translating roller"})
        EXPECT_TRUE(says(text, part)) << part;
    EXPECT_FALSE(says(report_markdown(test::sample_solution()), "The cam"));
}

TEST(Report, ReportsProgramBySegments) {
    const std::string text = report_markdown(test::program_solution());
    for (const char* part : {"a program of 4 segments over 360 deg", "## Segments", "| modified sine |",
                             "spline segments | at (deg)", "22.4039 mm/rad | 337.5"})
        EXPECT_TRUE(says(text, part)) << part;
}

TEST(SolverWords, NameBackendThatWasNotUsed) {
    Solution solution = test::cam_solution();
    SolvePlan plan;
    plan.solver = "ipopt";
    solution.plan = std::make_shared<const SolvePlan>(plan);
    solution.solver.name = "structured";
    EXPECT_TRUE(says(solver_words(solution), "structured; ipopt was not needed"));
    EXPECT_TRUE(says(summary_text(solution, {}), "ipopt was not needed"));
    plan.next_solver = "structured";
    solution.plan = std::make_shared<const SolvePlan>(plan);
    EXPECT_EQ(solver_words(solution), "structured");
}

TEST(PrescribedWords, NameNoSpline) {
    Solution solution = test::infeasible_cam_solution();
    ProgramSegment law;
    law.kind = SegmentKind::law;
    law.law = "cycloidal";
    law.to = 1.0;
    law.angle = solution.scene.motion.unit_angle();
    solution.scene.motion.type = MotionType::program;
    solution.scene.motion.segments = {law};
    ASSERT_TRUE(solution.scene.motion.prescribed());
    SolvePlan plan;
    plan.dimensions = 1;
    solution.plan = std::make_shared<const SolvePlan>(plan);
    EXPECT_FALSE(says(verdict_sentence(solution), "spline")) << verdict_sentence(solution);
    EXPECT_FALSE(says(conflict_sentence(solution), "quintic")) << conflict_sentence(solution);
    EXPECT_TRUE(says(verdict_sentence(solution), "prescribed motion violates a limit with every cam"));
}

// It starts with 1200 mm/s.
TEST(ConflictSentence, NamesStartBeyondLimit) {
    const std::vector<std::string> slower = {"limits.velocity_mm_s=800"};
    const Solution solution =
        solve(load_scene(source_folder() + "/tests/cases/49_moving_start.toml", slower));
    ASSERT_EQ(solution.certificate.verdict, Verdict::infeasible);
    EXPECT_TRUE(says(conflict_sentence(solution), "motion.start alone violates it"))
        << conflict_sentence(solution);
}

TEST(ConflictSentence, WithoutRowsNamesLimitsOnly) {
    Solution solution = test::infeasible_cam_solution();
    for (ConflictReport& row : solution.conflict) row.at = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(conflict_sentence(solution).starts_with(
        "The pressure angle limit conflicts with the cam radius limit: no spline"))
        << conflict_sentence(solution);
}

TEST(ChangesTable, SaysAtMostUnlessExact) {
    Solution solution = test::infeasible_cam_solution();
    const auto needed = [&](std::size_t row) { return relaxation_table(solution).rows[row][2]; };
    EXPECT_EQ(needed(0), "at most 31.413");
    SolvePlan plan;
    plan.convex = true;
    solution.plan = std::make_shared<const SolvePlan>(plan);
    EXPECT_EQ(needed(0), "at most 31.413") << "of a dimension";
    EXPECT_EQ(needed(2), "33.1") << "of a limit of a convex scene";
    EXPECT_EQ(needed(3), "2.5");
}

TEST(PrescribedMotion, HasCurvesWhereItViolatesLimit) {
    const Solution solution = solve(load_scene(source_folder() + "/tests/cases/43_laws.toml", {}));
    const std::string text = summary_text(solution, {});
    EXPECT_TRUE(says(text, "pressure_angle reaches 24.")) << text;
    EXPECT_TRUE(says(text, "(violated)")) << text;
    for (const std::string& all : {text, report_markdown(solution)})
        for (const char* const word : {"spline", "weights", "more segments"})
            EXPECT_FALSE(says(all, word)) << word << "\n" << all;
}

TEST(PrescribedMotion, IsComparedWhereItViolatesLimit) {
    const Comparison comparison = compare(load_scene(source_folder() + "/tests/cases/43_laws.toml", {}));
    const auto own = std::ranges::find_if(comparison.rows, &ComparisonRow::is_optimum);
    ASSERT_TRUE(own != comparison.rows.end());
    EXPECT_TRUE(says(broken_limits(*own).at(0), "pressure angle"));
}

TEST(PrescribedMotion, BestLawHasSmallestBaseRadius) {
    const std::vector<std::string> settings = {"limits.pressure_angle_deg=30"};
    const Comparison comparison =
        compare(load_scene(source_folder() + "/tests/cases/43_laws.toml", settings));
    EXPECT_TRUE(
        says(comparison_sentence(comparison), "smallest base radius: Modified constant velocity, 50 %"))
        << comparison_sentence(comparison);
}

}  // namespace cam_texts_test
}  // namespace camopt
