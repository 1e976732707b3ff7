// SPDX-License-Identifier: MIT
// Programs printed, read back and checked by the machine's forward kinematics.
#include "core/errors.hpp"
#include "shop/nc/nc_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace program_test {

using test::degree;
using test::millimetre;

NcPoseCheck printed_and_checked(const Machine& machine, const PostProcessor& post,
                                const std::vector<ToolPose>& poses) {
    const NcProgram program = nc_program(machine, post, test::job_of(poses));
    return check_poses(read_nc_text(program.text, machine, post), machine, post, poses);
}

TEST(NcProgram, ReadsBackWithinTheLastDigit) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path =
        cutter_path(test::rotating_roller(), test::rotating_location(10.0 * millimetre, 2e-4));
    const std::vector<ToolPose> poses = test::poses_at(path, test::even(0.0, test::full_turn, 720));
    for (const int decimals : {2, 4, 6, 9}) {
        PostProcessor post = generic_post(*machine);
        post.linear_decimals = post.angle_decimals = decimals;
        const NcPoseCheck check = printed_and_checked(*machine, post, poses);
        EXPECT_EQ(check.blocks, 721);
        EXPECT_TRUE(check.within_rounding) << decimals;
        EXPECT_GT(check.tip_deviation, 0.1 * check.tip_rounding) << decimals;  // the bound is not idle
        EXPECT_LT(check.tip_rounding, std::pow(10.0, -decimals) * 4.0 * millimetre) << decimals;
    }
}

TEST(NcProgram, UnitsSignsAndOffsetsRoundTrip) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre));
    const std::vector<ToolPose> poses = test::poses_at(path, test::even(0.0, test::full_turn, 90));
    PostProcessor post = generic_post(*machine);
    post.unit = LengthUnit::inch;
    post.linear_decimals = 5;
    post.block_step = 10;
    post.comment_begin = ";";
    post.comment_end = "";
    post.axes["rotary"] = {"A", -1, 90.0 * degree};
    post.axes["y"] = {"Z", -1, 3.0 * millimetre};
    post.axes["z"] = {"Y", 1, 0.0};
    EXPECT_TRUE(printed_and_checked(*machine, post, poses).within_rounding);
    post.modal = false;
    EXPECT_TRUE(printed_and_checked(*machine, post, poses).within_rounding);
}

TEST(NcProgram, RotaryAxesRunOn) {
    const auto machine = rotary_table_machine();
    CutterLocation location;
    location.roller_radius = 10.0 * millimetre;
    location.diameter = 20.0 * millimetre;
    location.station = 15.0 * millimetre;
    const ToolPath path =
        cutter_path(roller_path(test::translating_cam(), test::translating_motion()), location);
    const NcProgram program =
        nc_program(*machine, generic_post(*machine),
                   test::job_of(test::poses_at(path, test::even(0.0, test::full_turn, 72))));
    for (std::size_t i = 1; i < program.values.size(); ++i)
        EXPECT_NEAR(program.values[i](3) - program.values[i - 1](3), 5.0 * degree, 1e-12);
    EXPECT_NEAR(program.values.back()(3), test::full_turn, 1e-12);
}

TEST(NcProgram, TimeOfBlocks) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre));
    NcJob job = test::job_of(test::poses_at(path, test::even(0.0, test::full_turn, 360)));
    PostProcessor post = generic_post(*machine);
    post.feed_decimals = 9;
    job.feed = 8.0 * millimetre;
    const auto seconds_of = [&] {
        const NcProgram program = nc_program(*machine, post, job);
        const NcPoseCheck check =
            check_poses(read_nc_text(program.text, *machine, post), *machine, post, job.passes[0].poses);
        EXPECT_NEAR(check.cutting_seconds, program.seconds, 1e-6 * program.seconds);
        return check.cutting_seconds;
    };
    double length = 0.0;
    for (std::size_t i = 1; i < job.passes[0].poses.size(); ++i)
        length += (job.passes[0].poses[i].tip - job.passes[0].poses[i - 1].tip).norm();
    EXPECT_NEAR(seconds_of(), length / job.feed, 1e-6 * length / job.feed);
    job.rotary_speed = 1.0 * degree;  // far slower: 360 s a turn
    EXPECT_NEAR(seconds_of(), 360.0, 1e-3);
}

/// The paper's equations (20)-(24) as printed, or with atan2 and the printed sign of Y only.
class PrintedMachine final : public Machine {
 public:
    PrintedMachine(const Machine& real, bool four_quadrants) : real_(real), four_quadrants_(four_quadrants) {}
    std::string name() const override { return "printed"; }
    const std::vector<MachineAxis>& axes() const override { return real_.axes(); }
    Eigen::VectorXd values(const ToolPose& pose) const override {
        const Eigen::Vector3d &o = pose.axis, &t = pose.tip;
        const double turn = angle(o.x(), o.y());
        const double s0 = std::sin(turn), c0 = std::cos(turn);
        const double tilt = angle(-o.z(), o.x() * s0 + o.y() * c0);
        const double s1 = std::sin(tilt), c1 = std::cos(tilt);
        return Eigen::Vector<double, 5>{
            t.x() * s0 * s1 + t.y() * c0 * s1 + t.z() * c1, t.x() * c0 - t.y() * s0,
            -t.x() * s0 * c1 - t.y() * c0 * c1 + t.z() * s1 - test::z_offset, turn, tilt};
    }
    ToolPose pose(const Eigen::VectorXd& values) const override { return real_.pose(values); }

 private:
    [[nodiscard]] double angle(double y, double x) const {
        return four_quadrants_ ? std::atan2(y, x) : std::atan(y / x);
    }
    const Machine& real_;
    bool four_quadrants_;
};

TEST(NcProgram, PrintedFormulasFailTheSameCheck) {
    const auto machine = table_tilting_machine(test::z_offset);
    const PostProcessor post = generic_post(*machine);
    // A cutter smaller than the roller: the roller's own axis has Y = 0 here, where a mirror shows nothing.
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(10.0 * millimetre));
    std::vector<double> angles;
    for (int k = 1; k < 360; ++k) angles.push_back(k * degree);
    const std::vector<ToolPose> poses = test::poses_at(path, angles);
    EXPECT_TRUE(printed_and_checked(*machine, post, poses).within_rounding);
    for (const bool four_quadrants : {false, true}) {
        const PrintedMachine printed(*machine, four_quadrants);
        const NcProgram program = nc_program(printed, post, test::job_of(poses));
        const NcPoseCheck check =
            check_poses(read_nc_text(program.text, *machine, post), *machine, post, poses);
        EXPECT_FALSE(check.within_rounding);
        EXPECT_GT(check.tip_deviation, 1.0 * millimetre);
        if (four_quadrants)
            EXPECT_LT(check.axis_deviation, 1e-6);
        else
            EXPECT_NEAR(check.axis_deviation, 180.0 * degree, 1e-6);
    }
}

TEST(NcProgram, ADigitChangedIsFound) {
    const auto machine = table_tilting_machine(test::z_offset);
    const PostProcessor post = generic_post(*machine);
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(10.0 * millimetre));
    const std::vector<ToolPose> poses = test::poses_at(path, test::even(3.2, 6.1, 50));
    const std::string text = nc_program(*machine, post, test::job_of(poses)).text;
    std::mt19937 random(5);
    // The way out and the rapid after it have no poses: where they go is nc_travel_test.cpp's.
    const std::size_t first = text.find("\nG93"), last = text.rfind("G94");
    int changed = 0;
    while (changed < 50) {
        std::string broken = text;
        const std::size_t place = std::uniform_int_distribution<std::size_t>(first, last)(random);
        const std::size_t word = broken.find_last_of("XYZBCFGMN\n", place);
        // A digit of an axis before its last decimal, which alone is within rounding.
        if (std::string_view("XYZBC").find(broken[word]) == std::string_view::npos) continue;
        if (broken[place] < '0' || broken[place] > '9' || broken[place + 1] < '0' || broken[place + 1] > '9')
            continue;
        broken[place] = broken[place] == '9' ? '0' : static_cast<char>(broken[place] + 1);
        ++changed;
        EXPECT_FALSE(check_poses(read_nc_text(broken, *machine, post), *machine, post, poses).within_rounding)
            << broken.substr(word, 12);
    }
}

TEST(NcProgram, RefusesWrongJobs) {
    const auto machine = table_tilting_machine(0.0);
    const PostProcessor post = generic_post(*machine);
    const ToolPose pose{{0.1, 0, 0}, {0, -1, 0}};
    NcJob job = test::job_of({pose});
    EXPECT_NO_THROW(static_cast<void>(nc_program(*machine, post, job)));
    PostProcessor per_minute = post;
    per_minute.feed_mode = FeedMode::per_minute;
    EXPECT_THROW(static_cast<void>(nc_program(*machine, per_minute, job)), InputError);
    job.feed = 0.0;
    EXPECT_THROW(static_cast<void>(nc_program(*machine, post, job)), InputError);
    job = test::job_of({});
    EXPECT_THROW(static_cast<void>(nc_program(*machine, post, job)), InputError);
    job = test::job_of({ToolPose{{NAN, 0, 0}, {0, -1, 0}}});
    EXPECT_THROW(static_cast<void>(nc_program(*machine, post, job)), InputError);
    PostProcessor without = post;
    without.axes.erase("tilt");
    EXPECT_THROW(static_cast<void>(nc_program(*machine, without, test::job_of({pose}))), InputError);
}

TEST(NcProgram, AnotherNumberOfBlocksIsRefused) {
    const auto machine = table_tilting_machine(0.0);
    const PostProcessor post = generic_post(*machine);
    const ToolPose pose{{0.1, 0, 0}, {0, -1, 0}};
    const NcProgram program = nc_program(*machine, post, test::job_of({pose, pose}));
    const auto moves = read_nc_text(program.text, *machine, post);
    EXPECT_NO_THROW(static_cast<void>(check_poses(moves, *machine, post, std::vector{pose, pose})));
    EXPECT_THROW(static_cast<void>(check_poses(moves, *machine, post, std::vector{pose})), InputError);
    EXPECT_THROW(static_cast<void>(check_poses(moves, *machine, post, std::vector{pose, pose, pose})),
                 InputError);
}

}  // namespace program_test
}  // namespace camopt
