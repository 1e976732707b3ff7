// SPDX-License-Identifier: MIT
#include "shop/nc/machine.hpp"

#include "core/units.hpp"
#include "shop/nc/requirement.hpp"

namespace camopt {

namespace {

constexpr double pi = std::numbers::pi;
// A tool axis nearer to the rotary axis than this, rad, leaves the turn to rounding.
constexpr double least_tilt_distance = 1e-9;
// What a unit vector out of some hundred operations may be off.
constexpr double upright_rounding = 1e-9;

const MachineAxis x_axis{"x", AxisKind::linear}, y_axis{"y", AxisKind::linear}, z_axis{"z", AxisKind::linear};

Eigen::Matrix3d turn_about_y(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Eigen::Matrix3d{{c, 0, s}, {0, 1, 0}, {-s, 0, c}};
}

Eigen::Matrix3d turn_about_z(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Eigen::Matrix3d{{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

class TableTilting final : public Machine {
 public:
    explicit TableTilting(double z_offset) : z_offset_(z_offset) {
        if (!std::isfinite(z_offset)) throw InputError("the Z offset of the machine must be a finite length");
    }

    std::string name() const override { return "five axes, table turns and tilts"; }
    const std::vector<MachineAxis>& axes() const override { return axes_; }

    Eigen::VectorXd values(const ToolPose& pose) const override {
        const Eigen::Vector3d &o = pose.axis, &t = pose.tip;
        if (std::hypot(o.x(), o.y()) < least_tilt_distance)
            throw InputError(
                "the tool is parallel to the cam's axis: the angle of the table is undetermined");
        const double rotary = std::atan2(o.x(), o.y());
        const double s0 = std::sin(rotary), c0 = std::cos(rotary);
        const double tilt = std::atan2(-o.z(), o.x() * s0 + o.y() * c0);
        const double s1 = std::sin(tilt), c1 = std::cos(tilt);
        const double x = t.x() * s0 * s1 + t.y() * c0 * s1 + t.z() * c1;
        const double y = -t.x() * c0 + t.y() * s0;
        const double z = -t.x() * s0 * c1 - t.y() * c0 * c1 + t.z() * s1 - z_offset_;
        return Eigen::Vector<double, 5>{x, y, z, rotary, tilt};
    }

    ToolPose pose(const Eigen::VectorXd& values) const override {
        const Eigen::Matrix3d from_machine =
            (turn_about_y(0.5 * pi - values(4)) * turn_about_z(values(3) - 0.5 * pi)).transpose();
        const Eigen::Vector3d tip(values(0), values(1), values(2) + z_offset_);
        return {from_machine * tip, -from_machine.col(2)};
    }

 private:
    double z_offset_;
    std::vector<MachineAxis> axes_{
        x_axis, y_axis, z_axis, {"rotary", AxisKind::rotary}, {"tilt", AxisKind::rotary}};
};

class RotaryTable final : public Machine {
 public:
    std::string name() const override { return "four axes, table turns about X"; }
    const std::vector<MachineAxis>& axes() const override { return axes_; }

    Eigen::VectorXd values(const ToolPose& pose) const override {
        const Eigen::Vector3d& o = pose.axis;
        if (!(std::abs(o.z()) <= upright_rounding))
            throw InputError(fmt::format(
                "the tool leans by {:g} deg along the cam's axis: this cam needs a machine with five "
                "axes, not one with four",
                std::asin(o.z()) / units::degree));
        const double rotary = -0.5 * pi - std::atan2(o.y(), o.x());
        const Eigen::Vector3d turned = turn_about_z(rotary) * pose.tip;
        return Eigen::Vector4d{turned.z(), turned.x(), turned.y(),
                               rotary <= -pi ? rotary + 2.0 * pi : rotary};
    }

    ToolPose pose(const Eigen::VectorXd& values) const override {
        const Eigen::Matrix3d from_machine = turn_about_z(-values(3));
        return {from_machine * Eigen::Vector3d(values(1), values(2), values(0)), -from_machine.col(1)};
    }
    AxisRange tool_along_cam_axis() const override { return {0.0, 0.0}; }

 private:
    std::vector<MachineAxis> axes_{x_axis, y_axis, z_axis, {"rotary", AxisKind::rotary}};
};

class PlaneMachine final : public Machine {
 public:
    std::string name() const override { return "three axes"; }
    const std::vector<MachineAxis>& axes() const override { return axes_; }

    Eigen::VectorXd values(const ToolPose& pose) const override {
        if (!((pose.axis + Eigen::Vector3d::UnitZ()).norm() <= upright_rounding))
            throw InputError("a machine with three axes holds its tool along -z only");
        return pose.tip;
    }

    ToolPose pose(const Eigen::VectorXd& values) const override {
        return {values.head<3>(), -Eigen::Vector3d::UnitZ()};
    }
    AxisRange tool_along_cam_axis() const override { return {-1.0, -1.0}; }

 private:
    std::vector<MachineAxis> axes_{x_axis, y_axis, z_axis};
};

// A cutter that is said to equal the roller may differ in the last digits of the unit it was given in.
constexpr double equal_diameters = 1e-9;

constexpr Requirement require_location{"cutter location"};

}  // namespace

Eigen::VectorXd nearest_turn(const Machine& machine, Eigen::VectorXd values, const Eigen::VectorXd& before) {
    for (std::size_t i = 0; i < machine.axes().size(); ++i) {
        if (machine.axes()[i].kind == AxisKind::linear) continue;
        const auto k = static_cast<Eigen::Index>(i);
        values(k) += 2.0 * pi * std::round((before(k) - values(k)) / (2.0 * pi));
    }
    return values;
}

std::unique_ptr<Machine> table_tilting_machine(double z_offset) {
    return std::make_unique<TableTilting>(z_offset);
}

std::unique_ptr<Machine> rotary_table_machine() {
    return std::make_unique<RotaryTable>();
}

std::unique_ptr<Machine> plane_milling_machine() {
    return std::make_unique<PlaneMachine>();
}

void CutterLocation::validate() const {
    require_location(std::isfinite(roller_radius) && roller_radius > 0.0, "the roller radius must be > 0 m",
                     roller_radius);
    require_location(std::isfinite(diameter) && diameter > 0.0, "the cutter diameter must be > 0 m",
                     diameter);
    require_location(std::isfinite(stock) && stock >= 0.0, "the stock must be >= 0 m", stock);
    require_location(flank == 1 || flank == -1, "the flank must be +1 or -1", flank);
    require_location(std::isfinite(station), "the station must be a finite length", station);
    require_location(std::isfinite(tip_beyond) && tip_beyond >= 0.0,
                     "the tip must lie at or beyond the steered station, by >= 0 m", tip_beyond);
    require_location(
        0.5 * diameter + stock <= roller_radius * (1.0 + equal_diameters),
        "cutter radius + stock must not exceed the roller radius, or the other flank is cut away; m",
        0.5 * diameter + stock);
}

bool CutterLocation::makes_both_flanks() const {
    return stock == 0.0 && diameter >= 2.0 * roller_radius * (1.0 - equal_diameters);
}

ToolPose cutter_pose(const RollerPose& roller, const CutterLocation& location) {
    const double radius = location.roller_radius;
    const Eigen::Vector3d near = roller.center + location.flank * radius * roller.normal;
    const Eigen::Vector3d far = roller.center - location.flank * radius * roller.normal;
    const double share = (location.diameter + 2.0 * location.stock) / (4.0 * radius);
    const Eigen::Vector3d steered = near + share * (far - near);
    return {steered + location.tip_beyond * roller.axis, roller.axis};
}

void PlaneCutter::validate() const {
    if (!(std::isfinite(diameter) && diameter > 0.0))
        throw InputError(fmt::format("plane cutter: the diameter must be > 0 m, found {:g}", diameter));
    if (!(std::isfinite(stock) && stock >= 0.0))
        throw InputError(fmt::format("plane cutter: the stock must be >= 0 m, found {:g}", stock));
    if (!std::isfinite(bottom)) throw InputError("plane cutter: the bottom must be a finite height");
}

}  // namespace camopt
