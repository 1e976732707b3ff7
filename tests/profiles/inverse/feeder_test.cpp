// SPDX-License-Identifier: MIT
// From the body to the feeder and back: the reference instants, velocities and accelerations against
// differences of positions, faults.
#include "core/errors.hpp"
#include "reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {

namespace feeder_test {

using testing_support::refusal;

using test::inch;

struct Instant {
    double time;
    bool forward;
    double theta, velocity, acceleration, y, y_velocity, y_acceleration;  // rad and inch
};

constexpr Instant instants[] = {
    {.100, true, -0.012155558073192, -1.7636590147365, -121.16763803107, -0.46320714281435, 28.129077031820,
     2019.2510708761},
    {.125, true, -0.091677014042304, -4.5368523469395, -106.47794639708, 0.87756163102496, 79.638677388614,
     2105.6757067003},
    {.170, false, -0.147530644817250, 2.8590638738686, 460.42598639911, 1.8687957255127, -50.919653842487,
     -8220.3842661168},
};

void expect_digits(double found, double expected) {
    EXPECT_NEAR(found, expected, 2e-13 * std::abs(expected));  // the reference has 14 digits
}

TEST(InverseFeeder, ReferenceInstants) {
    for (const Instant& instant : instants) {
        const RollerState roller =
            state_of(instant.forward ? test::forward_stroke() : test::return_stroke(), instant.time);
        const BodyMotion body =
            test::arc_at(instant.forward ? test::forward_arcs : test::return_arcs, roller.distance)
                .body(roller);
        const FeederMotion moved = feeder_motion(test::reference_linkage(), body);
        ASSERT_EQ(moved.fault, InverseFault::none);
        expect_digits(body.angle, instant.theta);
        expect_digits(body.velocity, instant.velocity);
        expect_digits(body.acceleration, instant.acceleration);
        expect_digits(moved.feeder.s / inch, instant.y);
        expect_digits(moved.feeder.velocity / inch, instant.y_velocity);
        expect_digits(moved.feeder.acceleration / inch, instant.y_acceleration);
    }
}

/// Everything against central differences of positions, along the first arc.
TEST(InverseFeeder, DerivativesAgainstPositions) {
    const FeederLinkage linkage = test::reference_linkage();
    struct Moved {
        BodyMotion body;
        FeederMotion f;
    };
    const auto at = [&](double time) {
        const BodyMotion body = test::forward_arcs[0].body(state_of(test::forward_stroke(), time));
        return Moved{body, feeder_motion(linkage, body)};
    };
    const double h = 2e-6;
    for (double t = 0.0868; t < 0.128; t += 2e-5) {
        const Moved before = at(t - h), state = at(t), after = at(t + h);
        const auto difference = [&](auto member) { return (member(after) - member(before)) / (2 * h); };
        const FeederMotion& f = state.f;
        EXPECT_NEAR(state.body.velocity, difference([](const auto& s) { return s.body.angle; }), 1e-6);
        EXPECT_NEAR(state.body.acceleration, difference([](const auto& s) { return s.body.velocity; }), 1e-4);
        EXPECT_NEAR(f.rocker_velocity, difference([](const auto& s) { return s.f.rocker_angle; }), 1e-5);
        EXPECT_NEAR(f.rocker_acceleration, difference([](const auto& s) { return s.f.rocker_velocity; }),
                    1e-2);
        EXPECT_NEAR(f.reach_velocity, difference([](const auto& s) { return s.f.rocker_reach; }), 1e-6);
        EXPECT_NEAR(f.reach_acceleration, difference([](const auto& s) { return s.f.reach_velocity; }), 1e-3);
        EXPECT_NEAR(f.feeder.velocity, difference([](const auto& s) { return s.f.feeder.s; }), 1e-6);
        EXPECT_NEAR(f.feeder.acceleration, difference([](const auto& s) { return s.f.feeder.velocity; }),
                    1e-3);
        EXPECT_NEAR(f.pin_velocity.x(), difference([](const auto& s) { return s.f.pin.x(); }), 1e-6);
        EXPECT_NEAR(f.pin_acceleration.y(), difference([](const auto& s) { return s.f.pin_velocity.y(); }),
                    1e-3);
    }
}

TEST(InverseFeeder, RockerAngleIsContinuous) {
    // The pin stands left of the rocker's pivot: atan2 would jump by a turn where it passes its height.
    const FeederLinkage linkage = test::reference_linkage();
    double last = feeder_motion(linkage, {0.0, 0.0, 0.0}).rocker_angle;
    for (double theta = 0.0; theta > -0.3; theta -= 1e-3) {
        const double phi = feeder_motion(linkage, {theta, 0.0, 0.0}).rocker_angle;
        EXPECT_LT(std::abs(phi - last), 0.05);
        last = phi;
    }
}

/// Random linkages on both branches and both sides: back from the feeder to the body that moved it.
TEST(InverseFeeder, InverseFindsTheBody) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    int compared = 0;
    while (compared < 2000) {
        const FeederLinkage linkage{0.4 + 0.1 * part(generator),
                                    part(generator),
                                    {0.5 * part(generator), 0.3 * part(generator)},
                                    part(generator) > 0.0 ? 0.1 : -0.12};
        const BodyMotion body{0.05 * part(generator), 5.0 * part(generator), 300.0 * part(generator)};
        const FeederMotion motion = feeder_motion(linkage, body);
        const auto arm = [&](double angle) {
            const double a = angle + linkage.pin_angle;
            return Eigen::Vector2d(linkage.pin_distance * Eigen::Vector2d(std::cos(a), std::sin(a)) -
                                   linkage.rocker_pivot);
        };
        const auto along = [&](double angle) {
            return (arm(angle) + linkage.rocker_pivot).dot(arm(angle).normalized()) / linkage.pin_distance;
        };
        // Near a dead point, or past the side or branch of theta = 0, there is another body.
        if (motion.fault != InverseFault::none || along(0.0) * along(body.angle) <= 0.0 ||
            std::abs(along(body.angle)) < 0.2 || arm(0.0).x() * arm(body.angle).x() <= 0.0 ||
            std::abs(arm(body.angle).x()) < 0.05)
            continue;
        ++compared;
        const BodyResult back = body_motion(linkage, motion.feeder);
        ASSERT_EQ(back.fault, InverseFault::none);
        EXPECT_NEAR(back.body.angle, body.angle, 1e-12);
        EXPECT_NEAR(back.body.velocity, body.velocity, 1e-10);
        EXPECT_NEAR(back.body.acceleration, body.acceleration, 1e-8);
    }
}

TEST(InverseFeeder, GuideOfMotionRoundTrips) {
    const FeederLinkage linkage = test::reference_linkage();
    for (double inches = 5.3; inches < 12.85; inches += 0.1) {
        const RollerState roller =
            state_of(test::forward_stroke(), time_at(test::forward_stroke(), inches * inch));
        const test::ArcGuide& arc = test::arc_at(test::forward_arcs, roller.distance);
        const GuideNode wanted =
            wanted_guide(linkage, roller, feeder_motion(linkage, arc.body(roller)).feeder);
        ASSERT_EQ(wanted.fault, InverseFault::none);
        const PolarNode node = arc.node(roller.distance);
        EXPECT_NEAR(wanted.node.angle, node.angle, 1e-14);
        EXPECT_NEAR(wanted.node.slope, node.slope, 1e-11);
        EXPECT_NEAR(wanted.node.bend, node.bend, 1e-8);
    }
}

TEST(InverseFeeder, FaultsByName) {
    const FeederLinkage linkage = test::reference_linkage();
    FeederLinkage on_pivot = linkage;
    on_pivot.pin_angle = 0.0;
    on_pivot.rocker_pivot = {on_pivot.pin_distance, 0.0};
    EXPECT_EQ(feeder_motion(on_pivot, {}).fault, InverseFault::pin_on_rocker_pivot);
    FeederLinkage along = linkage;
    along.pin_angle = 0.0;
    along.rocker_pivot = {along.pin_distance, -0.1};
    EXPECT_EQ(feeder_motion(along, {}).fault, InverseFault::rocker_along_feeder);
    EXPECT_EQ(body_motion(linkage, {40.0 * inch, 0, 0}).fault, InverseFault::rocker_misses_pin);
    EXPECT_EQ(wanted_guide(linkage, {5.0 * inch, 0, 0}, {0.0, 0, 0}).fault, InverseFault::roller_at_rest);
    EXPECT_EQ(name_of(InverseFault::rocker_misses_pin), "rocker_misses_pin");
    FeederLinkage wrong = linkage;
    wrong.feeder_offset = 0.0;
    EXPECT_EQ(refusal([&] { wrong.validate(); }), "the feeder's offset is 0 m; it must not be 0");
}

TEST(RollerStroke, TimesOfDistances) {
    EXPECT_NEAR(state_of(test::forward_stroke(), 0.158).distance / inch, 13.982, 1e-12);
    EXPECT_NEAR(state_of(test::return_stroke(), 0.158).velocity / inch, -249.64, 1e-10);
    EXPECT_NEAR(state_of(test::return_stroke(), 0.258).distance / inch, 1.5, 1e-12);
    for (const RollerStroke& stroke : {test::forward_stroke(), test::return_stroke()})
        for (const double part : {0.0, 0.2, 0.7, 1.0}) {
            const double time = stroke.begin + part * (stroke.end - stroke.begin);
            EXPECT_NEAR(time_at(stroke, state_of(stroke, time).distance), time, 1e-9);
        }
    EXPECT_TRUE(std::isnan(time_at(test::forward_stroke(), 20.0 * inch)));
}

}  // namespace feeder_test

}  // namespace camopt
