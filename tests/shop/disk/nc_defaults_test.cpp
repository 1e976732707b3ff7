// SPDX-License-Identifier: MIT
// What a program does without being asked: roughing, arcs, the fixture, plain text.
#include "core/errors.hpp"
#include "profiles/spatial/reference_cams.hpp"
#include "shop/disk/disk_export.hpp"
#include "shop/nc/spoiled_programs.hpp"
#include "shop/spatial/cam_export.hpp"
#include "tests/shop/disk/harmonic_disk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace camopt {
namespace nc_defaults_test {

constexpr double millimetre = 1e-3, turn = 2.0 * std::numbers::pi, dwell = 2.0;  // rad

/// A roller of 10 mm on a base circle of 40 mm: a dwell of 2 rad, then a harmonic of 10 mm.
ProfileShape dwelling_disk() {
    ProfileShape shape;
    shape.cam = testing_support::roller_cam();
    shape.at = [cam = shape.cam](double theta) {
        const double half = 5.0 * millimetre, rate = turn / (turn - dwell), phase = rate * (theta - dwell);
        if (theta <= dwell) return testing_support::point_at(cam, theta, {0.0, 0.0, 0.0});
        return testing_support::point_at(cam, theta,
                                         {half * (1.0 - std::cos(phase)), half * rate * std::sin(phase),
                                          half * rate * rate * std::cos(phase)});
    };
    shape.knots = {0.0, dwell, turn};
    return shape;
}

DiskNcOptions of_22_mm() {
    DiskNcOptions options;
    options.thickness = 22.0 * millimetre;
    options.cutter_diameter = 12.0 * millimetre;
    options.chord_tolerance = 2e-5;
    return options;
}

struct Made {
    std::unique_ptr<Machine> machine = plane_milling_machine();
    PostProcessor post = generic_post(*machine);
    ProfileShape shape = dwelling_disk();
    NcWork work;
    CheckedProgram program;

    explicit Made(const DiskNcOptions& options)
        : work(disk_nc_work(shape, options)), program(checked_program(*machine, post, work)) {}
    [[nodiscard]] bool has(const std::string& words) const {
        return program.program.text.find(words) != std::string::npos;
    }
    [[nodiscard]] bool check_has(const std::string& words) const {
        return nc_check_text(program).find(words) != std::string::npos;
    }
};

TEST(NcDefaults, RoughingLayersAreHalfCutterDeep) {
    const Made made(of_22_mm());
    EXPECT_EQ(made.program.fault(), "");
    EXPECT_TRUE(made.has("(roughing: 4 of 4 layers, 5.75 mm deep each, step-over "))
        << made.program.program.text;
    EXPECT_TRUE(made.has(", for finishing 0.3 mm)"));
    EXPECT_TRUE(made.has("\nG1 Z-5.7500 "));
    EXPECT_FALSE(made.has("slot"));
    double above = 0.0;
    for (const CuttingPass& pass : made.work.task.passes) {
        const double bottom = pass.path(0.0).tip.z();
        EXPECT_LE(above - bottom, 6.0 * millimetre);
        above = bottom;
    }
    EXPECT_NEAR(above, -23.0 * millimetre, 1e-12);
    EXPECT_GT(made.program.roughed.at(0).check.least_stock, 0.29 * millimetre);
}

TEST(NcDefaults, FullDepthNeedsOptionAndWarns) {
    DiskNcOptions options = of_22_mm();
    options.milling.full_depth = true;
    const std::string warning = "the only pass cuts a slot 23 mm deep, 1.9 times the cutter's diameter";
    const std::string loose = ", the ring that it cuts off around the cam comes loose";
    const Made made(options);
    EXPECT_EQ(made.program.fault(), "");
    EXPECT_EQ(made.program.travel.passes, 1);
    EXPECT_TRUE(made.has("(WARNING: " + warning + loose + ")"));
    EXPECT_TRUE(made.check_has("WARNING            " + warning + loose + "\n"));
    options.cutter_diameter = 40.0 * millimetre;
    EXPECT_FALSE(Made(options).has(loose));
    options.milling.step_down = 5.0 * millimetre;
    EXPECT_THROW(static_cast<void>(disk_nc_work(made.shape, options)), InputError);
}

TEST(NcDefaults, DrumsAreRoughedInLayers) {
    NcExportOptions options;
    options.chord_tolerance = 1e-4;
    options.z_offset = 0.12;
    for (const double share : {1.0, 0.9}) {
        const SpatialCam cam = test::translating_cam();
        options.cutter_diameter = share * 2.0 * cam[SpatialDimension::roller_radius];
        const auto machine = machine_for(cam, options.z_offset);
        const CheckedProgram program = checked_program(*machine, generic_post(*machine),
                                                       nc_work(cam, test::translating_motion(), options));
        EXPECT_EQ(program.fault(), "");
        const std::string& text = program.program.text;
        EXPECT_NE(text.find("(pass: roughing, layer 1 of "), std::string::npos);
        EXPECT_EQ(text.find(", for finishing"),
                  share == 1.0 ? std::string::npos : text.find(", for finishing 0.3 mm"));
        EXPECT_NE(text.find("(fixture: the cam is clamped at both ends within diameter "), std::string::npos);
        EXPECT_EQ(text.find("slot"), std::string::npos);
    }
}

TEST(NcDefaults, DwellsAreArcs) {
    for (const CompensationWords words : {CompensationWords::none, CompensationWords::control}) {
        DiskNcOptions options = of_22_mm();
        options.milling.full_depth = true;
        options.milling.compensation = words;
        const Made made(options);
        EXPECT_EQ(made.program.fault(), "");
        EXPECT_LT(made.program.surfaces.at(0).check.stock, 3e-5);
        const double radius =
            words == CompensationWords::none ? 46.0 : 40.0;  // of the cutter's centre, of the base circle
        int arcs = 0;
        Eigen::Vector2d from(NAN, NAN);
        for (const test::TextLine& line : test::lines_of(made.program.program.text)) {
            if (line.words.starts_with("(") || line.words.find(" X") == std::string::npos) continue;
            const Eigen::Vector2d to(
                test::number_of(line.words, "X"),
                line.words.find(" Y") == std::string::npos ? from.y() : test::number_of(line.words, "Y"));
            if (line.words.starts_with("G2 ")) {
                const Eigen::Vector2d center = from + Eigen::Vector2d(test::number_of(line.words, "I"),
                                                                      test::number_of(line.words, "J"));
                if (center.norm() < 1e-3) {
                    ++arcs;
                    EXPECT_NEAR(to.norm(), radius, 2e-4);
                }
            }
            from = to;
        }
        EXPECT_EQ(arcs, 2);  // 2 rad: two pieces of no more than 90 deg
    }
}

TEST(NcDefaults, TitlesAreAsciiWithoutPercent) {
    DiskNcOptions options = of_22_mm();
    options.milling.full_depth = true;
    options.title = "Größe 50 % – ø;\n(x)";
    const Made made(options);
    EXPECT_EQ(made.program.fault(), "");
    const std::string& text = made.program.program.text;
    EXPECT_TRUE(made.has("\n(Groesse 50 percent - oe,  x )\n"));
    EXPECT_TRUE(std::ranges::all_of(
        text, [](char letter) { return letter == '\n' || (letter >= ' ' && letter <= '~'); }));
    EXPECT_EQ(std::ranges::count(text, '%'), 2);
    EXPECT_TRUE(text.starts_with("%\n") && text.ends_with("\n%\n"));
}

TEST(NcDefaults, NoMoveComesWhereClampsLie) {
    DiskNcOptions options = of_22_mm();
    options.milling.full_depth = true;
    const Made made(options);
    EXPECT_TRUE(
        made.has("(fixture: the cam is held by its bore, clamps lie within diameter 75 mm about its axis, at "
                 "most 18 mm above the blank)"));
    EXPECT_TRUE(made.check_has("no move comes within diameter 75 mm about the cam's axis"));
    // Above the cam's upper face, so that it is not gouged; a rapid above the blank.
    NcWork spoiled = made.work;
    std::vector<ToolPose>& way = spoiled.task.passes[0].in.poses;
    const Eigen::Vector3d up(0.0, 0.0, 24.0 * millimetre), down = -Eigen::Vector3d::UnitZ();
    way.insert(way.begin() + 1, {{way[0].tip + up, down}, {{0.02, 0.0, 1.0 * millimetre}, down}});
    CheckedProgram feeds = checked_program(*made.machine, made.post, spoiled);
    feeds.clamp = made.program.clamp;
    verify(feeds, *made.machine, made.post, spoiled);
    EXPECT_NE(feeds.fault().find("where clamps lie"), std::string::npos) << feeds.fault();
    std::string text = made.program.program.text;
    const std::size_t begin = text.find("\nG0 X") + 1;
    text.replace(begin, text.find('\n', begin) - begin, "G0 X10 Y0");
    EXPECT_NE(test::refusal_of(text, made.program, *made.machine, made.post, made.work)
                  .find("a rapid may touch the clamp"),
              std::string::npos);
}

}  // namespace nc_defaults_test
}  // namespace camopt
