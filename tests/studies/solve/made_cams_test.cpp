// SPDX-License-Identifier: MIT
// Cams drawn at random from the tolerances of one scene of every kind: none passes a limit, and without the
// tolerances more than one in a hundred does. Some by all figures of the cam, 100,000 by the rules of the
// limits where these are near their limits.
#include "objectives/rules/made_cams.hpp"

#include "objectives/rules/cam_limits.hpp"
#include "objectives/rules/maxima/rule_maxima.hpp"
#include "scene/limit_table.hpp"
#include "studies/delivered/cam_report.hpp"
#include "studies/delivered/scene_limits.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <future>
#include <random>

namespace camopt {
namespace made_cams_test {

using namespace testing_support;

/// A motion with errors in s, s', s'' that are the same everywhere, SI.
class OffMotion final : public Motion {
 public:
    OffMotion(const Motion& drawn, const std::array<double, 3>& errors, const MotionScale& scale)
        : drawn_(drawn), errors_(errors), scale_(scale) {}
    [[nodiscard]] double begin() const override { return drawn_.begin(); }
    [[nodiscard]] double end() const override { return drawn_.end(); }
    [[nodiscard]] std::vector<double> breakpoints() const override { return drawn_.breakpoints(); }
    [[nodiscard]] MotionPoint at(double x, Side side) const override {
        MotionPoint point = drawn_.at(x, side);
        double unit = scale_.lift;
        for (std::size_t order = 0; order < errors_.size(); ++order, unit /= scale_.unit_angle)
            point.derivative[order] += errors_[order] / unit;
        return point;
    }

 private:
    const Motion& drawn_;
    std::array<double, 3> errors_;
    MotionScale scale_;
};

/// The worst violation of the scene's limits, relative to them, by cams drawn at random from the tolerances
/// and by those at their ends.
double worst_of_made_cams(const Solution& solution, const ToleranceSpec& tolerance, int cams) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    const Scene& scene = solution.scene;
    const MotionScale scale{scene.motion.lift, scene.motion.unit_angle()};
    double worst = -infinity;
    for (int cam = 0; cam < cams; ++cam) {
        const auto part = [&] {  // every other cam at the ends
            const double at = anywhere(random);
            return cam % 2 == 0 ? at : std::copysign(1.0, at);
        };
        std::array<double, 3> errors{};
        for (std::size_t order = 0; order < errors.size(); ++order)
            errors[order] = part() * tolerance.of_motion(order);
        CamReport made;
        made.cam = solution.cam->cam;
        for (const auto& [name, one] : tolerance.numbers)
            made.cam.dimensions.at(static_cast<std::size_t>(scene.cam->written_as(name))) +=
                part() * one.size;
        made.summary = cam_summary(made.cam, OffMotion(*solution.motion, errors, scale), scene);
        for (ConstraintReport one : cam_constraints(scene, made)) {
            one.made.reset();
            worst = std::max(worst, limit_excess(one) / std::max(1.0, std::abs(one.limit)));
        }
    }
    return worst;
}

/// Of a profile of 20 µm (or 20 parts in a million of a turn of the output), and of the first two fixed
/// lengths of the cam, a thousandth.
ToleranceSpec ordinary_tolerance(const Scene& scene) {
    ToleranceSpec tolerance;
    const double size = scene.motion.lift_is_angle ? 1e-4 : 20e-6;
    tolerance.motion = {size, 5.0 * size, 20.0 * size};
    for (const CamDimension& dimension : scene.cam->dimensions) {
        const bool fixed = !dimension.value.is_variable() && dimension.value.low != 0.0;
        if (fixed && !dimension.is_angle && !dimension.value.key.empty() && tolerance.numbers.size() < 2)
            tolerance.numbers[written_name(dimension.value)] = {1e-3 * std::abs(dimension.value.low)};
    }
    return tolerance;
}

constexpr int made_cams = 100000, threads = 2;
constexpr std::size_t most_places = 32;  // those nearest to a limit
constexpr double passed = 1e-8;          // of a limit: figure_rounding of the audit

/// A profile error: a cubic B-spline over the motion whose coefficients keep it and its derivatives within
/// the errors everywhere, by x and in lifts.
class ErrorSpline {
 public:
    ErrorSpline(std::mt19937& random, const std::array<double, 3>& errors, const Motion& motion, bool largest)
        : begin_(motion.begin()) {
        const int pieces = std::uniform_int_distribution(1, 60)(random);
        width_ = (motion.end() - motion.begin()) / pieces;
        std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
        for (int k = 0; k < pieces + 3; ++k)
            points_.push_back(largest ? std::copysign(1.0, anywhere(random)) : anywhere(random));
        // A derivative of a B-spline lies between the differences of its coefficients.
        double beyond = 0.0, unit = 1.0;
        std::vector<double> differences = points_;
        for (const double error : errors) {
            double most = 0.0;
            for (const double one : differences) most = std::max(most, std::abs(one) / unit);
            beyond = std::max(beyond, most / error);
            for (std::size_t k = 0; k + 1 < differences.size(); ++k)
                differences[k] = differences[k + 1] - differences[k];
            differences.pop_back();
            unit *= width_;
        }
        const double size = largest ? 1.0 : std::abs(anywhere(random));
        for (double& point : points_) point *= size / beyond;
    }
    /// δ, δ', δ''
    [[nodiscard]] std::array<double, 3> at(double x) const {
        const auto pieces = static_cast<double>(points_.size() - 3);
        const double place = std::clamp((x - begin_) / width_, 0.0, pieces);
        const auto piece = static_cast<std::size_t>(std::min(std::floor(place), pieces - 1.0));
        const double t = place - static_cast<double>(piece), u = 1.0 - t;
        const std::array<std::array<double, 4>, 3> basis = {
            {{u * u * u / 6.0, (3.0 * t * t * t - 6.0 * t * t + 4.0) / 6.0,
              (-3.0 * t * t * t + 3.0 * t * t + 3.0 * t + 1.0) / 6.0, t * t * t / 6.0},
             {-0.5 * u * u, 1.5 * t * t - 2.0 * t, -1.5 * t * t + t + 0.5, 0.5 * t * t},
             {u, 3.0 * t - 2.0, 1.0 - 3.0 * t, t}}};
        std::array<double, 3> error{};
        double unit = 1.0;
        for (std::size_t order = 0; order < 3; ++order, unit *= width_)
            for (std::size_t k = 0; k < 4; ++k) error[order] += basis[order][k] * points_[piece + k] / unit;
        return error;
    }

 private:
    double begin_ = 0.0, width_ = 1.0;
    std::vector<double> points_;
};

/// A rule at one place of the motion: made cams there are what it is at other states and numbers.
struct RuleAt {
    std::shared_ptr<const CamRule> rule;
    MotionPoint point;
    double worst = 0.0;  ///< of the cams at the ends of the tolerances

    [[nodiscard]] double value(const std::array<double, 3>& error, const Eigen::VectorXd& parts) const {
        MotionPoint made = point;
        for (std::size_t order = 0; order < error.size(); ++order) made.derivative[order] += error[order];
        return rule->evaluate(made, parts).value / rule->scale();
    }
};

class Trials {
 public:
    Trials(const Solution& solution, const ToleranceSpec& tolerance)
        : scene_(solution.scene), motion_(*solution.motion) {
        scene_.tolerance = tolerance;
        for (int order = 0; order < 3; ++order)
            errors_[static_cast<std::size_t>(order)] = scene_.motion_error(order);
        CamVariables drawn;
        drawn.cam = solution.cam->cam;
        drawn.scale = {scene_.motion.lift, scene_.motion.unit_angle()};
        FreeCam free = with_free_numbers(scene_, drawn);
        numbers_ = static_cast<Eigen::Index>(free.places.size());
        for (const double slope : {1.0, -1.0}) {
            // What holds at rest has the slope of the made cam in place of the motion's.
            free.variables.motion_error[1] = slope * tolerance.of_motion(1);
            for (const auto& rule : cam_limits(free.scene, free.variables))
                if (rule->highest_order() == 0) add(rule);
        }
        free.variables.motion_error[1] = 0.0;
        for (const auto& rule : cam_limits(free.scene, free.variables))
            if (rule->highest_order() > 0) add(rule);
        std::ranges::stable_sort(near_, std::greater(), &RuleAt::worst);
        if (near_.size() > most_places) near_.resize(most_places);
    }
    [[nodiscard]] std::size_t places() const { return near_.size(); }

    struct Outcome {
        double worst = -infinity;
        int passing = 0;
    };
    [[nodiscard]] Outcome run() const {
        std::vector<std::future<Outcome>> parts;
        for (int thread = 0; thread < threads; ++thread)
            parts.push_back(std::async(std::launch::async, [this, thread] { return run_part(thread); }));
        Outcome all;
        for (auto& part : parts) {
            const Outcome one = part.get();
            all.worst = std::max(all.worst, one.worst);
            all.passing += one.passing;
        }
        return all;
    }

 private:
    Scene scene_;
    const Motion& motion_;
    std::array<double, 3> errors_{};  ///< in lifts, by x
    Eigen::Index numbers_ = 0;
    std::vector<RuleAt> near_;

    /// Where a made cam comes near the limit: on a fine grid, at breakpoints and at the maxima of the rule.
    void add(const std::shared_ptr<const CamRule>& rule) {
        std::vector<std::pair<double, Side>> places;
        for (const double x : rule->places()) places.emplace_back(x, Side::right);
        if (rule->places().empty()) {
            for (const double x : even_places(motion_.breakpoints(), 600))
                for (const Side side : {Side::left, Side::right}) places.emplace_back(x, side);
            for (double end : {-1.0, 0.0, 1.0})
                for (const Extremum& one :
                     rule_maxima(*rule, motion_, Eigen::VectorXd::Constant(numbers_, end)))
                    places.emplace_back(one.at, one.side);
        }
        const auto [from, until] = rule->holds_between();
        for (const auto& [x, side] : places) {
            if (x < from || x > until) continue;
            RuleAt one{rule, motion_.at(x, side)};
            double least = infinity, most = -infinity;
            for (unsigned ends = 0; ends < (1U << static_cast<unsigned>(3 + numbers_)); ++ends) {
                const auto end = [&](Eigen::Index k) { return ((ends >> k) & 1) != 0 ? -1.0 : 1.0; };
                Eigen::VectorXd parts(numbers_);
                for (Eigen::Index k = 0; k < numbers_; ++k) parts[k] = end(3 + k);
                const double value =
                    one.value({end(0) * errors_[0], end(1) * errors_[1], end(2) * errors_[2]}, parts);
                least = std::min(least, value);
                most = std::max(most, value);
            }
            // A made cam between the ends may exceed them by little.
            one.worst = most;
            if (most > -0.1 * (most - least)) near_.push_back(one);
        }
    }

    [[nodiscard]] Outcome run_part(int thread) const {
        std::mt19937 random(static_cast<unsigned>(1 + thread));
        std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
        Outcome outcome;
        for (int cam = thread; cam < made_cams; cam += threads) {
            const bool ends = cam / threads % 2 == 0, spline = cam / threads % 4 < 2;
            const auto part = [&] {
                const double at = anywhere(random);
                return ends ? std::copysign(1.0, at) : at;
            };
            Eigen::VectorXd parts(numbers_);
            for (double& one : parts) one = part();
            const ErrorSpline error(random, errors_, motion_, ends);
            double worst = -infinity;
            for (const RuleAt& one : near_)
                worst =
                    std::max(worst, one.value(spline ? error.at(one.point.x)
                                                     : std::array{part() * errors_[0], part() * errors_[1],
                                                                  part() * errors_[2]},
                                              parts));
            outcome.worst = std::max(outcome.worst, worst);
            if (worst > passed) ++outcome.passing;
        }
        return outcome;
    }
};

class MadeCams : public testing::TestWithParam<const char*> {};

TEST_P(MadeCams, KeepLimitsThatDrawnOnesPass) {
    Scene scene = scene_named(GetParam());
    const ToleranceSpec tolerance = ordinary_tolerance(scene);
    constexpr int cams = 300;
    const Solution drawn = solve(scene);
    EXPECT_GT(worst_of_made_cams(drawn, tolerance, cams), 1e-5);
    const Trials::Outcome without = Trials(drawn, tolerance).run();
    EXPECT_GT(without.passing, made_cams / 100);
    EXPECT_GT(without.worst, 1e-5);
    scene.tolerance = tolerance;
    const Solution solution = solve(scene);
    ASSERT_TRUE(solution.motion) << name_of(solution.certificate.verdict) << ": "
                                 << name_of(solution.certificate.reason);
    EXPECT_LE(worst_of_made_cams(solution, tolerance, cams), 1e-6);
    const Trials trials(solution, tolerance);
    EXPECT_GT(trials.places(), 0U);
    const Trials::Outcome with = trials.run();
    EXPECT_EQ(with.passing, 0) << with.worst;
    std::cout << GetParam() << ": of " << made_cams << " cams " << without.passing
              << " pass a limit without tolerances, by " << without.worst << ", with them " << with.passing
              << ", at most " << with.worst << " (" << trials.places() << " places)\n";
}

/// Tolerances of size 0.
TEST_P(MadeCams, WithoutErrorsEqualDrawnOnes) {
    Scene scene = scene_named(GetParam());
    const Solution drawn = solve_without_explaining(scene, {});
    ToleranceSpec none = ordinary_tolerance(scene);
    none.motion = {0.0, 0.0, 0.0};
    for (auto& [name, one] : none.numbers) one.size = 0.0;
    scene.tolerance = none;
    const Solution solution = solve_without_explaining(scene, {});
    EXPECT_EQ(solution.certificate.objective, drawn.certificate.objective);
    EXPECT_EQ(solution.design.values, drawn.design.values);
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, MadeCams,
                         testing::Values("cam_roller", "cam_knife", "cam_flat", "cam_smallest",
                                         "cam_arm_flat", "cam_conjugate", "cam_forces", "linear_press",
                                         "linear_arm", "barrel_paper_cup", "cylinder_slide",
                                         "inverse_feeder"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace made_cams_test
}  // namespace camopt
