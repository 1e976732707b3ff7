// SPDX-License-Identifier: MIT
// In which units a person reads a scene, and with which factors.
#include "report/view/shown_units.hpp"

#include "core/units.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <vector>

namespace camopt {
namespace shown_units_test {

using units::degree, units::millimetre, units::revolution_per_minute;

/// Lift 10 mm in 90 deg.
Scene scene_of(bool speed, bool swings, LengthUnit length) {
    Scene scene;
    scene.motion.lift = swings ? 20.0 * degree : 10.0 * millimetre;
    scene.motion.lift_is_angle = swings;
    scene.motion.rise = 90.0 * degree;
    if (speed) scene.motion.speed = 300.0 * revolution_per_minute;
    scene.length_unit = length;
    return scene;
}

struct Expected {
    bool speed, swings;
    LengthUnit length;
    std::vector<std::string> first, beside;  // of s, s', s'', s'''; beside: none of s
};

const std::vector<Expected>& expectations() {
    using enum LengthUnit;
    static const std::vector<Expected> all = {
        {true, false, millimetre, {"mm", "mm/s", "m/s²", "m/s³"}, {"mm/rad", "mm/rad²", "mm/rad³"}},
        {false, false, millimetre, {"mm", "mm/rad", "mm/rad²", "mm/rad³"}, {}},
        {true, false, inch, {"in", "in/s", "in/s²", "in/s³"}, {"in/rad", "in/rad²", "in/rad³"}},
        {false, false, inch, {"in", "in/rad", "in/rad²", "in/rad³"}, {}},
        {true, true, millimetre, {"deg", "deg/s", "deg/s²", "deg/s³"}, {"deg/deg", "deg/deg²", "deg/deg³"}},
        {false, true, inch, {"deg", "deg/deg", "deg/deg²", "deg/deg³"}, {}},
    };
    return all;
}

TEST(ShownUnits, SpeedShowsTimeBeforeCamAngle) {
    for (const Expected& expected : expectations()) {
        const ShownUnits shown = shown_units(scene_of(expected.speed, expected.swings, expected.length));
        EXPECT_EQ(shown.in_time, expected.speed);
        EXPECT_EQ(shown.length.name, name_of(expected.length));
        EXPECT_FALSE(shown.motion[0].beside.has_value());
        for (std::size_t r = 0; r < 4; ++r) {
            EXPECT_EQ(shown.motion[r].first.name, expected.first[r]);
            EXPECT_EQ(shown.motion[r].first.order, r);
            if (r == 0) continue;
            ASSERT_EQ(shown.motion[r].beside.has_value(), expected.speed);
            EXPECT_EQ(shown.motion[r].by_angle().name,
                      expected.speed ? expected.beside[r - 1] : expected.first[r]);
        }
    }
}

TEST(ShownUnits, FactorsAreThoseOfTheNames) {
    // v = 10 mm / (90 deg / 1800 deg/s) = 200 mm/s, a = 4 m/s², j = 80 m/s³ for y' = y'' = y''' = 1.
    const ShownUnits timed = shown_units(scene_of(true, false, LengthUnit::millimetre));
    EXPECT_EQ(timed.motion[0].first.normalised_text(0.5), "5 mm");
    EXPECT_EQ(timed.motion[1].first.normalised_text(1.0), "200 mm/s");
    EXPECT_EQ(timed.motion[2].first.normalised_text(1.0), "4 m/s²");
    EXPECT_EQ(timed.motion[3].first.normalised_text(-1.0), "−80 m/s³");
    EXPECT_EQ(timed.motion[1].first.text(0.2), "200 mm/s");
    EXPECT_EQ(timed.motion[2].first.text(4.0), "4 m/s²");
    EXPECT_NEAR(timed.motion[1].beside->per_normalised, 10.0 / (std::numbers::pi / 2), 1e-12);
    // An inch is 25.4 mm, whatever the derivative.
    const ShownUnits inches = shown_units(scene_of(true, false, LengthUnit::inch));
    EXPECT_NEAR(inches.motion[1].first.per_normalised, 200.0 / 25.4, 1e-12);
    EXPECT_NEAR(inches.motion[2].first.per_normalised, 4000.0 / 25.4, 1e-11);
    EXPECT_EQ(inches.length.text(0.0254), "1 in");
    EXPECT_EQ(inches.curvature.text(1.0 / 0.0254), "1 1/in");
    // 20 deg in 0.05 s: 400 deg/s.
    const ShownUnits swing = shown_units(scene_of(true, true, LengthUnit::millimetre));
    EXPECT_NEAR(swing.motion[1].first.per_normalised, 400.0, 1e-12);
    EXPECT_NEAR(swing.motion[2].first.per_normalised, 8000.0, 1e-11);
    EXPECT_NEAR(swing.motion[1].beside->per_normalised, 20.0 / 90.0, 1e-15);
    EXPECT_NEAR(swing.motion[2].beside->per_normalised, 20.0 / 8100.0, 1e-16);
    EXPECT_EQ(swing.motion[0].first.text(20.0 * degree), "20 deg");
}

TEST(ShownUnits, SwingingOutputHasOneUnit) {
    Scene scene = scene_of(true, true, LengthUnit::millimetre);
    scene.limits.velocity = PeakLimit{1.5, "limits.velocity_rad_s", 10.0, "rad/s"};
    const ShownUnits shown = shown_units(scene);
    EXPECT_EQ(shown.motion[1].first.normalised_text(1.0), "400 deg/s");
    EXPECT_EQ(shown.motion[2].first.normalised_text(1.0), "8000 deg/s²");
    EXPECT_EQ(shown.motion[2].first.name, "deg/s²");
}

TEST(ShownUnits, ThousandthsOfAnInchStay) {
    const ShownUnit inches{"in", units::inch};
    EXPECT_EQ(inches.asked_text(0.05 * units::inch), "0.050 in");
    EXPECT_EQ(inches.asked_text(0.4016 * units::inch), "0.4016 in");
    EXPECT_EQ(millimetres_shown.asked_text(0.05 * units::millimetre), "0.05 mm");
}

TEST(ShownUnits, ForcesAreThoseOfTheFollower) {
    const ShownUnits straight = shown_units(scene_of(true, false, LengthUnit::inch));
    EXPECT_EQ(straight.load.text(4.4482216152605), "1 lbf");
    EXPECT_EQ(straight.torque.text(0.1129848290276167), "1 lbf in");
    EXPECT_EQ(straight.spring_rate.text(175.12683524647636), "1 lbf/in");
    EXPECT_EQ(straight.pressure.text(6894757.293168361), "1 ksi");
    EXPECT_EQ(straight.mass.text(0.45359237), "1 lb");
    EXPECT_EQ(straight.vibration.text(2.54e-5), "1 mil");
    const ShownUnits metric = shown_units(scene_of(true, false, LengthUnit::millimetre));
    EXPECT_EQ(metric.load.text(40.0), "40 N");
    EXPECT_EQ(metric.spring_rate.text(12000.0), "12 N/mm");
    EXPECT_EQ(metric.pressure.text(8e8), "800 MPa");
    const ShownUnits swing = shown_units(scene_of(true, true, LengthUnit::millimetre));
    EXPECT_EQ(swing.load.text(3.0), "3 N m");
    EXPECT_EQ(swing.force.text(3.0), "3 N");
    EXPECT_EQ(swing.spring_rate.text(12.0), "12 N m/rad");
}

}  // namespace shown_units_test
}  // namespace camopt
