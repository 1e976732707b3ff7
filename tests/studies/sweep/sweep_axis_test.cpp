// SPDX-License-Identifier: MIT
// What varies in a sweep: lattice weights, weight files, --vary.
#include "studies/sweep/sweep_axis.hpp"

#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace camopt {
namespace sweep_axis_test {

using testing_support::refusal;

std::vector<double> point(const SweepAxis& axis, int index) {
    const auto values = axis.point(index);
    return {values.begin(), values.end()};
}

TEST(SimplexWeights, AreAllLatticePointsOnce) {
    for (const int n : {1, 2, 3, 7, 20, 139}) {
        SCOPED_TRACE(n);
        const SweepAxis axis = simplex_weights(n);
        EXPECT_EQ(axis.points(), (n + 1) * (n + 2) / 2);
        std::set<std::vector<long>> seen;
        for (int i = 0; i < axis.points(); ++i) {
            std::vector<long> lattice;
            for (const double weight : axis.point(i)) {
                EXPECT_GE(weight, 0.0);
                EXPECT_NEAR(weight * n, std::round(weight * n), 1e-9);
                lattice.push_back(std::lround(weight * n));
            }
            EXPECT_EQ(lattice[0] + lattice[1] + lattice[2], n);
            EXPECT_TRUE(seen.insert(lattice).second) << "point " << i << " stands there twice";
        }
    }
}

TEST(SimplexWeights, StepMovesUnitBetweenWeights) {
    const int n = 20;
    const SweepAxis axis = simplex_weights(n);
    for (int i = 1; i < axis.points(); ++i) {
        std::vector<long> moves;
        for (std::size_t k = 0; k < 3; ++k)
            moves.push_back(std::lround(n * (axis.point(i)[k] - axis.point(i - 1)[k])));
        std::ranges::sort(moves);
        EXPECT_EQ(moves, (std::vector<long>{-1, 0, 1})) << "before point " << i;
    }
}

TEST(SimplexWeights, RefuseWhatIsNoLattice) {
    for (const int n : {-3, 0, 1413, 2'000'000'000})
        EXPECT_NE(refusal([&] { (void)simplex_weights(n); }).find("allowed: at least 1"), std::string::npos)
            << n;
    EXPECT_EQ(simplex_weights(1412).points(), 1413 * 1414 / 2);
}

TEST(WeightFile, ReadsNamesAndPoints) {
    const SweepAxis axis = weights_of_csv(
        "\xEF\xBB\xBF# from the workshop\r\n\r\nvelocity, objective.jerk,base_radius\r\n0.5,0.25,0.25\r\n"
        "1e-3,1,0\r\n",
        "w.csv");
    EXPECT_EQ(axis.keys,
              (std::vector<std::string>{"objective.velocity", "objective.jerk", "objective.base_radius"}));
    ASSERT_EQ(axis.points(), 2);
    EXPECT_EQ(point(axis, 0), (std::vector{0.5, 0.25, 0.25}));
    EXPECT_EQ(point(axis, 1), (std::vector{1e-3, 1.0, 0.0}));
}

TEST(WeightFile, ErrorsNameLineAndAllowedValues) {
    struct Case {
        const char *text, *words;
    };
    const std::vector<Case> cases = {
        {"", "w.csv:1: found no line; allowed"},
        {"velocity\n", "found no line of weights"},
        {"speed,jerk\n1,2\n", "w.csv:1: found \"speed\"; allowed: names of weights: velocity, acceleration"},
        {"jerk,jerk\n1,2\n", "w.csv:1: found \"jerk\" twice"},
        {"velocity,jerk\n1,2\n3\n", "w.csv:3: found 1 value(s); allowed: 2"},
        {"velocity,jerk\n\n1,two\n", "w.csv:3: found \"two\"; allowed: a number >= 0"},
        {"velocity\n-1\n", "w.csv:2: found \"-1\""},
        {"velocity\nnan\n", "w.csv:2: found \"nan\""},
        {"velocity\ninf\n", "w.csv:2: found \"inf\""},
        {"velocity\n1e999\n", "w.csv:2: found \"1e999\""},
        {"velocity,jerk\n1,\n", "w.csv:2: found \"\""},
    };
    for (const Case& one : cases)
        EXPECT_NE(refusal([&] { (void)weights_of_csv(one.text, "w.csv"); }).find(one.words),
                  std::string::npos)
            << one.words << "\nsaid: " << refusal([&] { (void)weights_of_csv(one.text, "w.csv"); });
}

TEST(VariedKey, SpacesEvenlyGeometricallyOrAsListed) {
    EXPECT_EQ(varied_key("cam.base_radius_mm=30:60:4").keys, std::vector<std::string>{"cam.base_radius_mm"});
    EXPECT_EQ(varied_key("a.b=30:60:4").values, (std::vector{30.0, 40.0, 50.0, 60.0}));
    EXPECT_EQ(varied_key("a.b=0.1:0.5:5").values, (std::vector{0.1, 0.2, 0.3, 0.4, 0.5}));
    EXPECT_EQ(varied_key("a.b=5:-5:3").values, (std::vector{5.0, 0.0, -5.0}));
    EXPECT_EQ(varied_key("spline.segments=4:64:5:log").values, (std::vector{4.0, 8.0, 16.0, 32.0, 64.0}));
    EXPECT_EQ(varied_key("a.b=1e-6:1:4:log").values, (std::vector{1e-6, 1e-4, 1e-2, 1.0}));
    EXPECT_EQ(varied_key(" a.b = 7, 3 ,5").values, (std::vector{7.0, 3.0, 5.0}));
    EXPECT_EQ(varied_key("a.b=7").values, (std::vector{7.0}));
    EXPECT_EQ(varied_key("a.b=0:1:10000").points(), 10000);
}

TEST(VariedKey, RefusesInvalidRangesAndLists) {
    struct Case {
        const char *text, *words;
    };
    const std::vector<Case> cases = {
        {"a.b", "found no KEY=; allowed: KEY=a:b:count"},
        {"=1,2", "found no KEY="},
        {"a.b=", "found \"\"; allowed: a number"},
        {"a.b=1:2", "found \"1:2\"; allowed: KEY=a:b:count"},
        {"a.b=1:2:3:linear", "found \"1:2:3:linear\""},
        {"a.b=1:2:3:log:x", "found \"1:2:3:log:x\""},
        {"a.b=1:2:1", "found the count \"1\"; allowed: an integer from 2"},
        {"a.b=1:2:2.5", "found the count \"2.5\""},
        {"a.b=1:2:1000001", "found the count \"1000001\""},
        {"a.b=1:1:5", "found 1 at both ends"},
        {"a.b=0:1:5:log", "found 0 to 1 by equal factors; allowed: both ends > 0"},
        {"a.b=one:2:3", "found \"one\"; allowed: a number"},
        {"a.b=1,2,1", "found 1 twice"},
        {"a.b=true,false", "found \"true\""},
    };
    for (const Case& one : cases)
        EXPECT_NE(refusal([&] { (void)varied_key(one.text); }).find(one.words), std::string::npos)
            << one.words << "\nsaid: " << refusal([&] { (void)varied_key(one.text); });
}

TEST(WeightKey, ContainsOnlyObjectiveWeights) {
    for (const char* key : {"objective.velocity", "objective.torque", "objective.rms_jerk",
                            "objective.base_radius", "objective.face_offset"})
        EXPECT_TRUE(is_weight_key(key)) << key;
    for (const char* key : {"velocity", "objective.reference.velocity", "objective.tie_break",
                            "limits.velocity", "cam.base_radius_mm", "objective."})
        EXPECT_FALSE(is_weight_key(key)) << key;
}

}  // namespace sweep_axis_test
}  // namespace camopt
