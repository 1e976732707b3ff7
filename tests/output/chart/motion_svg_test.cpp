// SPDX-License-Identifier: MIT
#include "core/errors.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "output/chart/curve_chart.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/report/result_folder.hpp"
#include "output/view/number_text.hpp"
#include "output/view/peak_comparison.hpp"
#include "output/view/view.hpp"
#include "output/words/solution_text.hpp"
#include "tests/output/sample_solution.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace camopt {
namespace motion_svg_test {

using testing_support::refusal;

int count_of(const std::string& text, const std::string& part) {
    int count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// Every tag is closed in order, and no bare & or < stands in the text: enough for XML as we write it.
bool well_formed(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at + 1)) {
        const std::size_t end = text.find('>', at);
        if (end == std::string::npos) return false;
        const std::string tag = text.substr(at + 1, end - at - 1);
        if (tag.find('<') != std::string::npos) return false;
        if (tag.front() == '?' || tag.back() == '/') continue;
        if (tag.front() != '/') {
            open.push_back(tag.substr(0, tag.find(' ')));
        } else {
            if (open.empty() || open.back() != tag.substr(1)) return false;
            open.pop_back();
        }
    }
    return open.empty() && count_of(text, "&") == count_of(text, "&amp;") + count_of(text, "&lt;") +
                                                      count_of(text, "&gt;") + count_of(text, "&quot;");
}

TEST(MotionSvg, IsWellFormedAndComplete) {
    const std::string svg = motion_svg(test::sample_solution());
    EXPECT_TRUE(well_formed(svg));
    EXPECT_EQ(count_of(svg, "<path"), 8);  // four panels, optimum and reference
    EXPECT_NE(svg.find("Four segments &amp; &lt;one&gt; title"), std::string::npos);
    EXPECT_NE(svg.find(">400 mm/s at "), std::string::npos);
    EXPECT_NE(svg.find(">V = 2 · modified sine V = 1.7596"), std::string::npos);
    EXPECT_NE(svg.find(">Velocity (v)<"), std::string::npos);
    EXPECT_NE(svg.find(">m/s²<"), std::string::npos);
    EXPECT_EQ(svg.find(">mm/rad<"), std::string::npos);
    EXPECT_NE(svg.find("limit 500 mm/s"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(MotionSvg, LawImpulsesAreOmitted) {
    Solution solution = test::sample_solution();
    solution.scene.objective.jerk = 0.0;
    for (const char* law : {"parabolic", "simple_harmonic", "mcv_50"}) {
        solution.scene.objective.reference.law = law;
        const std::string svg = motion_svg(solution);
        EXPECT_TRUE(well_formed(svg)) << law;
        EXPECT_EQ(svg.find("inf "), std::string::npos) << law;
        EXPECT_EQ(svg.find("nan"), std::string::npos) << law;
    }
}

TEST(MotionSvg, ProgramShowsSegmentsAndLaw) {
    Solution solution = test::program_solution();
    solution.scene.limits.velocity = PeakLimit{2.5, "limits.velocity", 2.5, ""};
    const std::string svg = motion_svg(solution);
    EXPECT_TRUE(well_formed(svg));
    EXPECT_EQ(count_of(svg, "<path"), 8);                      // four panels, optimum and reference
    EXPECT_EQ(count_of(svg, "class=\"segment\""), 4 * 3 + 1);  // three boundaries a panel, one in the legend
    for (const char* part :
         {">dwell<", ">spline<", "modified sine V = 1.7596", "V = 2 of the spline segments",
          "limit 2.5 by the segment", "angle of the first spline segment"})
        EXPECT_NE(svg.find(part), std::string::npos) << part;
}

TEST(MotionSvg, TimeLimitCoversWholeProgram) {
    Solution solution = test::program_solution();
    solution.scene.limits.velocity = PeakLimit{4.0, "limits.velocity_mm_s", 800.0, "mm/s"};
    EXPECT_NE(motion_svg(solution).find(">limit 800 mm/s<"), std::string::npos);
}

TEST(ReferenceMotion, ProgramSceneHasNoCurve) {
    const ReferenceMotion reference = reference_motion(test::program_solution().scene);
    EXPECT_EQ(reference.motion, nullptr);
    EXPECT_EQ(reference.title, "modified sine");
    EXPECT_NEAR(reference.peaks.acceleration.value, 5.527957070544091, 1e-12);
}

TEST(ReferenceMotion, FollowsSplineSegmentsOfAProgram) {
    const Solution solution = test::program_solution();
    const View view(solution);
    const auto law = make_law("modified_sine");
    const double up = 2.0 / 3.0;  // where the spline begins; its unit angle is that of x
    const std::vector<double> joints = {up, up + 1.0, 3.5};
    for (std::size_t order = 0; order < view.curves.size(); ++order) {
        const Curve& curve = view.curves[order];
        ASSERT_TRUE(curve.reference.has_value()) << curve.key;
        EXPECT_EQ(curve.reference->title, "modified sine");
        const double per = view.units.motion[order].first.per_normalised;
        int compared = 0;
        for (std::size_t i = 0; i < view.delivered.rows.size(); ++i) {
            const DeliveredRow& row = view.delivered.rows[i];
            const bool inside = row.x > up && row.x < up + 1.0;
            if (std::ranges::any_of(joints, [&](double x) { return std::abs(x - row.x) < 1e-9; })) continue;
            const double law_there =
                inside ? per * law->at(row.x - up, row.side).derivative[order] : curve.values[i];
            EXPECT_NEAR(curve.reference->values[i], law_there, 1e-9 * per) << curve.key << " at " << row.x;
            compared += inside ? 1 : 0;
        }
        EXPECT_GT(compared, 50);
        EXPECT_TRUE(std::isfinite(curve.reference->values.back())) << "up to its end";
    }
    Solution numbers = solution;
    numbers.scene.objective.reference.numeric = true;
    EXPECT_FALSE(View(numbers).curves[1].reference.has_value());
}

TEST(MotionCurves, MarkThePeaksOfBothSigns) {
    for (const Solution& solution : {test::sample_solution(), test::cam_solution()}) {
        const View view(solution);
        for (std::size_t order = 1; order <= 3; ++order) {
            const Curve& curve = view.curves[order];
            const auto [least, largest] = std::ranges::minmax_element(curve.values);
            for (const double extreme : {*least, *largest}) {
                const double size = std::max(std::abs(*least), std::abs(*largest));
                if (std::abs(extreme) < 1e-9 * size) continue;
                EXPECT_TRUE(std::ranges::any_of(
                    curve.marks,
                    [&](const CurveMark& mark) { return std::abs(mark.value - extreme) < 1e-3 * size; }))
                    << curve.key << " " << extreme;
            }
        }
    }
}

TEST(MotionSvg, NeedsACurve) {
    EXPECT_EQ(refusal([&] { (void)motion_svg(test::infeasible_solution()); }),
              "motion.svg needs a motion, and this solution has none");
}

TEST(ReferenceMotion, ReturnMirrorsRiseOnItsAngle) {
    Scene scene = test::sample_solution().scene;
    scene.motion.type = MotionType::rr;
    scene.motion.return_angle = scene.motion.rise / 2;
    const ReferenceMotion reference = reference_motion(scene);
    const Motion& motion = *reference.motion;
    EXPECT_DOUBLE_EQ(motion.end(), 1.5);
    const MotionPoint rise = motion.at(0.3), fall = motion.at(1.5 - 0.5 * 0.3);
    EXPECT_NEAR(fall.derivative[0], rise.derivative[0], 1e-14);
    EXPECT_NEAR(fall.derivative[1], -2 * rise.derivative[1], 1e-13);
    EXPECT_NEAR(fall.derivative[2], 4 * rise.derivative[2], 1e-12);
    EXPECT_NEAR(fall.derivative[3], -8 * rise.derivative[3], 1e-11);
    EXPECT_NEAR(reference.peaks.jerk.value, 8 * 69.46635728872427, 1e-9);
    // The mean square over the motion, recomputed on the return's stretched copy.
    EXPECT_NEAR(reference.peaks.rms_acceleration, 3.9088559306898487 * std::sqrt((1 + 0.5 * 16) / 1.5), 1e-9);
    EXPECT_NEAR(motion.at(1.5, Side::left).derivative[0], 0.0, 1e-15);
    EXPECT_EQ(motion.breakpoints().back(), 1.5);
}

TEST(AxisTicks, AreRoundAndInside) {
    EXPECT_EQ(round_ticks(-0.1, 1.05, 6), (std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0}));
    EXPECT_EQ(degree_ticks(0, 180, 14).size(), 13U);
    EXPECT_TRUE(round_ticks(1, 1, 5).empty());
    EXPECT_TRUE(labelled_ticks(1, 1, 5).empty());
    ASSERT_EQ(labelled_ticks(0.93, 1.04, 1).size(), 1U);  // one alone has no neighbour to be told from
    EXPECT_EQ(labelled_ticks(0.93, 1.04, 1).front().words, "1.0");
    EXPECT_EQ(tick_text(-0.5, 0.5), "−0.5");
    EXPECT_EQ(tick_text(20, 10), "20");
}

TEST(NumberText, RoundTripsAndOmitsInfinity) {
    for (const double value : {1.0 / 3.0, 5e-324, -1.7976931348623157e308, 0.1})
        EXPECT_EQ(std::strtod(round_trip_text(value).c_str(), nullptr), value);
    EXPECT_EQ(round_trip_text(-0.0), "0");
    EXPECT_EQ(round_trip_text(infinity), "");
    EXPECT_EQ(short_text(infinity), "∞");
    EXPECT_EQ(change_text(0.974, 1.0), "−2.6 %");
    EXPECT_EQ(change_text(1.0, 1.0), "±0.0 %");
    EXPECT_EQ(change_text(1.0, infinity), "–");
}

TEST(Report, AnswersCamEngineersQuestions) {
    const std::string text = report_markdown(test::sample_solution(), {"a.toml", "camopt solve a.toml"});
    for (const char* part :
         {"Proved optimal", "| velocity V | 400 mm/s | 12.7324 mm/rad | 2 |", "modified sine",
          "curve of least objective", "limits.velocity_mm_s", "![Displacement", "how_to_check",
          "camopt solve a.toml", "via point 1 follows from symmetry", "0.08333333333333333"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
    const std::string infeasible = report_markdown(test::infeasible_solution());
    EXPECT_NE(infeasible.find("raise the velocity limit to 312.5 mm/s"), std::string::npos);
    EXPECT_EQ(infeasible.find("motion.svg"), std::string::npos);
}

TEST(SolutionText, HasASentenceForEveryVerdict) {
    Certificate certificate;
    certificate.reason = Reason::time_limit;
    const auto sentence = [&](Verdict verdict) {
        certificate.verdict = verdict;
        return verdict_sentence(certificate);
    };
    EXPECT_TRUE(sentence(Verdict::optimal).starts_with("Proved optimal"));
    EXPECT_TRUE(sentence(Verdict::local).starts_with("Local optimum"));
    certificate.gap = 6.7e-7;
    EXPECT_NE(sentence(Verdict::local).find("at most 0.00007 % from the optimum"), std::string::npos);
    EXPECT_EQ(
        sentence(Verdict::feasible),
        "Feasible: every limit is satisfied; proved to be at most 0.00007 % from the optimum (time limit).");
    certificate.gap.reset();
    EXPECT_EQ(sentence(Verdict::feasible),
              "Feasible: every limit is satisfied; optimality is not proved (time limit).");
    EXPECT_TRUE(sentence(Verdict::infeasible).starts_with("Proved infeasible"));
    EXPECT_EQ(sentence(Verdict::failed), "Failed: neither a curve nor a proof was found (time limit).");
}

}  // namespace motion_svg_test
}  // namespace camopt
