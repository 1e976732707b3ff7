// SPDX-License-Identifier: MIT
// Maxima of the rules of cams between samples: peaks far narrower than a spline's piece, and enclosures that
// hold what the formulas give.
#include "objectives/rules/maxima/rule_maxima.hpp"

#include "core/numbers/enclosures.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "objectives/grid/cam_problem.hpp"
#include "objectives/rules/cam_limits.hpp"
#include "objectives/scene_model.hpp"
#include "profiles/disk/disk_cam.hpp"
#include "tests/support/middle_cam.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {
namespace rule_maxima_test {

using enum DimensionIndex;

constexpr int dense_points = 4000;

/// A cam much too small for its lift, on few pieces: its curvature has narrow peaks.
Scene small_cam(FollowerType follower, Rotation rotation) {
    Scene scene;
    const bool swings = is_oscillating(follower);
    scene.motion.type = MotionType::rr;
    scene.motion.lift_is_angle = swings;
    scene.motion.lift = swings ? 0.5 : 0.03;
    scene.motion.rise = 60.0 * units::degree;
    scene.motion.speed = 40.0;
    scene.spline.segments = 6;
    DiskSpec cam;
    cam.follower = follower;
    cam.rotation = rotation;
    cam[base_radius] = swings ? 0.03 : 0.006;
    if (has_roller(follower)) cam[roller_radius] = 0.004;
    if (swings) cam[center_distance] = 0.06;
    if (follower == FollowerType::oscillating_roller) cam[arm_length] = 0.055;
    if (follower == FollowerType::oscillating_flat) cam[face_offset] = 0.004;
    scene.cam = disk_spec(cam);
    LimitSpec& limits = scene.limits;
    limits.pressure_angle = {35.0 * units::degree, "limits.pressure_angle_deg", units::degree, "deg"};
    limits.cam_radius_min = {1e-3, "limits.cam_radius_min_mm", 1e-3, "mm"};
    limits.undercut_margin = {0.1, "limits.undercut_margin", 1.0, ""};
    ForceSpec& forces = scene.forces.emplace();
    forces.mass = swings ? 1e-3 : 1.0;
    forces.preload = swings ? 5.0 : 800.0;
    forces.spring_rate = swings ? 10.0 : 20000.0;
    forces.contact_width = 0.01;
    limits.torque_max = {20.0, "limits.torque_max_nm", 1.0, "N m"};
    if (follower != FollowerType::translating_knife)
        limits.hertz_pressure_max = {8e8, "limits.hertz_pressure_max_mpa", 1e6, "MPa"};
    return scene;
}

constexpr std::array followers = {FollowerType::translating_roller, FollowerType::translating_knife,
                                  FollowerType::translating_flat, FollowerType::oscillating_roller,
                                  FollowerType::oscillating_flat};

TEST(RuleMaxima, OfNarrowPeaksAreNotMissed) {
    int looked = 0, missed = 0;
    for (const FollowerType follower : followers) {
        for (const Rotation rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
            const Scene scene = small_cam(follower, rotation);
            const CamProblem problem(scene_model(scene, DesignKind::coefficients, reference_peaks(scene)));
            for (unsigned seed = 1; seed <= 3; ++seed) {
                const Eigen::VectorXd x = problem.random_start(seed);
                const MotionChain motion = problem.motion(x);
                for (const PlacedRule& rule : problem.model().rules) {
                    if (!rule->limit()) continue;
                    const Eigen::VectorXd q;
                    const double found =
                        largest_of(rule_maxima(rule, problem.model().design, motion, q)).value;
                    double dense = -infinity;
                    for (int k = 0; k < dense_points; ++k) {
                        const double at = motion.end() * (k + 0.5) / dense_points;
                        dense = std::max(dense, rule->evaluate(motion.at(at), q).value);
                    }
                    ++looked;
                    // A face that turns back makes its figures infinite; that rule is broken itself.
                    if (std::abs(dense) > 1e6 * rule->scale()) continue;
                    if (found < dense - 1e-9 * std::max(1.0, std::abs(dense))) ++missed;
                }
            }
        }
    }
    EXPECT_GT(looked, 150);
    EXPECT_EQ(missed, 0);
}

/// Every value, slope and second derivative inside a stretch lies in what encloses it.
TEST(RuleMaxima, EncloseTheFormulasOfEveryFollower) {
    for (const FollowerType follower : followers) {
        const Scene scene = small_cam(follower, Rotation::clockwise);
        auto variables = std::make_shared<CamVariables>();
        variables->cam = disk_mechanism(middle_cam(disk_of(*scene.cam)));
        variables->scale = {scene.motion.lift, scene.motion.unit_angle()};
        // y = 0.3 + 0.5 x − 0.7 x² + 0.4 x³ on a stretch about 0.2.
        const auto derivatives = [](double x) {
            return std::array<double, 5>{0.3 + 0.5 * x - 0.7 * x * x + 0.4 * x * x * x,
                                         0.5 - 1.4 * x + 1.2 * x * x, -1.4 + 2.4 * x, 2.4, 0.0};
        };
        const double half = 1e-3;
        std::array<Interval, 5> over;
        for (std::size_t r = 0; r < 5; ++r) {
            const double a = derivatives(0.2 - half)[r], b = derivatives(0.2 + half)[r];
            over[r] = {std::min(a, b), std::max(a, b)};
        }
        for (const auto& rule : cam_limits(scene, *variables)) {
            const auto range = rule->range_along({0.2 - half, 0.2 + half}, over, {});
            ASSERT_TRUE(range);
            const auto value = [&](double x) {
                const auto y = derivatives(x);
                return rule->evaluate({x, {y[0], y[1], y[2], y[3]}}, {}).value;
            };
            constexpr double step = 2e-4;
            for (const double x : {0.2 - half + step, 0.2, 0.2 + half - step}) {
                const double slope = (value(x + step) - value(x - step)) / (2.0 * step);
                const double bend = (value(x + step) - 2.0 * value(x) + value(x - step)) / (step * step);
                EXPECT_TRUE(range->value.holds(value(x))) << rule->name();
                const double rough = 1e-4 * (1.0 + std::abs(slope) + std::abs(bend));
                EXPECT_LE(range->slope.lower - rough, slope) << rule->name();
                EXPECT_GE(range->slope.upper + rough, slope) << rule->name();
                EXPECT_LE(range->bend.lower - rough, bend) << rule->name();
                EXPECT_GE(range->bend.upper + rough, bend) << rule->name();
            }
        }
    }
}

TEST(Intervals, ContainTheirRealValues) {
    EXPECT_TRUE((Interval(-1.0, 2.0) * Interval(-3.0, 1.0)).holds(-6.0));
    EXPECT_TRUE((Interval(-1.0, 2.0) * Interval(-3.0, 1.0)).holds(3.0));
    EXPECT_TRUE(std::isinf((Interval(1.0) / Interval(-1.0, 1.0)).upper));
    EXPECT_EQ(cos(Interval(-0.1, 0.1)).upper, 1.0);
    EXPECT_LT(cos(Interval(-0.1, 0.1)).lower, std::cos(0.1));
    EXPECT_EQ(cos(Interval(3.0, 3.3)).lower, -1.0);
    EXPECT_EQ(sin(Interval(1.5, 1.6)).upper, 1.0);
    EXPECT_TRUE(sin(Interval(7.0)).holds(std::sin(7.0)));
    EXPECT_EQ(square(Interval(-2.0, 1.0)).lower, 0.0);
    EXPECT_TRUE(std::isinf(sqrt(Interval(-1.0, 1.0)).upper));
    // A third is no double: its enclosure is wider than a point, and holds thrice itself's inverse.
    const Interval third = Interval(1.0) / Interval(3.0);
    EXPECT_LT(third.lower, third.upper);
    EXPECT_TRUE((third * Interval(3.0)).holds(1.0));
}

/// y up to a half; no value beyond it, as of an arm that does not reach.
class OutOfReach final : public PointRule {
 public:
    explicit OutOfReach(double beyond) : PointRule({"out of reach"}), beyond_(beyond) {}
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd&) const override {
        RuleValue value{-1.0, Eigen::VectorXd::Zero(4), Eigen::MatrixXd::Zero(4, 4)};
        if (point.derivative[0] > beyond_) value.value = std::nan("");
        return value;
    }

 private:
    double beyond_;
};

/// y'' falls to 0.01, rises to a low top at 0.05, and falls: a cubic through samples sees none of it.
TEST(RuleMaxima, OfLinearRulesAreExact) {
    Eigen::MatrixXd piece = Eigen::MatrixXd::Zero(6, 1);
    piece(3, 0) = -0.0005 / 6.0;
    piece(4, 0) = 0.03 / 12.0;
    piece(5, 0) = -1.0 / 60.0;
    const auto curve = std::make_shared<const SplineCurve>(SplineSpace(5, 3, {0.0, 1.0}), piece);
    for (const auto& [width, height] : {std::array{1.0, 1.0}, std::array{2.0, 3.0}}) {
        const MotionChain motion({{0.5, 0.5 + width, curve, 0.5, width, 0.2, height}});
        LinearBound bound{"limits.acceleration", 2};
        const MaximaAlong found = maxima_along(LinearRule(bound), motion, {});
        const Extremum top = largest_of(found.maxima);
        EXPECT_TRUE(found.complete);
        EXPECT_NEAR(top.at, 0.5 + 0.05 * width, 1e-12);
        EXPECT_NEAR(top.value, 25e-6 / 3.0 * height / (width * width), 1e-16);
    }
}

TEST(RuleMaxima, OfLinearRulesOnLaws) {
    for (const char* const name : {"modified_sine", "cycloidal", "modified_trapezoid"}) {
        const std::shared_ptr<const Law> law = make_law(name);
        const MotionChain motion({{0.0, 2.0, law, 0.0, 2.0, 0.0, 1.0}});
        for (int order = 1; order <= 3; ++order) {
            LinearBound bound{"limits.most", order};
            const MaximaAlong found = maxima_along(LinearRule(bound), motion, {});
            EXPECT_TRUE(found.complete) << name;
            double dense = -infinity;
            for (int k = 0; k <= dense_points; ++k) {
                const double at = 2.0 * k / dense_points;
                const auto own = static_cast<std::size_t>(order);
                dense = std::max(dense, motion.at(at, Side::right).derivative[own]);
            }
            const double top = largest_of(found.maxima).value;
            EXPECT_GE(top, dense - 1e-10) << name << order;
            EXPECT_LE(top, dense + 1e-4 * std::abs(dense)) << name << order;
        }
    }
}

TEST(RuleMaxima, UndefinedValuesCountAsWorstViolation) {
    const Scene scene = small_cam(FollowerType::translating_roller, Rotation::clockwise);
    CamModel model = scene_model(scene, DesignKind::coefficients, reference_peaks(scene));
    const auto worst = [&](double beyond) {
        CamModel with = model;
        with.rules.clear();
        with.rules.emplace_back(std::make_shared<OutOfReach>(beyond));
        const CamProblem problem(with);
        const Eigen::VectorXd x = problem.start();
        double amount = -infinity;
        for (const Violation& violation : problem.violations(x, 2.0))
            if (violation.limit && violation.rule == 0) amount = std::max(amount, violation.amount);
        const double largest =
            largest_of(rule_maxima(with.rules[0], with.design, problem.motion(x), {})).value;
        const MotionChain motion = problem.motion(x);
        EXPECT_EQ(largest, largest_of(rule_maxima(*with.rules[0], motion, {})).value);
        EXPECT_EQ(largest, amount);
        return amount;
    };
    for (const double beyond : {0.1, 0.5, 0.9}) EXPECT_EQ(worst(beyond), infinity) << beyond;
    EXPECT_EQ(worst(1.5), -1.0);
}

/// y' / (1 + y): 1 everywhere along y = e^x − 1, so that a quintic close to it hugs the limit of 1.
class Hugging final : public PointRule {
 public:
    Hugging() : PointRule({"hugging"}) {}
    [[nodiscard]] std::optional<RangeAlong> range_along(const Interval&, const std::array<Interval, 5>& y,
                                                        const Eigen::VectorXd&) const override {
        ++looks_;
        const RangeAlong displacement(y[0], y[1], y[2]), velocity(y[1], y[2], y[3]);
        return velocity / (displacement + 1.0) - 1.0;
    }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd&) const override {
        return {point.derivative[1] / (1.0 + point.derivative[0]) - 1.0, Eigen::VectorXd::Zero(4),
                Eigen::MatrixXd::Zero(4, 4)};
    }
    [[nodiscard]] int looks() const { return looks_; }

 private:
    mutable int looks_ = 0;
};

/// Thousands of stretches a piece, and given up, where only the first order enclosed the rule.
TEST(RuleMaxima, NearlyActiveRulesAreFoundQuickly) {
    Eigen::VectorXd y(6);
    y << 0.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0;
    const SplineCurve curve(SplineSpace(5, 4, {0.0, 0.02}), y);
    const Hugging rule;
    const Eigen::VectorXd none;
    const piece_maxima::Subject subject{rule, curve, none};
    auto effort = piece_maxima::Effort::of(1);
    const auto found = piece_maxima::enclosed(subject, {{0.0, 0.02}, y}, -1.0, 1e-10, effort);
    ASSERT_TRUE(found);
    EXPECT_LT(rule.looks(), 500);
    // y'/(1 + y) − 1 = −x⁵/120 / (1 + y): largest at the beginning.
    for (const Extremum& maximum : *found) {
        EXPECT_LE(maximum.value, 1e-15);
        EXPECT_GE(maximum.value, -1e-7);
    }
}

/// sin(10⁶·y): thousands of maxima a piece, none of which says anything.
class Shaking final : public PointRule {
 public:
    Shaking() : PointRule({"shaking"}) {}
    [[nodiscard]] std::optional<RangeAlong> range_along(const Interval&, const std::array<Interval, 5>&,
                                                        const Eigen::VectorXd&) const override {
        ++looks_;
        return RangeAlong({-1.0, 1.0}, {-1e6, 1e6}, {-1e12, 1e12});
    }
    [[nodiscard]] RuleValue evaluate(const MotionPoint& point, const Eigen::VectorXd&) const override {
        ++looks_;
        RuleValue value{std::sin(often * point.derivative[0]), Eigen::VectorXd::Zero(4),
                        Eigen::MatrixXd::Zero(4, 4)};
        value.gradient[0] = often * std::cos(often * point.derivative[0]);
        return value;
    }
    [[nodiscard]] int looks() const { return looks_; }

 private:
    static constexpr double often = 1e6;
    mutable int looks_ = 0;
};

/// A search that strays far outside asked 16,000 times a piece, for seconds that nobody could stop.
TEST(RuleMaxima, DistantMotionsDoNotCostSeconds) {
    constexpr int pieces = 20;
    std::vector<double> breakpoints;
    for (int k = 0; k <= pieces; ++k) breakpoints.push_back(static_cast<double>(k) / pieces);
    Eigen::MatrixXd ramp = Eigen::MatrixXd::Zero(4, pieces);
    for (int k = 0; k < pieces; ++k) ramp.col(k).head(2) << breakpoints[static_cast<std::size_t>(k)], 1.0;
    const auto curve = std::make_shared<SplineCurve>(SplineSpace(3, 2, breakpoints), ramp);
    const MotionChain chain({{0.0, 1.0, curve}});
    const Shaking rule;
    const std::vector<Extremum> found = rule_maxima(rule, chain, Eigen::VectorXd());
    EXPECT_LT(rule.looks(), 30000);
    EXPECT_GT(largest_of(found).value, 0.999);  // broken, and seen to be
}

}  // namespace rule_maxima_test
}  // namespace camopt
