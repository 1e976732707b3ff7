// SPDX-License-Identifier: MIT
// Roughing, ways in and direction in the grooves of drums; programs with one fault each.
#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "shop/nc/spoiled_programs.hpp"
#include "shop/spatial/cam_export.hpp"
#include "tests/shop/nc/nc_samples.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace groove_milling_test {

using test::millimetre;
using testing_support::says;

NcExportOptions coarse(const SpatialCam& cam, double share) {
    NcExportOptions options;
    options.cutter_diameter = share * 2.0 * cam[SpatialDimension::roller_radius];
    options.chord_tolerance = 1e-5;
    options.z_offset = 0.12;
    options.milling.full_depth = true;
    return options;
}

struct Grooved {
    SpatialCam cam;
    FollowerMotion motion;
    std::unique_ptr<Machine> machine;
    PostProcessor post;
    NcWork work;
    CheckedProgram program;

    Grooved(SpatialCam of, FollowerMotion with, const NcExportOptions& options)
        : cam(std::move(of)),
          motion(std::move(with)),
          machine(machine_for(cam, options.z_offset)),
          post(generic_post(*machine)),
          work(nc_work(cam, motion, options)),
          program(checked_program(*machine, post, work)) {}
};

TEST(GrooveMilling, RoughsMiddleThenBothFlanks) {
    const SpatialCam cam = test::translating_cam();
    NcExportOptions options = coarse(cam, 0.6);
    options.milling.full_depth = false;
    options.milling.step_over = 2.5 * millimetre;
    options.milling.step_down = 10.0 * millimetre;
    options.milling.finish_allowance = 0.5 * millimetre;
    const Grooved groove(cam, test::translating_motion(), options);
    EXPECT_EQ(groove.program.fault(), "");
    EXPECT_GT(groove.program.direction.climb, 100);
    EXPECT_EQ(groove.program.direction.conventional, 0);
    ASSERT_EQ(groove.program.roughed.size(), 5u);
    for (const SurfaceFinding& found : groove.program.roughed)
        EXPECT_GT(found.check.least_stock, 0.5 * millimetre - 3e-5) << found.name;
    EXPECT_NEAR(groove.program.roughed.back().check.stock, 0.5 * millimetre, 5e-5);
    EXPECT_LT(groove.program.surfaces.back().check.stock, 5e-5);
}

TEST(GrooveMilling, RoughingBelowItsStockIsRefused) {
    const SpatialCam cam = test::translating_cam();
    NcExportOptions options = coarse(cam, 0.6);
    options.milling.full_depth = false;
    options.milling.step_over = 4.0 * millimetre;
    options.milling.step_down = 1.0;
    Grooved groove(cam, test::translating_motion(), options);
    ASSERT_EQ(groove.program.fault(), "");
    groove.work.task.surfaces.clear();
    for (CuttingPass& pass : groove.work.task.passes)
        if (pass.roughs) pass.stock += 0.2 * millimetre;
    const std::string& text = groove.program.program.text;
    EXPECT_TRUE(says(test::refusal_of(text, groove.program, *groove.machine, groove.post, groove.work),
                     "roughing must leave 0.5 mm"));
}

TEST(GrooveMilling, RollerSizedCutterWorksInLayers) {
    const SpatialCam cam = test::barrel_cam();
    NcExportOptions options = coarse(cam, 1.0);
    options.milling.full_depth = false;
    options.milling.step_down = 12.0 * millimetre;
    options.milling.finish_allowance = 0.0;
    const Grooved groove(cam, test::barrel_motion(), options);
    EXPECT_EQ(groove.program.fault(), "");
    EXPECT_TRUE(says(groove.program.program.text, "both flanks at once, one climb, one conventional"));
    for (const SurfaceFinding& found : groove.program.surfaces) EXPECT_LT(found.check.stock, 5e-5);
}

TEST(GrooveMilling, ClimbAndConventionalAreSo) {
    for (const MillingDirection direction : {MillingDirection::climb, MillingDirection::conventional})
        for (const SpindleSense spindle : {SpindleSense::clockwise, SpindleSense::counterclockwise}) {
            const SpatialCam cam = test::rotating_cam();
            NcExportOptions options = coarse(cam, 0.7);
            options.milling.direction = direction;
            options.milling.spindle = spindle;
            Grooved groove(cam, test::rotating_motion(), options);
            EXPECT_EQ(groove.program.fault(), "");
            const bool climbs = direction == MillingDirection::climb;
            EXPECT_EQ(groove.program.direction.climb > 0, climbs);
            EXPECT_EQ(groove.program.direction.conventional > 0, !climbs);
            // Which way the table turns follows from the spindle, and is the other one on the other flank.
            std::vector<double> turns;
            for (std::size_t pass = groove.program.program.text.find("(pass:"); pass != std::string::npos;
                 pass = groove.program.program.text.find("(pass:", pass + 1)) {
                const std::string rest = groove.program.program.text.substr(pass);
                const auto lines = test::lines_of(rest.substr(0, rest.find("(pass:", 1)));
                double first = NAN, last = NAN;
                for (const test::TextLine& line : lines)
                    if (line.words.find(" C") != std::string::npos) {
                        last = test::number_of(line.words, "C");
                        if (std::isnan(first)) first = last;
                    }
                turns.push_back(last - first);
            }
            ASSERT_EQ(turns.size(), 2u);
            EXPECT_LT(turns[0] * turns[1], 0.0);
            groove.work.job.spindle =
                spindle == SpindleSense::clockwise ? SpindleSense::counterclockwise : SpindleSense::clockwise;
            groove.work.task.surfaces.clear();
            EXPECT_TRUE(says(test::refusal_of(groove.program.program.text, groove.program, *groove.machine,
                                              groove.post, groove.work),
                             climbs ? "is conventional, not climb" : "is climb, not conventional"));
        }
}

/// Of the steepest block of a feed that goes down by more than a plunge to the blank, deg.
double steepest_way_down(const Grooved& groove) {
    const auto moves = read_nc_text(groove.program.program.text, *groove.machine, groove.post);
    double steepest = 0.0;
    for (std::size_t i = 1; i < moves.size(); ++i) {
        if (moves[i].rapid || moves[i - 1].rapid) continue;
        const ToolPose from = groove.machine->pose(moves[i - 1].values),
                       to = groove.machine->pose(moves[i].values);
        const Eigen::Vector3d way = to.tip - from.tip;
        const double down = way.dot(0.5 * (from.axis + to.axis));
        if (down > 1e-5) steepest = std::max(steepest, std::asin(std::min(1.0, down / way.norm())));
    }
    return steepest * 180.0 / std::numbers::pi;
}

TEST(GrooveMilling, DescendsWithinRampAngle) {
    const SpatialCam cam = test::translating_cam();  // its floor is level
    for (const double ramp : {3.0, 10.0}) {
        NcExportOptions options = coarse(cam, 1.0);
        options.milling.ramp_angle = ramp * std::numbers::pi / 180.0;
        const Grooved groove(cam, test::translating_motion(), options);
        EXPECT_EQ(groove.program.fault(), "");
        EXPECT_LT(steepest_way_down(groove), 1.05 * ramp);
        EXPECT_GT(steepest_way_down(groove), 0.5 * ramp);
    }
}

TEST(GrooveMilling, RefusesWhatIsOutsideItsRange) {
    const SpatialCam cam = test::translating_cam();
    const auto refused = [&](double share, auto change) -> std::string {
        NcExportOptions options = coarse(cam, share);
        change(options.milling);
        return testing_support::refusal([&] { (void)nc_work(cam, test::translating_motion(), options); });
    };
    EXPECT_TRUE(says(refused(1.0, [](MillingChoice& m) { m.direction = MillingDirection::climb; }),
                     "both flanks at once"));
    EXPECT_TRUE(says(refused(1.0, [](MillingChoice& m) { m.full_depth = false, m.finish_allowance = 3e-4; }),
                     "roughing cannot leave 0.3 mm"));
    EXPECT_TRUE(says(refused(0.7, [](MillingChoice& m) { m.compensation = CompensationWords::control; }),
                     "for plane cams"));
    EXPECT_TRUE(says(refused(0.7, [](MillingChoice& m) { m.ramp_angle = 0.0; }), "found 0 deg"));
    EXPECT_TRUE(says(refused(0.7, [](MillingChoice& m) { m.ramp_angle = 2.0; }), "<= 90 deg"));
    EXPECT_TRUE(says(refused(0.7, [](MillingChoice& m) { m.ramp_angle = 0.001; }), "passes to and fro"));
}

}  // namespace groove_milling_test
}  // namespace camopt
