// SPDX-License-Identifier: MIT
// Plates that slide: programs of every follower, either direction, compensated and not; the workshop sheet.
#include "shop/disk/disk_export.hpp"
#include "shop/sheet/cam_sheet.hpp"
#include "studies/search/planned_solve.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace camopt {
namespace plate_test {

using testing_support::says;
using units::millimetre;

Solution solved_plate(const std::string& name, const std::string& setting = "spline.segments = 16") {
    return solve_without_explaining(testing_support::scene_named(name).with(setting), {}, nullptr,
                                    {.look = true});
}

DiskNcOptions coarse_plate() {
    DiskNcOptions options;
    options.chord_tolerance = 1e-5;
    options.cutter_diameter = 10.0 * millimetre;
    options.milling.step_down = 1.0;
    options.milling.step_over = 8.0 * millimetre;
    return options;
}

CheckedProgram milled_plate(const Solution& solution, const DiskNcOptions& options) {
    const std::optional<ProfileShape> shape = delivered_shape(solution);
    const auto machine = plane_milling_machine();
    return checked_program(*machine, generic_post(*machine), disk_nc_work(shape.value(), options));
}

void expect_sound(const Solution& solution, const DiskNcOptions& options) {
    const CheckedProgram program = milled_plate(solution, options);
    EXPECT_EQ(program.fault(), "");
    ASSERT_EQ(program.surfaces.size(), 1U);
    EXPECT_LT(program.surfaces[0].check.stock, 2e-5);
    EXPECT_LT(program.surfaces[0].check.gouge, 2e-5);
    EXPECT_GT(program.roughed.at(0).check.least_stock, 0.29 * millimetre);
    EXPECT_EQ(options.milling.climbs() ? program.direction.conventional : program.direction.climb, 0);
    EXPECT_TRUE(program.clamp && program.clamp->block);
}

constexpr std::array followers = {
    std::pair{"linear_press", "spline.segments = 16"}, std::pair{"linear_press", "cam.travel_mm = -240"},
    std::pair{"linear_knife", "spline.segments = 16"}, std::pair{"linear_arm", "spline.segments = 16"}};

TEST(PlateMilling, EveryFollowerHasASoundProgram) {
    for (const auto& [name, setting] : followers) {
        SCOPED_TRACE(std::string(name) + ", " + setting);
        const Solution solution = solved_plate(name, setting);
        ASSERT_TRUE(solution.motion);
        expect_sound(solution, coarse_plate());
    }
}

TEST(PlateMilling, EitherWayAndCompensated) {
    for (const auto& [name, setting] : followers) {
        const Solution solution = solved_plate(name, setting);
        for (const MillingDirection direction : {MillingDirection::climb, MillingDirection::conventional})
            for (const CompensationWords words : {CompensationWords::none, CompensationWords::control}) {
                SCOPED_TRACE(std::string(name) + ", " + setting + ", " + name_of(direction) + ", " +
                             name_of(words));
                DiskNcOptions options = coarse_plate();
                options.milling.direction = direction;
                options.milling.compensation = words;
                expect_sound(solution, options);
            }
    }
}

TEST(PlateMilling, RefusesDiametersOfBlanks) {
    const Solution solution = solved_plate("linear_press");
    DiskNcOptions options = coarse_plate();
    options.blank.radius = 0.1;
    EXPECT_TRUE(says(testing_support::refusal([&] { (void)milled_plate(solution, options); }),
                     "blank: found a diameter"));
}

TEST(PlateSheet, ShowsPointsAndDimensions) {
    const Solution solution = solved_plate("linear_press");
    const std::vector<Sheet> sheets = cam_sheets(solution);
    ASSERT_EQ(sheets.size(), 1U);
    EXPECT_TRUE(sheets[0].drawing.has("cam"));
    EXPECT_TRUE(sheets[0].drawing.has("pitch"));
    const auto measures = [&](double length) {
        return std::ranges::any_of(sheets[0].dimensions, [&](const DrawnDimension& one) {
            return std::abs(one.measured() - length) < 1e-9;
        });
    };
    EXPECT_TRUE(measures(240.0 * millimetre));
    EXPECT_TRUE(measures(40.0 * millimetre));
    EXPECT_TRUE(measures(default_thickness));
    CamSheetOptions bored;
    bored.bore = 0.01;
    EXPECT_TRUE(says(testing_support::refusal([&] { (void)cam_sheets(solution, bored); }),
                     "a bore in a plate that slides"));
}

}  // namespace plate_test
}  // namespace camopt
