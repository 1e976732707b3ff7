// SPDX-License-Identifier: MIT
// Roughing, ways in and out, direction and compensation around plane cams; programs with one fault each.
#include "core/errors.hpp"
#include "shop/disk/disk_export.hpp"
#include "shop/nc/spoiled_programs.hpp"
#include "tests/shop/disk/harmonic_disk.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace camopt {
namespace disk_milling_test {

using testing_support::refusal;
using testing_support::says;

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double millimetre = 1e-3;

/// 50 mm and six waves of 4 mm, hollows of 21.6 mm; or a circle. Its cam angle runs either way.
ProfileShape waves(double wave, bool clockwise = false, double r = 50.0 * millimetre) {
    ProfileShape shape;
    shape.at = [wave, clockwise, r](double theta) {
        const double way = clockwise ? -theta : theta;
        const double radius = r + wave * std::cos(6.0 * way), slope = -6.0 * wave * std::sin(6.0 * way);
        const Eigen::Vector2d out(std::cos(way), std::sin(way)), along(-out.y(), out.x());
        MechanismPoint point;
        point.regularity = 1.0;
        point.contact << radius * out, 0.0;
        point.normal << (radius * out - slope * along).normalized(), 0.0;
        return point;
    };
    shape.knots = {0.0, 1.0, turn};
    shape.closed = true;
    return shape;
}

DiskNcOptions coarse() {
    DiskNcOptions options;
    options.chord_tolerance = 1e-5;
    options.cutter_diameter = 16.0 * millimetre;
    options.milling.full_depth = true;
    return options;
}

DiskNcOptions coarse_roughing(double step_over, double step_down = 1.0) {
    DiskNcOptions options = coarse();
    options.milling.full_depth = false;
    options.milling.step_over = step_over;
    options.milling.step_down = step_down;
    return options;
}

struct Milled {
    std::unique_ptr<Machine> machine = plane_milling_machine();
    PostProcessor post = generic_post(*machine);
    ProfileShape shape;
    NcWork work;
    CheckedProgram program;

    Milled(ProfileShape cam, const DiskNcOptions& options)
        : shape(std::move(cam)),
          work(disk_nc_work(shape, options)),
          program(checked_program(*machine, post, work)) {}
    [[nodiscard]] std::string refusal(const std::string& text) const {
        return test::refusal_of(text, program, *machine, post, work);
    }
    /// The first line that holds this, after the one that holds `pass`, put in other words.
    [[nodiscard]] std::string with(const std::string& pass, const std::string& begin,
                                   const std::string& words) const {
        bool inside = false;
        for (const test::TextLine& line : test::lines_of(program.program.text)) {
            inside = inside || line.words.find(pass) != std::string::npos;
            if (inside && line.words.find(begin) == 0)
                return test::with_line(program.program.text, line, words);
        }
        ADD_FAILURE() << "no " << begin << " after " << pass;
        return {};
    }
};

/// Twice the area that the feeds of the last pass run around, from the text alone; arcs as their chords, mm².
double area_of_last_pass(const std::string& text) {
    const std::size_t pass = text.rfind("(pass:");
    double area = 0.0, x = NAN, y = NAN;
    for (const test::TextLine& line : test::lines_of(text.substr(pass))) {
        const double before_x = x, before_y = y;
        if (line.words.find(" X") != std::string::npos) x = test::number_of(line.words, "X");
        if (line.words.find(" Y") != std::string::npos) y = test::number_of(line.words, "Y");
        if (std::isfinite(before_x) && std::isfinite(before_y)) area += before_x * y - before_y * x;
    }
    return area;
}

TEST(DiskMilling, RoughingLayersLeaveAllowance) {
    DiskNcOptions options = coarse_roughing(3.0 * millimetre, 8.0 * millimetre);
    options.milling.finish_allowance = 0.4 * millimetre;
    const Milled milled(waves(4.0 * millimetre), options);
    EXPECT_EQ(milled.program.fault(), "");
    // 13 mm stand off the hollows: five rings; 21 mm deep: three layers.
    EXPECT_TRUE(says(milled.program.program.text, "(pass: roughing, layer 3 of 3, ring 5 of 5)"));
    // The outer rings leave the blank at each of six lobes. Down and up is longer in lower layers, which
    // joins some parts.
    EXPECT_TRUE(
        says(milled.program.program.text, "(pass: roughing, layer 1 of 3, ring 1 of 5, part 6 of 6)"));
    EXPECT_EQ(milled.program.travel.passes, 36);
    ASSERT_EQ(milled.program.roughed.size(), 1u);
    const NcSurfaceCheck& rough = milled.program.roughed[0].check;
    EXPECT_GT(rough.least_stock, 0.4 * millimetre - 1e-6);
    EXPECT_LT(rough.stock, 0.5 * millimetre);
    EXPECT_LT(milled.program.surfaces[0].check.stock, 2e-5);
    EXPECT_GT(milled.program.direction.climb, 1000);
    EXPECT_EQ(milled.program.direction.conventional, 0);
}

// The hollows have 21.6 mm, the outer rings of a cutter of 30 mm more: what crosses itself is left out.
TEST(DiskMilling, CrossingRingsLeaveAllowance) {
    DiskNcOptions options = coarse_roughing(6.0 * millimetre);
    options.cutter_diameter = 30.0 * millimetre;
    const Milled milled(waves(4.0 * millimetre), options);
    EXPECT_EQ(milled.program.fault(), "");
    EXPECT_GT(milled.program.roughed[0].check.least_stock, 0.3 * millimetre - 1e-6);
}

// Where the roughing ring's offset is just larger than a hollow, it runs back a little without a gouge.
TEST(DiskMilling, RoughingNeverRunsBackInHollows) {
    const double hollow = 46.0 * 46.0 / 98.0 * millimetre;  // r² / (r'' − r) where r = 46, r'' = 144
    for (const double beyond : {0.2, 0.25, 0.3}) {
        SCOPED_TRACE(beyond);
        DiskNcOptions options = coarse_roughing(20.0 * millimetre);
        options.milling.finish_allowance = 0.5 * millimetre;
        options.cutter_diameter = 2.0 * (hollow + (beyond - 0.5) * millimetre);
        const Milled milled(waves(4.0 * millimetre), options);
        EXPECT_EQ(milled.program.fault(), "");
        EXPECT_EQ(milled.program.direction.conventional, 0);
    }
}

// A cam as large as a table: the polygon of the finished cam is as fine as that of a small one.
TEST(DiskMilling, RoughsLargeCams) {
    DiskNcOptions options = coarse_roughing(16.0 * millimetre);
    options.chord_tolerance = 1e-4;
    const Milled milled(waves(1.0 * millimetre, false, 6.5), options);
    EXPECT_EQ(milled.program.fault(), "");
    EXPECT_LT(milled.program.roughed[0].check.stock, 0.5 * millimetre);
}

/// Part of the feed path along which the cutter does not reach the blank from the side.
double part_in_air(const Milled& milled) {
    const double reach = milled.work.job.blank.radius + 0.5 * milled.work.task.cutter.diameter;
    double all = 0.0, in_air = 0.0;
    Eigen::VectorXd from = Eigen::Vector3d::Constant(NAN);
    for (const auto& [move, role, pass] : milled.program.moves) {
        if (role != MoveRole::rapid) {
            const double length = linear_length(from, move);
            all += length;
            if (from.head<2>().norm() > reach && move.values.head<2>().norm() > reach) in_air += length;
        }
        from = move.values;
    }
    return in_air / all;
}

TEST(DiskMilling, RoughingRingsEndAtTheBlank) {
    const Milled milled(testing_support::harmonic_disk(40.0 * millimetre), coarse_roughing(6.0 * millimetre));
    EXPECT_EQ(milled.program.fault(), "");
    EXPECT_LT(part_in_air(milled), 0.2);  // 0.5 with whole rings
    EXPECT_LT(milled.program.roughed[0].check.stock, 0.4 * millimetre);
    EXPECT_EQ(milled.program.direction.conventional, 0);
}

TEST(DiskMilling, RoughingBelowItsStockIsRefused) {
    DiskNcOptions options = coarse_roughing(16.0 * millimetre);
    Milled milled(waves(0.0), options);
    ASSERT_EQ(milled.program.fault(), "");
    // The same text, of which 0.3 mm more is wanted.
    for (CuttingPass& pass : milled.work.task.passes)
        if (pass.roughs) pass.stock += 0.3 * millimetre;
    EXPECT_TRUE(says(milled.refusal(milled.program.program.text), "roughing must leave 0.6 mm"));
    // Another text, whose rings lie 0.1 mm nearer than what is wanted.
    options.milling.finish_allowance = 0.2 * millimetre;
    NcWork deep = disk_nc_work(milled.shape, options);
    ASSERT_EQ(checked_program(*milled.machine, milled.post, deep).fault(), "");
    for (CuttingPass& pass : deep.task.passes)
        if (pass.roughs) pass.stock = 0.3 * millimetre;
    EXPECT_TRUE(
        says(checked_program(*milled.machine, milled.post, deep).fault(), "roughing must leave 0.3 mm"));
}

/// Why a program with these ways in is refused; its poses are what is wanted.
std::string refusal_of_way_in(const Milled& milled, const DiskNcOptions& options,
                              const std::function<void(CuttingPass&)>& spoil) {
    NcWork work = disk_nc_work(milled.shape, options);
    spoil(work.task.passes.back());
    std::string fault;
    const std::string refused =
        refusal([&] { fault = checked_program(*milled.machine, milled.post, work).fault(); }, "");
    return refused + fault;
}

TEST(DiskMilling, EntryThroughCamIsRefused) {
    for (const CompensationWords words : {CompensationWords::none, CompensationWords::control}) {
        DiskNcOptions options = coarse();
        options.milling.compensation = words;
        const Milled milled(waves(4.0 * millimetre), options);
        ASSERT_EQ(milled.program.fault(), "");
        // The same two ends, about the centre on the other side of their chord: three quarters, into the cam.
        const std::string round = refusal_of_way_in(milled, options, [](CuttingPass& pass) {
            const Eigen::Vector3d ends = pass.in.poses.back().tip + pass.path(0.0).tip;
            pass.in.arc->center = ends.head<2>() - pass.in.arc->center;
        });
        // From the start to the other side of the cam and back.
        const std::string straight = refusal_of_way_in(milled, options, [](CuttingPass& pass) {
            pass.in.poses.insert(pass.in.poses.begin() + 1,
                                 {{-0.1, 0.01, pass.in.poses[0].tip.z()}, -Eigen::Vector3d::UnitZ()});
        });
        if (words == CompensationWords::none) {
            EXPECT_TRUE(says(round, "enters the finished cam"));
            EXPECT_TRUE(says(straight, "enters the finished cam"));
        } else {  // or no control takes it
            EXPECT_NE(round, "");
            EXPECT_NE(straight, "");
        }
    }
}

TEST(DiskMilling, CorruptedRoughingRapidIsRefused) {
    DiskNcOptions options = coarse_roughing(8.0 * millimetre, 11.0 * millimetre);
    options.chord_tolerance = 1e-4;
    options.gouge_tolerance = 5e-4;
    Milled milled(waves(4.0 * millimetre), options);
    milled.work.task.surfaces.clear();
    ASSERT_EQ(milled.program.fault(), "");
    test::Spoiling how;
    how.heights = {-21.0, -1.0, 1.9};
    how.across = {"X", "Y"};
    const auto spoiled = test::spoiled_programs(milled.program.program.text, how);
    EXPECT_GT(spoiled.size(), 40u);
    for (const test::SpoiledProgram& program : spoiled)
        EXPECT_NE(milled.refusal(program.text), "") << program.kind;
}

// A clockwise spindle climbs where the tool goes clockwise around the cam, the cam to its right.
TEST(DiskMilling, ClimbAndConventionalAreSo) {
    for (const bool cam_clockwise : {false, true})
        for (const MillingDirection direction : {MillingDirection::climb, MillingDirection::conventional})
            for (const SpindleSense spindle : {SpindleSense::clockwise, SpindleSense::counterclockwise}) {
                DiskNcOptions options = coarse();
                options.spindle_rpm = 3000.0;
                options.milling.direction = direction;
                options.milling.spindle = spindle;
                const Milled milled(waves(4.0 * millimetre, cam_clockwise), options);
                EXPECT_EQ(milled.program.fault(), "");
                const std::string& text = milled.program.program.text;
                const bool right = spindle == SpindleSense::clockwise,
                           climbs = direction == MillingDirection::climb;
                EXPECT_EQ(area_of_last_pass(text) < 0.0, climbs == right);
                EXPECT_TRUE(says(text, right ? "S3000 M3" : "S3000 M4"));
                EXPECT_TRUE(
                    says(text, climbs ? "(direction: climb, outside" : "(direction: conventional, outside"));
                EXPECT_EQ(milled.program.direction.climb > 0, climbs);
                EXPECT_EQ(milled.program.direction.conventional > 0, !climbs);
                // The spindle the other way round makes climb conventional.
                const std::size_t place = text.find(right ? "S3000 M3" : "S3000 M4");
                std::string other = text;
                other.replace(place, 8, right ? "S3000 M4" : "S3000 M3");
                EXPECT_TRUE(says(milled.refusal(other), "turns the spindle"));
            }
}

TEST(DiskMilling, WrongDirectionIsRefused) {
    const DiskNcOptions options = coarse();
    Milled milled(waves(4.0 * millimetre), options);
    milled.work.task.passes.back().climbs = false;
    EXPECT_TRUE(says(milled.refusal(milled.program.program.text), "the block is climb, not conventional"));
}

TEST(DiskMilling, ControlCompensationMakesSameCam) {
    for (const MillingDirection direction : {MillingDirection::climb, MillingDirection::conventional}) {
        DiskNcOptions options = coarse();
        options.chord_tolerance = 1e-6;
        options.milling.direction = direction;
        options.milling.compensation = CompensationWords::control;
        options.milling.tool_number = 7;
        const Milled milled(waves(4.0 * millimetre), options);
        EXPECT_EQ(milled.program.fault(), "");
        const std::string& text = milled.program.program.text;
        const bool left = direction == MillingDirection::climb;
        EXPECT_TRUE(says(text, left ? "\nG41 D7 G1 " : "\nG42 D7 G1 "));
        EXPECT_TRUE(says(text, "\nG40 G1 "));
        EXPECT_TRUE(says(text, "\nT7 M6\n"));
        EXPECT_LT(milled.program.surfaces[0].check.gouge, 2e-6);
        EXPECT_LT(milled.program.surfaces[0].check.stock, 2e-6);
        // On the other side of the contour the cutter cuts the cam away; without the words too.
        EXPECT_NE(milled.refusal(milled.with("(pass", left ? "G41" : "G42",
                                             [&] {
                                                 const std::size_t place =
                                                     text.find(left ? "\nG41" : "\nG42") + 1;
                                                 std::string line =
                                                     text.substr(place, text.find('\n', place) - place);
                                                 line.replace(0, 3, left ? "G42" : "G41");
                                                 return line;
                                             }())),
                  "");
        std::string without = text;
        without.erase(text.find(left ? "G41 D7 " : "G42 D7 "), 7);
        EXPECT_TRUE(says(milled.refusal(without), "enters the finished cam"));
    }
}

TEST(DiskMilling, SaysWhatTheProgramLacks) {
    DiskNcOptions options = coarse();
    const auto lacks = [&](const char* what) {
        const Milled milled(waves(0.0), options);
        const bool said =
            milled.program.program.text.find(std::string("(WARNING: no ") + what) != std::string::npos;
        EXPECT_EQ(said, nc_check_text(milled.program).find(std::string("WARNING            no ") + what) !=
                            std::string::npos);
        return said;
    };
    EXPECT_TRUE(lacks("spindle speed"));
    EXPECT_TRUE(lacks("tool call"));
    options.spindle_rpm = 2000.0;
    options.milling.tool_number = 1;
    EXPECT_FALSE(lacks("spindle speed"));
    EXPECT_FALSE(lacks("tool call"));
    NcJob job;
    const auto machine = plane_milling_machine();
    PostProcessor post = generic_post(*machine);
    post.header = {"%", "T1 M06 (M3)"};
    EXPECT_EQ(warnings_of(post, job).size(), 1u);
    post.header = {"S500 M3", "(T1 M6)", "M60"};
    EXPECT_EQ(warnings_of(post, job).size(), 1u);
}

TEST(DiskMilling, RefusesWhatIsOutsideItsRange) {
    const auto machine = plane_milling_machine();
    const PostProcessor post = generic_post(*machine);
    const ProfileShape shape = waves(0.0);
    const auto words_of_refusal = [&](auto change) -> std::string {
        DiskNcOptions options = coarse();
        change(options.milling);
        return refusal([&] { (void)checked_program(*machine, post, disk_nc_work(shape, options)); });
    };
    EXPECT_EQ(
        words_of_refusal([](MillingChoice& m) { m.step_over = 0.02; }),
        "milling: the step-over of roughing must be > 0 mm and no more than the cutter's diameter of 16 mm, "
        "found 20 mm");
    EXPECT_EQ(words_of_refusal([](MillingChoice& m) { m.step_down = 0.0; }),
              "milling: the step-down of roughing must be 0.01 mm or more, found 0 mm");
    EXPECT_EQ(words_of_refusal([](MillingChoice& m) { m.finish_allowance = -1e-4; }),
              "milling: the allowance for finishing must be >= 0 mm, found -0.1 mm");
    EXPECT_EQ(words_of_refusal([](MillingChoice& m) { m.lead_radius = 0.0; }),
              "milling: the radius of the arcs in and out must be 0.1 ... 1000 mm, found 0 mm");
    EXPECT_EQ(words_of_refusal([](MillingChoice& m) { m.tool_number = 0; }),
              "NC job: the tool number must be 1 ... 9999, found 0");
    EXPECT_EQ(words_of_refusal([](MillingChoice& m) { m.compensation_register = 10000; }),
              "NC job: the compensation register (D) must be 1 ... 9999, found 10000");
}

}  // namespace disk_milling_test
}  // namespace camopt
