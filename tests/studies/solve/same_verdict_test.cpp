// SPDX-License-Identifier: MIT
// The same scene said in another way has the same answer: another design vector, all weights times a factor,
// time reversed. Random scenes, many of them with limits that leave no room.
#include "studies/search/planned_solve.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

namespace camopt {
namespace same_verdict_test {

using testing_support::normalised_limit;

class Dice {
 public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    double uniform(double from, double to) {
        return from + (to - from) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    int below(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
    bool one_in(int count) { return below(count) == 0; }

 private:
    std::mt19937 engine_;
};

std::vector<double> random_breakpoints(Dice& dice, int segments, double length) {
    std::vector<double> points = {0.0};
    for (int i = 0; i < segments; ++i)
        points.push_back(points.back() + std::pow(dice.uniform(0.1, 1.0), 2.0));
    for (double& point : points) point *= length / points.back();
    points.back() = length;
    return points;
}

/// Caps near what the scene can reach, below it, above it, and at round numbers.
void add_cap(Dice& dice, Scene& scene) {
    Scene least = scene;
    least.objective = {};
    least.limits = {};
    least.objective.reference = scene.objective.reference;
    const int which = dice.below(3);
    (which == 0   ? least.objective.velocity
     : which == 1 ? least.objective.acceleration
                  : least.objective.jerk) = 1.0;
    least.objective.tie_break = TieBreak::none;
    const Solution found = solve_without_explaining(least, {});
    if (!found.curve) return;
    const double peak = which == 0   ? found.peaks.velocity.value
                        : which == 1 ? found.peaks.acceleration.value
                                     : found.peaks.jerk.value;
    constexpr std::array<double, 7> factors = {1.0, 1.0 + 1e-6, 1.0 + 1e-10, 1.0 - 1e-10, 1.001, 1.1, 1.5};
    const double cap = peak * factors[static_cast<std::size_t>(dice.below(7))];
    constexpr std::array<const char*, 3> keys = {"limits.velocity", "limits.acceleration", "limits.jerk"};
    (which == 0   ? scene.limits.velocity
     : which == 1 ? scene.limits.acceleration
                  : scene.limits.jerk) = normalised_limit(keys[static_cast<std::size_t>(which)], cap);
}

Scene random_scene(unsigned seed) {
    Dice dice(seed);
    Scene scene;
    scene.motion.type = dice.one_in(3) ? MotionType::rr : MotionType::drd;
    const double length = scene.motion.length();
    scene.spline.degree = dice.one_in(2) ? 3 : 5;
    scene.spline.segments =
        (scene.motion.type == MotionType::rr ? 6 : 4) + dice.below(dice.one_in(4) ? 36 : 12);
    if (dice.one_in(3)) scene.spline.breakpoints = random_breakpoints(dice, scene.spline.segments, length);
    if (scene.spline.breakpoints.empty() && dice.one_in(5)) scene.motion.symmetric = true;
    const auto weight = [&] { return dice.one_in(3) ? 0.0 : dice.uniform(0.05, 1.0); };
    scene.objective.velocity = weight();
    scene.objective.acceleration = weight();
    scene.objective.jerk = weight();
    if (dice.one_in(5)) scene.objective.rms_jerk = dice.uniform(0.1, 3.0);
    if (dice.one_in(6)) scene.objective.rms_acceleration = dice.uniform(0.1, 3.0);
    const ObjectiveSpec& objective = scene.objective;
    if (objective.velocity + objective.acceleration + objective.jerk + objective.rms_jerk +
            objective.rms_acceleration ==
        0.0)
        scene.objective.jerk = 1.0;
    if (dice.one_in(4)) {
        const double at = dice.uniform(0.2, 0.8) * std::min(1.0, length);
        scene.motion.via = {{at, dice.uniform(0.3, 1.2) * at, {}, {}}};
    }
    if (dice.one_in(8)) scene.motion.via.push_back({0.5, {}, dice.uniform(0.8, 2.0), {}});
    if (dice.one_in(10) && scene.spline.degree == 5) scene.spline.rest = 3;
    scene.spline.design = DesignKind::states;
    while (dice.one_in(2)) add_cap(dice, scene);
    return scene;
}

/// What two solves of the same thing say of each other; empty where they agree.
/// Where double precision ends: which of its ways to end shows first is rounding.
bool is_beyond_doubles(const Certificate& certificate) {
    return certificate.reason == "numerical_failure" || certificate.reason == "breakpoints_too_close";
}

std::string disagreement(const Solution& one, const Solution& other, double factor) {
    const Certificate &left = one.certificate, &right = other.certificate;
    const std::string verdicts = std::string(name_of(left.verdict)) + " " + name_of(left.reason) + ", " +
                                 name_of(right.verdict) + " " + name_of(right.reason);
    if (is_beyond_doubles(left) && is_beyond_doubles(right)) return {};
    if (has_feasible_motion(left.verdict) != has_feasible_motion(right.verdict))
        return verdicts + (one.notes.empty() ? "" : "; " + one.notes.back()) +
               (other.notes.empty() ? "" : "; " + other.notes.back());
    if (left.verdict != Verdict::optimal || right.verdict != Verdict::optimal) return {};
    const double size = std::max(1.0, std::abs(left.objective));
    const double difference = std::abs(left.objective - right.objective / factor);
    // Either may use its tolerance and its gap; limits without room make much of little.
    if (difference > 1e-6 * size)
        return verdicts + ": " + std::to_string(left.objective) + " and " +
               std::to_string(right.objective / factor);
    return {};
}

void expect_sound(const Solution& solution, unsigned seed) {
    const Certificate& certificate = solution.certificate;
    if (!certificate.lower_bound) return;
    EXPECT_FALSE(bound_passes(certificate.objective, *certificate.lower_bound, 1e-9))
        << "seed " << seed << ": bound " << *certificate.lower_bound << " above " << certificate.objective;
}

Scene reversed(Scene scene) {
    const double length = scene.motion.length();
    const bool rise = scene.motion.type == MotionType::drd;
    for (SetPoint& via : scene.motion.via) {
        via.at = length - via.at;
        if (rise && via.displacement) via.displacement = 1.0 - *via.displacement;
        if (!rise && via.velocity) via.velocity = -*via.velocity;
        if (rise && via.acceleration) via.acceleration = -*via.acceleration;
    }
    std::ranges::reverse(scene.spline.breakpoints);
    for (double& point : scene.spline.breakpoints) point = length - point;
    if (!scene.spline.breakpoints.empty()) scene.spline.breakpoints.front() = 0.0;
    return scene;
}

unsigned trials(unsigned usual) {  // more by hand
    const char* more = std::getenv("CAMOPT_SAME_VERDICT_TRIALS");
    return more ? static_cast<unsigned>(std::atoi(more)) : usual;
}

// Its limits leave no room where doubles end: every backend is tried in turn, which takes seconds.
constexpr unsigned where_doubles_end = 10;

void expect_same_for_every_design_vector(unsigned seed) {
    Scene scene = random_scene(seed);
    const Solution states = solve_without_explaining(scene, {});
    expect_sound(states, seed);
    for (const DesignKind kind : {DesignKind::coefficients, DesignKind::ordinates}) {
        scene.spline.design = kind;
        const Solution other = solve_without_explaining(scene, {});
        expect_sound(other, seed);
        EXPECT_EQ(disagreement(states, other, 1.0), "") << "seed " << seed << ' ' << name_of(kind);
    }
}

void expect_same_for_weights_times_a_factor(unsigned seed) {
    const Scene scene = random_scene(seed);
    const Solution plain = solve_without_explaining(scene, {});
    for (const double factor : {1e-3, 7.0, 1e5}) {
        Scene other = scene;
        for (double* weight :
             {&other.objective.velocity, &other.objective.acceleration, &other.objective.jerk,
              &other.objective.rms_jerk, &other.objective.rms_acceleration})
            *weight *= factor;
        EXPECT_EQ(disagreement(plain, solve_without_explaining(other, {}), factor), "")
            << "seed " << seed << " factor " << factor;
    }
}

void expect_same_for_time_reversed(unsigned seed) {
    const Scene scene = random_scene(seed);
    const Solution forward = solve_without_explaining(scene, {});
    EXPECT_EQ(disagreement(forward, solve_without_explaining(reversed(scene), {}), 1.0), "")
        << "seed " << seed;
}

void for_usual_seeds(void (*expect)(unsigned seed)) {
    for (unsigned seed = 1; seed <= trials(25); ++seed)
        if (seed != where_doubles_end) expect(seed);
}

TEST(SameVerdict, ForEveryDesignVector) {
    for_usual_seeds(expect_same_for_every_design_vector);
}

TEST(SameVerdict, ForWeightsTimesAFactor) {
    for_usual_seeds(expect_same_for_weights_times_a_factor);
}

TEST(SameVerdict, ForTimeReversed) {
    for_usual_seeds(expect_same_for_time_reversed);
}

TEST(SameVerdict, WhereDoublesEnd) {
    expect_same_for_every_design_vector(where_doubles_end);
    expect_same_for_weights_times_a_factor(where_doubles_end);
    expect_same_for_time_reversed(where_doubles_end);
}

}  // namespace same_verdict_test
}  // namespace camopt
