// SPDX-License-Identifier: MIT
// Forward simulation of a guide by its points: a slot's wall leads the roller far below 1e-6 rad, a wrong
// wall is found out.
#include "studies/inverse/inverse_forward.hpp"

#include "core/errors.hpp"
#include "profiles/inverse/reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {

namespace inverse_forward_test {

using testing_support::refusal;

using test::inch;

/// A wall of the slot, at so many points of each of the reference guide's two arcs, beside its middle.
GuideCheckInput wall_input(int points, double offset) {
    GuideCheckInput input;
    for (const test::ArcGuide& arc : test::forward_arcs) {
        const bool first = input.points.empty();
        for (int i = first ? 0 : 1; i <= points; ++i) {
            const double distance = (arc.from + (arc.to - arc.from) * i / points) * inch;
            input.points.emplace_back(arc.place(distance) + offset * arc.left(distance));
        }
        if (first) input.breaks.push_back(points);
    }
    input.designed = [](double distance) {
        return test::arc_at(test::forward_arcs, distance).node(distance).angle;
    };
    input.begin = 5.4 * inch;
    input.end = 12.7 * inch;
    input.places = 2000;
    return input;
}

TEST(InverseForward, SlotWallLeadsTheRoller) {
    const double radius = 0.5 * inch;  // chosen
    for (const double side : {1.0, -1.0}) {
        GuideCheckInput input = wall_input(200, side * radius);
        input.roller_radius = radius;
        EXPECT_LT(slot_check(input).deviation, 1e-8);
        // A roller a micrometre too thick turns the body by a measurable amount.
        input.roller_radius = radius + 1e-6;
        EXPECT_GT(slot_check(input).deviation, 3e-6);
    }
}

TEST(InverseForward, RefusesWhatCannotBeChecked) {
    GuideCheckInput input = wall_input(100, 0.0);
    EXPECT_EQ(refusal([&] { (void)slot_check(input); }),
              "the roller's radius is 0 m; it must be > 0");  // no roller
    input.points.clear();
    EXPECT_EQ(refusal([&] { (void)slot_check(input); }),
              "0 points of the guide were given; it needs at least 3");
}

}  // namespace inverse_forward_test

}  // namespace camopt
