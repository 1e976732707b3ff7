// SPDX-License-Identifier: MIT
// The inverse cam as a mechanism of a scene, against guides of arcs.
#include "profiles/inverse/inverse_mechanism.hpp"

#include "core/errors.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace camopt {

namespace inverse_mechanism_test {

using testing_support::refusal;

using test::inch;
using Numbers = std::array<double, inverse_number_count>;

/// The forward stroke of the reference machine; a cam angle of 1 rad is 0.05 s.
constexpr double seconds_a_radian = 0.05;
Numbers reference_numbers() {
    const FeederLinkage linkage = test::reference_linkage();
    return {0.5 * inch,
            1.5 * inch,
            13.982 * inch,
            0.158 / seconds_a_radian,
            5.25 * inch,
            linkage.pin_distance,
            linkage.pin_angle,
            linkage.rocker_pivot.x(),
            linkage.rocker_pivot.y(),
            linkage.feeder_offset,
            -0.655 * inch};
}

const CamMechanism& mechanism() {
    static const auto made = inverse_mechanism(inverse_spec());
    return *made;
}

/// The feeder on the guide of arcs at a cam angle, its derivatives by the cam angle.
FollowerState feeder_of_arcs(double theta) {
    const double begin = time_at(test::forward_stroke(), 5.25 * inch);
    const RollerState roller = state_of(test::forward_stroke(), begin + theta * seconds_a_radian);
    const BodyMotion body = test::arc_at(test::forward_arcs, roller.distance).body(roller);
    FollowerState feeder = feeder_motion(test::reference_linkage(), body).feeder;
    feeder.s += 0.655 * inch;
    feeder.velocity *= seconds_a_radian;
    feeder.acceleration *= seconds_a_radian * seconds_a_radian;
    return feeder;
}

TEST(InverseMechanism, PointsMatchGuideOfArcs) {
    const Numbers numbers = reference_numbers();
    for (const double part : {0.1, 0.3, 0.5, 0.62, 0.8, 0.9}) {
        const double theta = part * stroke_of(numbers).end;
        const MechanismState state{numbers, feeder_of_arcs(theta), theta};
        const double distance = state_of(stroke_of(numbers), theta).distance;
        const test::ArcGuide& arc = test::arc_at(test::forward_arcs, distance);
        const PolarNode node = arc.node(distance);
        const double curvature = 1.0 / (arc.radius * inch);
        for (const int station : {0, 1}) {
            const double side = station == 0 ? 1.0 : -1.0;
            const MechanismPoint point = mechanism().point(theta, state, station);
            EXPECT_NEAR((point.pitch.head<2>() - arc.place(distance)).norm(), 0.0, 1e-13);
            EXPECT_NEAR(point.pressure_angle, std::atan(distance * node.slope), 1e-10);
            EXPECT_NEAR(point.pitch_curvature, side * curvature, 1e-8);
            EXPECT_NEAR(point.regularity, 1.0 - 0.5 * inch * side * curvature, 1e-9);
            EXPECT_NEAR((point.contact - point.pitch).norm(), 0.5 * inch, 1e-15);
            // Seen outwards along the guide the first flank lies on its left.
            EXPECT_NEAR((point.contact - point.pitch).head<2>().dot(arc.left(distance)), side * 0.5 * inch,
                        1e-8);
            EXPECT_NEAR((point.pitch - point.contact - 0.5 * inch * point.normal).norm(), 0.0, 1e-15);
        }
    }
}

TEST(InverseMechanism, SaysWhatDoesNotReach) {
    Numbers numbers = reference_numbers();
    EXPECT_EQ(mechanism().fault(numbers, 0.0, 2.7 * inch), "");
    EXPECT_NE(mechanism().fault(numbers, 0.0, 40.0 * inch).find("rocker_misses_pin"), std::string::npos);
    EXPECT_TRUE(std::isnan(mechanism().point(0.5, {numbers, {40.0 * inch, 0, 0}, 0.5}, 0).pressure_angle));
    // Where there is no value there are none of its partials either, and as many as asked for.
    const std::array<int, 2> active = {0, 4};
    const MechanismValue none =
        mechanism().quantity(MechanismQuantity::regularity, {numbers, {40.0 * inch, 0, 0}, 0.5}, 0, active);
    EXPECT_TRUE(std::isnan(none.value));
    EXPECT_EQ(none.gradient.size(), 5);
    EXPECT_EQ(none.hessian.rows(), 5);
    EXPECT_TRUE(none.gradient.array().isNaN().all());
    numbers[static_cast<std::size_t>(InverseNumber::roller_from)] = 20.0 * inch;
    EXPECT_NE(mechanism().fault(numbers, 0.0, 2.7 * inch).find("ascend"), std::string::npos);
    CamSpec other = inverse_spec();
    other.type = "barrel";
    EXPECT_EQ(refusal([&] { (void)inverse_mechanism(other); }),
              "a mechanism of type \"barrel\"; allowed: \"inverse\"");
}

}  // namespace inverse_mechanism_test

}  // namespace camopt
