// SPDX-License-Identifier: MIT
#include "studies/pareto/pareto_front.hpp"

#include "core/errors.hpp"
#include "studies/solve/solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace camopt {
namespace pareto_front_test {

using namespace testing_support;

constexpr FrontFigure V = FrontFigure::velocity, A = FrontFigure::acceleration, J = FrontFigure::jerk;

std::vector<FrontPoint> spaced(const ParetoFront& front) {
    std::vector<FrontPoint> points;
    std::ranges::copy_if(front.points, std::back_inserter(points),
                         [](const FrontPoint& point) { return point.place >= 0; });
    return points;
}

FrontRequest request_of(const FrontGoal& first, const FrontGoal& second) {
    FrontRequest request;
    request.goals = {first, second};
    return request;
}

ParetoFront front_of(const FrontRequest& request, const Scene& scene) {
    ParetoFront front = pareto_front(scene, request);
    EXPECT_TRUE(front.complete);
    return front;
}

Scene cubic_12() {
    return paper_objective(MotionType::drd, 3, 12);
}

void expect_ends(const ParetoFront& front, const std::array<double, 2>& first,
                 const std::array<double, 2>& second) {
    const std::vector<FrontPoint> points = spaced(front);
    for (const auto& [point, value] : {std::pair{points.front(), first}, {points.back(), second}}) {
        EXPECT_EQ(point.end, FrontEnd::attained);
        for (std::size_t goal : {0U, 1U}) EXPECT_NEAR(point.value[goal], value[goal], 1e-6 * value[goal]);
    }
}

// n uniform segments h = 1/n of a cubic with n + 2 coefficients of y', of which 4 are zero: the least V has
// all others equal, V = n/(n − 2), and then y'' rises to A = V n in one segment, J = V n². The least A keeps
// y'' at ±A but for the ends and the middle: A = 4n/(n − 2), V = 2, J = A n. The least J of n divisible by 4
// is 32, with A = 8, V = 2.
TEST(ParetoFront, EndsMinimizeEachGoal) {
    expect_ends(front_of(request_of(V, A), cubic_12()), {1.2, 14.4}, {2.0, 4.8});
    expect_ends(front_of(request_of(A, J), cubic_12()), {4.8, 57.6}, {8.0, 32.0});
    expect_ends(front_of(request_of(V, J), cubic_12()), {1.2, 172.8}, {2.0, 32.0});
    expect_ends(front_of(request_of(J, A), cubic_12()), {32.0, 8.0}, {57.6, 4.8});
}

TEST(ParetoFront, PointsAreProvedAndNondominated) {
    for (const FrontRequest& request : {request_of(V, A), request_of(A, J), request_of(V, J)}) {
        const ParetoFront front = front_of(request, cubic_12());
        for (std::size_t i = 0; i < front.points.size(); ++i) {
            const FrontPoint& point = front.points[i];
            EXPECT_EQ(point.row.verdict, Verdict::optimal);
            EXPECT_LE(point.row.gap.value(), 1e-7);
            EXPECT_FALSE(point.dominated);
            if (i == 0) continue;
            EXPECT_GT(point.value[0], front.points[i - 1].value[0]);
            EXPECT_LT(point.value[1], front.points[i - 1].value[1]);
        }
    }
}

TEST(ParetoFront, PointsAreEvenlySpaced) {
    FrontRequest request = request_of(V, A);
    for (const int count : {2, 3, 7, 21, 40}) {
        request.points = count;
        const ParetoFront front = front_of(request, cubic_12());
        const std::vector<FrontPoint> points = spaced(front);
        ASSERT_EQ(static_cast<int>(points.size()), count);
        EXPECT_TRUE(front.even);
        EXPECT_EQ(front.spacing.jumps, 0);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double gap = points[i].arc - points[i - 1].arc;
            EXPECT_NEAR(gap, front.spacing.mean, request.evenness * front.spacing.mean);
            EXPECT_EQ(points[i].place, static_cast<int>(i));
        }
        EXPECT_NEAR(points.back().arc, front.spacing.length, 1e-12);
    }
}

TEST(ParetoFront, NeighboursKeepAGivenSpacing) {
    FrontRequest request = request_of(A, J);
    request.spacing = 0.07;
    const ParetoFront front = front_of(request, cubic_12());
    const std::vector<FrontPoint> points = spaced(front);
    EXPECT_TRUE(front.even);
    EXPECT_LE(front.spacing.most, 0.07);
    const double range_a = points.back().value[0] - points.front().value[0];
    const double range_j = points.front().value[1] - points.back().value[1];
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double chord = std::hypot((points[i].value[0] - points[i - 1].value[0]) / range_a,
                                        (points[i].value[1] - points[i - 1].value[1]) / range_j);
        EXPECT_LE(chord, 0.07);
        EXPECT_GE(chord, 0.5 * 0.07);
    }
}

// The front of a linear program is made of straight pieces. On one of them every point has the same weighted
// objective, that of the weights at right angles to it; a solve by weights finds its corners only.
TEST(ParetoFront, InnerPointsMatchWeightedOptimum) {
    const Scene scene = cubic_12();
    const std::array<double, 2> reference{1.76, 5.53};
    const std::vector<FrontPoint> points = spaced(front_of(request_of(V, A), scene));
    const auto fall = [&](std::size_t i) {  // in units of the references
        return -(points[i + 1].value[1] - points[i].value[1]) / reference[1] /
               ((points[i + 1].value[0] - points[i].value[0]) / reference[0]);
    };
    int inside = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (std::abs(fall(i) / fall(i - 1) - 1.0) > 1e-6) continue;
        ++inside;
        const Scene weighted = with_weights(scene, {fall(i) / (1.0 + fall(i)), 1.0 / (1.0 + fall(i)), 0.0});
        const Solution optimum = solve(weighted);
        const double here = weighted.objective.velocity * points[i].value[0] / reference[0] +
                            weighted.objective.acceleration * points[i].value[1] / reference[1];
        EXPECT_NEAR(here, optimum.certificate.objective, 1e-8);
    }
    EXPECT_GE(inside, 5);
}

TEST(ParetoFront, StaysAboveEveryWeightedOptimum) {
    const Scene scene = cubic_12();
    const ParetoFront front = front_of(request_of(V, A), scene);
    for (const double share : {0.05, 0.2, 0.5, 0.8, 0.95}) {
        const double optimum = solve(with_weights(scene, {share, 1.0 - share, 0.0})).certificate.objective;
        double least = infinity;
        for (const FrontPoint& point : front.points)
            least = std::min(least, share * point.value[0] / 1.76 + (1.0 - share) * point.value[1] / 5.53);
        EXPECT_GE(least, optimum - 1e-8);
        EXPECT_LE(least, optimum + 2e-3);  // a point of the front is near
    }
}

TEST(ParetoFront, ExcludesExcessiveCostOfOtherGoal) {
    FrontRequest request = request_of(V, A);
    request.cut_off = 2.0;
    const ParetoFront front = front_of(request, cubic_12());
    const std::vector<FrontPoint> points = spaced(front);
    EXPECT_EQ(points.front().end, FrontEnd::cut_off);
    EXPECT_NEAR(points.front().value[0], 1.3, 1e-8);
    EXPECT_NEAR(points.front().value[1], 9.6, 1e-7);
    EXPECT_EQ(points.back().end, FrontEnd::attained);
    const auto beyond = std::ranges::find(front.points, FrontEnd::beyond, &FrontPoint::end);
    ASSERT_NE(beyond, front.points.end());
    EXPECT_EQ(beyond->place, -1);
    EXPECT_NEAR(beyond->value[0], 1.2, 1e-6);
}

TEST(ParetoFront, KeepsTheScenesOwnLimits) {
    const Scene scene = scene_named("drd_cubic_12").with("limits = { jerk = 70, velocity = 1.9 }");
    const std::vector<FrontPoint> points = spaced(front_of(request_of(V, A), scene));
    for (const FrontPoint& point : points) {
        EXPECT_LE(value_of(point.row, J), 70.0 * (1.0 + 1e-8));
        EXPECT_LE(point.value[0], 1.9 * (1.0 + 1e-8));
    }
    EXPECT_NEAR(points.back().value[0], 1.9, 1e-6);
}

TEST(ParetoFront, KeepsOtherWeightsOnRequest) {
    const Scene scene = cubic_12();
    FrontRequest request = request_of(V, A);
    request.points = 9;
    request.keep_weights = true;
    const std::vector<FrontPoint> points = spaced(front_of(request, scene));
    for (const FrontPoint& point : points) {
        EXPECT_NEAR(point.value[0], 0.4 * value_of(point.row, V) / 1.76 + 0.2 * value_of(point.row, J) / 69.0,
                    1e-9);
        // The scene's own optimum is one of this family.
        EXPECT_GE(point.value[0] + 0.4 * point.value[1] / 5.53, 0.940489277 - 1e-8);
    }
    EXPECT_LT(value_of(points.front().row, J), 60.0);
}

// One solve knows the least base circle but for what the peaks weigh in: see lexicographic_weight.
TEST(ParetoFront, TradesTheBaseCircleForJerk) {
    const Scene scene = pressure_angle_scene(15).with("cam.base_radius_mm = { min = 5, max = 60 }");
    FrontRequest request = request_of(DimensionIndex::base_radius, J);
    request.points = 6;
    const ParetoFront front = front_of(request, scene);
    const std::vector<FrontPoint> points = spaced(front);
    const double least_base = 0.02700587 - 0.01;  // the least prime radius of a cubic of 24 segments
    const auto smallest =
        std::ranges::min_element(front.points, {}, [](const FrontPoint& point) { return point.value[0]; });
    EXPECT_GE(smallest->value[0], least_base - 1e-8);
    EXPECT_LE(smallest->value[0], least_base * 1.01);
    EXPECT_NEAR(points.back().value[1], 32.0, 1e-5);
    EXPECT_TRUE(front.even);
}

TEST(ParetoFront, TracesRootMeanSquareByCaps) {
    Scene scene = cubic_12();
    scene.objective.reference = {};
    for (const FrontRequest& request :
         {request_of(V, FrontFigure::rms_jerk), request_of(FrontFigure::rms_jerk, V)}) {
        const ParetoFront front = front_of(request, scene);
        EXPECT_TRUE(front.even);
        const std::vector<FrontPoint> points = spaced(front);
        EXPECT_EQ(points.size(), 21U);
        for (const FrontPoint& point : points) {
            if (point.end != FrontEnd::none) continue;
            EXPECT_EQ(request.goals[point.minimized], FrontGoal(FrontFigure::rms_jerk));
        }
    }
}

TEST(ParetoFront, IsTheSameEveryTime) {
    const ParetoFront one = front_of(request_of(V, J), cubic_12());
    const ParetoFront other = front_of(request_of(V, J), cubic_12());
    ASSERT_EQ(one.points.size(), other.points.size());
    for (std::size_t i = 0; i < one.points.size(); ++i) {
        EXPECT_EQ(one.points[i].row.number, other.points[i].row.number);
        EXPECT_EQ(one.points[i].value, other.points[i].value);
        EXPECT_EQ(one.points[i].place, other.points[i].place);
    }
}

TEST(ParetoFront, AgreeingGoalsGiveOnePoint) {
    // y''' is one constant for four segments: nothing is free.
    const ParetoFront front = front_of(request_of(V, A), paper_objective(MotionType::drd, 3, 4));
    ASSERT_EQ(spaced(front).size(), 1U);
    EXPECT_NEAR(spaced(front).front().value[1], 8.0, 1e-7);
}

TEST(ParetoFront, AnInfeasibleSceneHasNone) {
    const ParetoFront front =
        pareto_front(scene_named("drd_cubic_12").with("limits.velocity = 0.9"), request_of(A, J));
    EXPECT_FALSE(front.complete);
    ASSERT_EQ(front.points.size(), 1U);
    EXPECT_EQ(front.points.front().row.verdict, Verdict::infeasible);
}

TEST(ParetoFront, StoppedItKeepsWhatIsFinished) {
    int solves = 0;
    const SolveControl control{[&] { return solves >= 6; }, {}};
    const ParetoFront front = pareto_front(
        cubic_12(), request_of(V, A), {.control = control, .row_done = [&](const auto&...) { ++solves; }});
    EXPECT_FALSE(front.complete);
    EXPECT_EQ(front.points.size(), 6U);
    EXPECT_GE(spaced(front).size(), 3U);
}

/// Also with other numbers of points: what is known is not solved again.
TEST(ParetoFront, ResumesWhereItStopped) {
    const Scene scene = cubic_12();
    const ParetoFront whole = front_of(request_of(V, A), scene);
    const std::vector<SweepRow> rows = front_table(whole).rows;
    std::vector<int> solved;
    RowRun run;
    run.found = [&](int row, const auto&...) { solved.push_back(row); };
    run.known.assign(rows.begin(), rows.begin() + 9);
    const ParetoFront rest = pareto_front(scene, request_of(V, A), run);
    EXPECT_TRUE(rest.complete && rest.even);
    EXPECT_EQ(solved.front(), 9);
    for (std::size_t k = 0; k < 9; ++k)
        EXPECT_EQ(front_table(rest).rows[k].objective, rows[k].objective) << k;
    solved.clear();
    run.known = rows;
    EXPECT_EQ(pareto_front(scene, request_of(V, A), run).points.size(), rows.size());
    EXPECT_TRUE(solved.empty());
}

/// --set with a row's settings is the scene that the row was solved for.
TEST(ParetoFront, SettingsOfRowsAreTheirScenes) {
    const TestScene named = scene_named("drd_cubic_12");
    const ParetoFront front = front_of(request_of(V, A), named);
    for (const SweepRow& row : front_table(front).rows) {
        TestScene posed = named;
        for (const std::string& setting : settings_of(front.columns.keys, row.settings))
            posed = posed.with(setting);
        EXPECT_NEAR(solve(posed).certificate.objective, *row.objective, 1e-8) << row.number;
    }
}

TEST(FrontGoal, NoWeightIsLeftOut) {
    Scene scene;
    ObjectiveSpec& objective = scene.objective;
    objective.velocity = objective.acceleration = objective.jerk = objective.torque = 2.0;
    objective.rms_acceleration = objective.rms_jerk = 2.0;
    objective.dimensions.fill(2.0);
    scale_weights(scene, 0.5);
    for (const double weight : {objective.velocity, objective.acceleration, objective.jerk, objective.torque,
                                objective.rms_acceleration, objective.rms_jerk, objective.dimensions[0],
                                objective.dimensions[dimension_count - 1]})
        EXPECT_EQ(weight, 1.0);
}

TEST(ParetoFront, RefusesWhatIsNoFront) {
    const Scene scene = cubic_12();
    const auto refused = [&](const FrontRequest& request) {
        EXPECT_THROW((void)pareto_front(scene, request), InputError);
    };
    refused(request_of(V, V));
    refused(request_of(FrontFigure::rms_jerk, FrontFigure::rms_acceleration));
    FrontRequest request = request_of(V, A);
    request.points = 1;
    refused(request);
    request = request_of(V, A);
    request.spacing = 0.0;
    refused(request);
    request = request_of(V, A);
    request.cut_off = 1.0;
    refused(request);
    request = request_of(V, FrontFigure::rms_jerk);
    request.keep_weights = true;
    refused(request);
    EXPECT_THROW((void)front_goal("base_radius", scene), InputError);
    EXPECT_THROW((void)front_goal("speed", scene), InputError);
}

}  // namespace pareto_front_test
}  // namespace camopt
