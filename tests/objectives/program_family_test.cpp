// SPDX-License-Identifier: MIT
// From the segments of a program to the stretches of its motions: where breakpoints fall.
#include "objectives/scene_model.hpp"
#include "tests/studies/scenes_for_tests.hpp"

#include <gtest/gtest.h>

namespace camopt {
namespace program_family_test {

using namespace testing_support;
using units::degree;

/// Dwell of 60°, rise of 120°, dwell of 60°, return of 120°.
Scene up_and_down() {
    return program({dwell(60), spline(120, 1.0), dwell(60), spline(120, 0.0)});
}

std::vector<double> spline_begins(const MotionFamily& family, int stretch) {
    std::vector<double> begins;
    for (const MotionFamily::Piece& piece : family.pieces())
        if (piece.stretch == stretch) begins.push_back(piece.begin);
    return begins;
}

/// The unit of x is that of the scene; a place written in units of a segment lies that part of the way along
/// it.
TEST(ProgramFamily, BreakpointsUseUnitsOfEachSegment) {
    Scene scene = up_and_down();
    scene.spline.breakpoints = {0.0, 0.2, 0.45, 0.5, 1.0};
    const double unit = scene.motion.unit_angle();
    for (const DesignKind kind : {DesignKind::ordinates, DesignKind::coefficients, DesignKind::states}) {
        const MotionFamily family = program_family(scene, kind);
        for (const auto& [stretch, begin_deg] : {std::pair{1, 60.0}, std::pair{3, 240.0}}) {
            const std::vector<double> begins = spline_begins(family, stretch);
            ASSERT_EQ(begins.size(), 4U);
            for (std::size_t i = 0; i < begins.size(); ++i)
                EXPECT_NEAR(begins[i] * unit / degree, begin_deg + 120.0 * scene.spline.breakpoints[i],
                            1e-10);
        }
    }
}

TEST(ProgramFamily, UniformBreakpointsDivideEachSegment) {
    Scene scene = up_and_down();
    scene.spline.segments = 5;
    const double unit = scene.motion.unit_angle();
    const MotionFamily family = program_family(scene, DesignKind::states);
    const std::vector<double> begins = spline_begins(family, 3);
    ASSERT_EQ(begins.size(), 5U);
    for (std::size_t i = 0; i < begins.size(); ++i)
        EXPECT_NEAR(begins[i] * unit / degree, 240.0 + 24.0 * static_cast<double>(i), 1e-10);
    EXPECT_NEAR(family.end() * unit / degree, 360.0, 1e-10);
}

/// A free displacement whose direction is given turns back where a given one goes the other way.
TEST(ProgramFamily, DirectionsTurnBackAtJoints) {
    const Scene scene = program({spline(100), spline(80, 1.0), spline(120, 0.0), dwell(60)});
    using enum StrokeDirection;
    const auto conditions = [&](const std::vector<StrokeDirection>& directions) {
        return scene_family(scene, DesignKind::states, directions).equalities().size();
    };
    const std::size_t none = conditions({});
    EXPECT_EQ(conditions({open, open}), none);
    EXPECT_EQ(conditions({rises, rises}), none + 1);  // the top
    EXPECT_EQ(conditions({falls, rises}), none + 2);  // and the free joint
    EXPECT_EQ(conditions({rises, falls}), none + 1);
    EXPECT_EQ(conditions({open, falls}), none);
}

}  // namespace program_family_test
}  // namespace camopt
