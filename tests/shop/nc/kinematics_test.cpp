// SPDX-License-Identifier: MIT
// Cutter locations and machines against the reference numbers of paper 001's example (corrected formulas).
#include "core/errors.hpp"
#include "shop/nc/nc_samples.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camopt {
namespace kinematics_test {

using test::degree;
using test::millimetre;

void expect_mm(const Eigen::Vector3d& found, const Eigen::Vector3d& mm) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found(i) / millimetre, mm(i), 5e-13 * 100.0) << i;
}

TEST(CutterLocation, ReferencePointOfPaper001) {
    const RollerPose roller = test::rotating_roller()(240.0 * degree, 20.0 * millimetre);
    const double radius = 8.0 * millimetre;
    expect_mm(roller.center - radius * roller.normal,
              {56.9626513392401, -28.5893499497106, -26.2609758448353});
    expect_mm(roller.center + radius * roller.normal,
              {50.6040677010072, -33.514324244021, -12.4293800469536});
    const ToolPose cutter = cutter_pose(roller, test::rotating_location(10.0 * millimetre, 0.2 * millimetre));
    expect_mm(cutter.tip, {52.6706073834329, -31.9137075983702, -16.9246486812652});
    EXPECT_NEAR(cutter.axis.x(), -0.845782789417134, 1e-14);
    EXPECT_NEAR(cutter.axis.y(), 0.488312921145936, 1e-14);
    EXPECT_NEAR(cutter.axis.z(), -0.21494642162105, 1e-14);
    const auto machine = table_tilting_machine(test::z_offset);
    const Eigen::VectorXd values = machine->values(cutter);
    EXPECT_NEAR(values(0) / millimetre, -29.7635020353842, 5e-13 * 100.0);
    EXPECT_NEAR(values(1) / millimetre, 1.30277781742056, 5e-14 * 100.0);
    EXPECT_NEAR(values(2) / millimetre, -63.5061236562194, 5e-13 * 100.0);
    EXPECT_NEAR(values(3), -1.0471975511966, 5e-14);
    EXPECT_NEAR(values(4), 0.216636968809034, 5e-15);
}

TEST(CutterLocation, EqualCutterReplacesRollerOnFlanks) {
    const RollerPath roller = test::rotating_roller();
    for (const double theta : test::even(0.0, test::full_turn, 97)) {
        const RollerPose at = roller(theta, 20.0 * millimetre);
        for (const int flank : {1, -1}) {
            const ToolPose cutter = cutter_pose(at, test::rotating_location(16.0 * millimetre, 0.0, flank));
            EXPECT_LT((cutter.tip - at.center).norm(), 5e-17);
        }
    }
}

TEST(CutterLocation, RefusesCutterGougingOtherFlank) {
    EXPECT_THROW(
        static_cast<void>(cutter_path(test::rotating_roller(), test::rotating_location(17.0 * millimetre))),
        InputError);
    EXPECT_THROW(static_cast<void>(
                     cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre, 1e-4))),
                 InputError);
    CutterLocation location = test::rotating_location(10.0 * millimetre);
    location.flank = 0;
    EXPECT_THROW(location.validate(), InputError);
}

TEST(TableTilting, MatchesClosedFormOfBothAxes) {
    const auto machine = table_tilting_machine(test::z_offset);
    const FollowerMotion motion = test::rotating_motion();
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre));
    for (const double theta : test::even(0.0, test::full_turn, 359)) {
        const Eigen::VectorXd values = machine->values(path(theta));
        const double turn = 180.0 * degree - theta;
        EXPECT_NEAR(std::remainder(values(3) - turn, test::full_turn), 0.0, 1e-14);
        EXPECT_NEAR(values(4), -(motion.state(theta).s - 22.5 * degree), 1e-14);
    }
}

TEST(TableTilting, PosesComeBack) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path =
        cutter_path(test::rotating_roller(), test::rotating_location(10.0 * millimetre, 2e-4));
    double tip = 0.0, axis = 0.0;
    for (const double theta : test::even(0.0, test::full_turn, 719)) {
        const ToolPose wanted = path(theta), found = machine->pose(machine->values(wanted));
        tip = std::max(tip, (found.tip - wanted.tip).norm());
        axis = std::max(axis, (found.axis - wanted.axis).norm());
    }
    EXPECT_LT(tip / millimetre, 1e-12);
    EXPECT_LT(axis, 1e-14);
}

TEST(Machines, AnyPoseComesBack) {
    std::mt19937 random(20);
    std::normal_distribution<double> normal;
    const auto five = table_tilting_machine(0.05), four = rotary_table_machine();
    for (int i = 0; i < 1000; ++i) {
        const Eigen::Vector3d tip(normal(random), normal(random), normal(random));
        Eigen::Vector3d axis(normal(random), normal(random), normal(random));
        const ToolPose free{tip, axis.normalized()};
        axis.z() = 0.0;
        const ToolPose square{tip, axis.normalized()};
        for (const auto& [machine, pose] :
             {std::pair{five.get(), free}, {four.get(), square}, {five.get(), square}}) {
            const Eigen::VectorXd values = machine->values(pose);
            const ToolPose found = machine->pose(values);
            EXPECT_LT((found.tip - pose.tip).norm(), 1e-13);
            EXPECT_LT((found.axis - pose.axis).norm(), 1e-13);
            EXPECT_LE(values.tail(values.size() - 3).cwiseAbs().maxCoeff(), std::numbers::pi);
        }
    }
}

TEST(Machines, RefuseWhatTheyCannotTake) {
    const ToolPose along{{0, 0, 0}, Eigen::Vector3d::UnitZ()};
    EXPECT_THROW(static_cast<void>(table_tilting_machine(0.0)->values(along)), InputError);
    EXPECT_THROW(static_cast<void>(rotary_table_machine()->values(along)), InputError);
    EXPECT_THROW(static_cast<void>(plane_milling_machine()->values(along)), InputError);
    EXPECT_THROW(static_cast<void>(table_tilting_machine(NAN)), InputError);
}

TEST(RotaryTable, SpatialCamsRotateWithCamAngle) {
    const auto machine = rotary_table_machine();
    CutterLocation location;
    location.roller_radius = 31.75 * millimetre;
    location.diameter = 63.5 * millimetre;
    location.station = 38.1 * millimetre;
    const ToolPath path = cutter_path(roller_path(test::barrel_cam(), test::barrel_motion()), location);
    const FollowerMotion motion = test::barrel_motion();
    for (const double theta : test::even(0.0, test::full_turn, 181)) {
        const ToolPose wanted = path(theta);
        const Eigen::VectorXd values = machine->values(wanted);
        EXPECT_NEAR(std::remainder(values(3) - theta, test::full_turn), 0.0, 1e-14);
        const double index = -std::numbers::pi / 7.0 + motion.state(theta).s;
        EXPECT_NEAR(values(0), -0.164 * std::sin(index), 1e-15);
        EXPECT_NEAR(values(2), 0.150 - 0.0381, 1e-15);
        EXPECT_LT((machine->pose(values).tip - wanted.tip).norm(), 1e-15);
    }
}

// θ in (−179.5°, 179.5°): the printed equations (20)-(24), with the one-valued arc tangent of the paper.
TEST(PrintedFormulas, ReverseToolAndMirrorCam) {
    const auto machine = table_tilting_machine(test::z_offset);
    const ToolPath path = cutter_path(test::rotating_roller(), test::rotating_location(16.0 * millimetre));
    int reversed = 0;
    for (int k = 1; k < 360; ++k) {
        const Eigen::Vector3d o = path(k * degree).axis;
        const double turn = std::atan(o.x() / o.y());
        const double tilt = std::atan(-o.z() / (o.x() * std::sin(turn) + o.y() * std::cos(turn)));
        const ToolPose found = machine->pose(Eigen::Vector<double, 5>{0, 0, 0, turn, tilt});
        if (found.axis.dot(o) < 0.0) ++reversed;
    }
    EXPECT_EQ(reversed, 179);
    const double turn = 0.3, tilt = 0.2;
    const double s0 = std::sin(turn), c0 = std::cos(turn), s1 = std::sin(tilt), c1 = std::cos(tilt);
    const Eigen::Matrix3d printed{{s0 * s1, c0 * s1, c1}, {c0, -s0, 0}, {-s0 * c1, -c0 * c1, s1}};
    EXPECT_NEAR(printed.determinant(), -1.0, 1e-15);
}

}  // namespace kinematics_test
}  // namespace camopt
