// SPDX-License-Identifier: MIT
// Objectives of programs against their definition: V, A, J are the largest over the strokes of |s'| β / |h|,
// |s''| β² / |h|, |s'''| β³ / |h| with the angle β and the displacement h of the stroke, the lift where h is
// 0 or free. Neighbouring splines are one stroke, but where the motion turns back. Everything is recomputed
// from the published knots and control points alone.
#include "core/errors.hpp"
#include "objectives/program_family.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "solvers/certificate/certificate.hpp"
#include "studies/check/scene_check.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

namespace camopt {
namespace program_objective_test {

using namespace testing_support;

/// Its splines have 5 segments each.
Scene chain(std::vector<ProgramSegment> segments, bool closed = true) {
    Scene scene = program(std::move(segments), 5);
    scene.motion.closed = closed;
    return scene;
}

/// A B-spline as published: value by de Boor's recursion, in the knot span [knots[k], knots[k + 1]).
double de_boor(const std::vector<double>& knots, std::vector<double> points, int degree, int k, double x) {
    for (int r = 1; r <= degree; ++r) {
        for (int j = k; j > k - degree + r - 1; --j) {
            const auto at = static_cast<std::size_t>(j);
            const double left = knots[at], right = knots[at + static_cast<std::size_t>(degree - r) + 1];
            const double part = (x - left) / (right - left);
            points[at] = (1.0 - part) * points[at - 1] + part * points[at];
        }
    }
    return points[static_cast<std::size_t>(k)];
}

/// max |s^{(order)}| of a published spline: samples of each span, refined by a parabola.
double largest(std::vector<double> knots, std::vector<double> points, int degree, int order) {
    for (int r = 0; r < order; ++r, --degree) {
        std::vector<double> lower;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const double width = knots[i + static_cast<std::size_t>(degree) + 1] - knots[i + 1];
            lower.push_back(width > 0.0 ? degree * (points[i + 1] - points[i]) / width : 0.0);
        }
        points = std::move(lower);
        knots = std::vector<double>(knots.begin() + 1, knots.end() - 1);
    }
    constexpr int samples = 128;
    double found = 0.0;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        if (!(knots[k + 1] > knots[k])) continue;
        std::array<double, samples + 1> value{};
        for (int i = 0; i <= samples; ++i)
            value[static_cast<std::size_t>(i)] =
                std::abs(de_boor(knots, points, degree, static_cast<int>(k),
                                 knots[k] + (knots[k + 1] - knots[k]) * i / samples));
        for (std::size_t i = 0; i <= samples; ++i) {
            found = std::max(found, value[i]);
            if (i == 0 || i == samples || value[i] < value[i - 1] || value[i] < value[i + 1]) continue;
            const double bend = value[i - 1] - 2.0 * value[i] + value[i + 1];
            const double slope = 0.5 * (value[i + 1] - value[i - 1]);
            if (bend < 0.0) found = std::max(found, value[i] - 0.5 * slope * slope / bend);
        }
    }
    return found;
}

struct Measured {
    std::array<double, 4> peak{};  ///< V, A, J at 1, 2, 3
    double objective = 0.0;
};

/// Which displacements at joints the scene gives, one more than segments: dwells carry them along.
std::vector<bool> given_joints(const MotionSpec& motion) {
    const std::vector<ProgramSegment>& segments = motion.segments;
    std::vector<bool> given(segments.size() + 1, false);
    given.front() = true;
    given.back() = motion.closed;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (segments[i].to) given[i + 1] = true;
        if (segments[i].kind == SegmentKind::dwell && given[i]) given[i + 1] = true;
    }
    for (std::size_t i = segments.size(); i-- > 0;)
        if (segments[i].kind == SegmentKind::dwell && given[i + 1]) given[i] = true;
    return given;
}

/// {angle in x, displacement} of the stroke that each segment belongs to.
std::vector<std::array<double, 2>> stroke_measures(const Solution& solution) {
    const std::vector<bool> given = given_joints(solution.scene.motion);
    const std::vector<SegmentReport>& all = solution.segments;
    const std::size_t count = all.size();
    const auto begins = [&](std::size_t i) {
        const std::size_t before = (i + count - 1) % count;
        if (i == 0 && !solution.scene.motion.closed) return true;
        if (all[i].kind != SegmentKind::spline || all[before].kind != SegmentKind::spline) return true;
        const double own = all[i].to - all[i].from, last = all[before].to - all[before].from;
        return !given[before] || !given[before + 1] || !given[i] || !given[i + 1] ||
               (own * last < 0.0 || std::min(std::abs(own), std::abs(last)) < 1e-9);
    };
    std::size_t first = 0;
    while (first < count && !begins(first)) ++first;
    std::vector<std::array<double, 2>> measures(count);
    for (std::size_t k = 0, size = 0; k < count; k += size) {
        const std::size_t begin = (first + k) % count;
        size = 1;
        while (first < count && k + size < count && !begins((begin + size) % count)) ++size;
        const std::size_t last = (begin + size - 1) % count;
        double angle = 0.0;
        for (std::size_t i = 0; i < size; ++i)
            angle += all[(begin + i) % count].end - all[(begin + i) % count].begin;
        const double moved = std::abs(all[last].to - all[begin].from);
        const bool by_lift = moved < 1e-9 || !given[begin] || !given[last + 1];
        for (std::size_t i = 0; i < size; ++i) measures[(begin + i) % count] = {angle, by_lift ? 1.0 : moved};
    }
    return measures;
}

Measured measured(const Solution& solution) {
    Measured result;
    const std::vector<std::array<double, 2>> measures = stroke_measures(solution);
    for (std::size_t i = 0; i < solution.segments.size(); ++i) {
        const SegmentReport& segment = solution.segments[i];
        if (segment.kind != SegmentKind::spline) continue;
        const std::vector<double> knots = segment.curve->knots();
        const Eigen::VectorXd published = segment.curve->coefficients();
        const std::vector<double> points(published.begin(), published.end());
        const auto& [angle, measure] = measures[i];
        for (int order = 1; order <= 3; ++order)
            result.peak[static_cast<std::size_t>(order)] = std::max(
                result.peak[static_cast<std::size_t>(order)],
                largest(knots, points, segment.curve->degree(), order) * std::pow(angle, order) / measure);
    }
    const ObjectiveSpec& weights = solution.scene.objective;
    const Peaks& reference = solution.reference_peaks;
    result.objective = weights.velocity * result.peak[1] / reference.velocity.value +
                       weights.acceleration * result.peak[2] / reference.acceleration.value +
                       weights.jerk * result.peak[3] / reference.jerk.value;
    return result;
}

void expect_measured(const Solution& solution) {
    ASSERT_TRUE(solution.motion) << solution.certificate.reason;
    const Measured own = measured(solution);
    EXPECT_NEAR(solution.certificate.objective, own.objective, 1e-6 * std::max(1.0, own.objective));
    // 1e-6: the parabola between samples. 1e-8: a spline that stands has peaks of rounding.
    EXPECT_NEAR(solution.peaks.velocity.value, own.peak[1], 1e-6 * own.peak[1] + 1e-8);
    EXPECT_NEAR(solution.peaks.acceleration.value, own.peak[2], 1e-6 * own.peak[2] + 1e-8);
    EXPECT_NEAR(solution.peaks.jerk.value, own.peak[3], 1e-6 * own.peak[3] + 1e-8);
    if (solution.certificate.lower_bound) {
        EXPECT_TRUE(std::isfinite(*solution.certificate.lower_bound));
        EXPECT_LE(*solution.certificate.lower_bound,
                  solution.certificate.objective + 1e-8 * std::max(1.0, own.objective));
    }
}

/// What the proof says, recomputed from its own numbers.
void expect_proved(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    if (certificate.proof_kind == ProofKind::duality) {
        EXPECT_GE(recomputed_bound(*certificate.proof), *certificate.lower_bound);
        return;
    }
    if (certificate.proof_kind != ProofKind::boxes) return;
    double bound = infinity;
    for (const CaseProof& part : certificate.cases) {
        ASSERT_TRUE(part.proof);
        const double own = recomputed_bound(*part.proof);
        EXPECT_GE(own, part.infeasible ? 0.0 : part.bound);
        if (!part.infeasible) bound = std::min(bound, own);
    }
    EXPECT_GE(bound, *certificate.lower_bound);
}

// Where splines join in motion is a matter of how a stroke is written, not of what it costs.

TEST(ProgramObjective, JoinedSplinesAreOneStroke) {
    // Of fine splines: the joined one has a breakpoint at the set point.
    const Solution one = solve(scene_named("joined_by_set_point").with("spline.segments = 80"));
    const Solution joined = solve(scene_named("joined_strokes").with("spline.segments = 50"));
    ASSERT_EQ(one.certificate.verdict, Verdict::optimal);
    ASSERT_EQ(joined.certificate.verdict, Verdict::optimal);
    EXPECT_NEAR(joined.certificate.objective, one.certificate.objective, 0.01 * one.certificate.objective);
    expect_measured(joined);
    expect_proved(joined);
}

TEST(ProgramObjective, StrokesPartWhereMotionRests) {
    const TestScene scene = scene_named("joined_strokes");
    const auto scales = [](const Scene& of) { return peak_scales(of); };
    const auto together = scales(scene);
    EXPECT_NEAR(together[1].angle, 140.0 / 87.5, 1e-12);
    EXPECT_NEAR(together[1].displacement, 1.0, 1e-12);
    EXPECT_EQ(together[2].angle, together[1].angle);
    Scene resting = scene;
    resting.motion.segments[1].end = SetPoint{.at = 1.0, .velocity = 0.0};
    const auto parted = scales(resting);
    EXPECT_NEAR(parted[1].angle, 1.0, 1e-12);
    EXPECT_NEAR(parted[1].displacement, 23.5 / 85.0, 1e-12);
    EXPECT_NEAR(parted[2].angle, 52.5 / 87.5, 1e-12);
}

TEST(ProgramObjective, OfMotionIsLeastPeak) {
    const std::pair<const char*, double> known[] = {{"48_weld", 292.0744}, {"55_die", 2.89424}};
    const double units[] = {0.0254, 1.0};  // in/s², m/s²
    for (std::size_t i = 0; i < std::size(known); ++i) {
        const Solution solution = solve(scene_named(known[i].first).with("objective.peaks = 'motion'"));
        ASSERT_EQ(solution.certificate.verdict, Verdict::optimal);
        const MotionSpec& motion = solution.scene.motion;
        const double per_normalised = motion.lift * std::pow(*motion.speed / motion.unit_angle(), 2);
        EXPECT_NEAR(solution.motion_peaks.acceleration.value * per_normalised / units[i], known[i].second,
                    1e-6 * known[i].second);
        EXPECT_EQ(solution.peaks.acceleration.value, solution.motion_peaks.acceleration.value);
    }
}

TEST(ProgramObjective, IsMeasuredByTheLift) {
    // Two splines share the rise: where they part is free.
    const Solution solution =
        solve(chain({dwell(30), spline(60), spline(80, 1.0), dwell(30), spline(160, 0.0)}));
    expect_measured(solution);
    expect_proved(solution);
}

TEST(ProgramObjective, OpenChainScalesWithLift) {
    const Solution solution = solve(chain({spline(60), spline(80, 1.0), dwell(30)}, false));
    expect_measured(solution);
    expect_proved(solution);
    EXPECT_EQ(solution.certificate.verdict, Verdict::optimal);
}

TEST(ProgramObjective, DwellBetweenSplinesScalesWithLift) {
    // Two rises of the same shape share the lift: each half of it has half the peaks.
    const Solution solution = solve(chain({spline(60), dwell(30), spline(80, 1.0), dwell(30)}, false));
    expect_measured(solution);
    ASSERT_EQ(solution.certificate.verdict, Verdict::optimal) << solution.certificate.reason;
    expect_proved(solution);
    const Scene rise = paper_objective(MotionType::drd, 3, 5);
    EXPECT_NEAR(solution.certificate.objective, 0.5 * solve(rise).certificate.objective, 1e-7);
}

TEST(ProgramObjective, PeakCapsScaleWithLift) {
    Scene scene = chain({spline(60), spline(80, 1.0), dwell(30)}, false);
    scene.limits.velocity = normalised_limit("limits.velocity", 1.3);
    const Solution solution = solve(scene);
    expect_measured(solution);
    EXPECT_LE(measured(solution).peak[1], 1.3 * (1.0 + 1e-7));
    ASSERT_FALSE(solution.constraints.empty());
    EXPECT_NEAR(solution.constraints.front().worst, measured(solution).peak[1], 1e-7);
}

TEST(ProgramObjective, ThreeFreeDisplacementsScaleWithLift) {
    Scene scene = chain({spline(50), spline(60), spline(40), spline(70, 1.0), dwell(30)}, false);
    scene.spline.segments = 2;
    const Solution solution = solve(scene);
    expect_measured(solution);
    expect_proved(solution);
}

TEST(ProgramObjective, FreeLawScalesWithLift) {
    const Solution solution =
        solve(chain({law(60, "cycloidal"), dwell(20), spline(80, 1.0), dwell(30), spline(170, 0.0)}));
    expect_measured(solution);
    expect_proved(solution);
}

TEST(ProgramObjective, CamProgramScalesWithLift) {
    Scene scene = chain({dwell(30), spline(60), spline(80, 1.0), dwell(30), spline(160, 0.0)});
    scene.cam = disk_spec({});
    scene.cam->set(DimensionIndex::base_radius, 25e-3);
    scene.cam->set(DimensionIndex::roller_radius, 8e-3);
    scene.limits.pressure_angle = degrees(35.0, "limits.pressure_angle_deg");
    const Solution solution = solve(scene);
    expect_measured(solution);
    EXPECT_LE(solution.cam->summary.pressure_angle.value, 35.0 * units::degree * (1.0 + 1e-7));
}

TEST(ProgramObjective, ACheckCountsTheFreeDisplacements) {
    const SceneCheck one = check_scene(chain({spline(60), spline(80, 1.0), dwell(30)}, false));
    EXPECT_EQ(one.plan.displacements, 1);
    EXPECT_TRUE(one.plan.convex);
    const SceneCheck none = check_scene(chain({spline(60, 0.5), spline(80, 1.0), dwell(30)}, false));
    EXPECT_EQ(none.plan.displacements, 0);
    EXPECT_TRUE(none.plan.convex);
}

/// Its control points are one number; the derivatives of its pieces were the rounding of that number.
TEST(ProgramObjective, StationarySplineIsZero) {
    Scene scene = chain({dwell(30), law(32, "polynomial_345", 0.75), spline(29),
                         law(50, "modified_sine", 1.0), law(105, "modified_sine", 0.0), dwell(114)});
    scene.spline.segments = 8;
    scene.spline.design = DesignKind::states;
    scene.objective = {};
    scene.objective.jerk = 0.72671110930080107;
    const Solution closed = solve(scene);
    scene = chain({law(81, "polynomial_345", 0.5), spline(105), law(50, "cycloidal", 0.75), spline(74),
                   dwell(25), law(25, "modified_sine", 0.0)},
                  false);
    scene.spline.segments = 12;
    scene.objective = {};
    scene.objective.acceleration = 0.67;
    scene.objective.jerk = 0.59;
    for (const Solution& solution : {closed, solve(scene)}) {
        ASSERT_TRUE(solution.motion) << solution.certificate.reason;
        EXPECT_EQ(solution.certificate.objective, 0.0);
        EXPECT_EQ(solution.peaks.jerk.value, 0.0);
        for (const SegmentReport& segment : solution.segments) {
            if (segment.kind != SegmentKind::spline) continue;
            EXPECT_NEAR(segment.curve->at(segment.begin).derivative[0], segment.from, 1e-12);
            EXPECT_EQ(segment.curve->pieces().bottomRows(segment.curve->degree()).cwiseAbs().maxCoeff(), 0.0);
        }
    }
}

/// The first spline has a least acceleration of 3, whatever follows, and only one displacement of the second
/// needs no more: cases that hold no motion have to be proved empty, or the search ends among them.
TEST(ProgramObjective, FindsOnlyFeasibleDisplacement) {
    Scene scene = chain({spline(85, 0.5), spline(102), law(173, "polynomial_4567", 0.0)});
    scene.spline.segments = 3;
    scene.objective = {};
    scene.objective.velocity = 0.3;
    scene.objective.acceleration = 0.57;
    scene.objective.jerk = 0.82;
    scene.limits.jerk = normalised_limit("limits.jerk", 115.2);
    const Solution free = solve(scene);
    ASSERT_EQ(free.certificate.verdict, Verdict::optimal) << free.certificate.reason;
    for (const double room : {1e-7, 1e-5, 3e-4}) {
        scene.limits.acceleration =
            normalised_limit("limits.acceleration", free.peaks.acceleration.value * (1.0 + room));
        const Solution capped = solve(scene);
        ASSERT_EQ(capped.certificate.verdict, Verdict::optimal) << room << " " << capped.certificate.reason;
        EXPECT_NEAR(capped.certificate.objective, free.certificate.objective, 1e-6);
        expect_measured(capped);
        expect_proved(capped);
    }
}

std::string message_of(const Scene& scene) {
    return refusal([&] { (void)solve(scene); });
}

TEST(ProgramObjective, MotionlessProgramIsRefused) {
    const std::string free = message_of(chain({spline(180), spline(180)}));
    EXPECT_NE(free.find("motion.segments[0].to"), std::string::npos) << free;
    EXPECT_NE(free.find("nothing has to move"), std::string::npos) << free;
    const std::string zero = message_of(chain({dwell(90), law(90, "cycloidal"), spline(180, 0.0)}));
    EXPECT_NE(zero.find("motion.segments[1].to"), std::string::npos) << zero;
    EXPECT_NE(message_of(chain({dwell(90), spline(270)})), "no refusal");
    EXPECT_NE(message_of(chain({spline(90)}, false)), "no refusal");
    EXPECT_EQ(message_of(chain({spline(90, 1.0)}, false)), "no refusal");
}

/// Programs of all kinds of segments, closed and open, most `to` missing.
class RandomPrograms {
 public:
    explicit RandomPrograms(unsigned seed) : engine_(seed) {}

    Scene next() {
        Scene scene;
        do {
            scene = drawn();
        } while (find_fault(scene));
        return scene;
    }

 private:
    // Plain arithmetic on the engine: the standard's distributions differ from library to library.
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967295.0;
    }
    bool chance(double part) { return uniform(0.0, 1.0) < part; }

    Scene drawn() {
        std::vector<ProgramSegment> segments;
        const int count = 1 + static_cast<int>(uniform(1.0, 4.999));
        const bool closed = chance(0.6);
        for (int i = 0; i < count; ++i) {
            ProgramSegment segment = spline(uniform(30.0, 100.0));
            const double kind = uniform(0.0, 1.0);
            if (kind < 0.25) segment = dwell(uniform(20.0, 60.0));
            if (kind > 0.85) segment = law(uniform(30.0, 100.0), chance(0.5) ? "cycloidal" : "modified_sine");
            if (segment.kind != SegmentKind::dwell && chance(0.45)) segment.to = uniform(-0.3, 1.3);
            segments.push_back(segment);
        }
        double total = 0.0;
        for (const ProgramSegment& segment : segments) total += segment.angle;
        const double turn = 360.0 * units::degree * (closed ? 1.0 : 0.9);
        for (ProgramSegment& segment : segments) segment.angle *= turn / total;
        Scene scene = chain(std::move(segments), closed);
        scene.spline.degree = chance(0.7) ? 3 : 5;
        scene.spline.segments = static_cast<int>(uniform(2.0, 5.999));
        scene.objective.velocity = uniform(0.0, 1.0);
        scene.objective.acceleration = uniform(0.0, 1.0);
        scene.objective.jerk = uniform(0.05, 1.0);
        if (chance(0.2)) scene.limits.velocity = normalised_limit("limits.velocity", 2.5);
        scene.solver.max_seconds = 20.0;
        return scene;
    }

    std::mt19937 engine_;
};

TEST(ProgramObjective, RandomProgramsMatchTheirSplines) {
    RandomPrograms programs(18);
    std::map<Verdict, int> verdicts;
    for (int k = 0; k < 20; ++k) {
        SCOPED_TRACE(k);
        const Solution solution = solve(programs.next());
        ++verdicts[solution.certificate.verdict];
        if (!solution.motion) continue;
        expect_measured(solution);
        expect_proved(solution);
        if (HasFailure()) return;
    }
    EXPECT_GE(verdicts[Verdict::optimal] + verdicts[Verdict::infeasible], 18);
    for (const auto& [verdict, count] : verdicts) RecordProperty(name_of(verdict), count);
}

}  // namespace program_objective_test
}  // namespace camopt
