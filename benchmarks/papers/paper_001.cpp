// SPDX-License-Identifier: MIT
#include "benchmarks/papers/papers.hpp"
#include "benchmarks/papers/spatial_tables.hpp"
#include "core/units.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

namespace camopt {

namespace {

using namespace spatial_tables;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using units::degree;
using units::millimetre;

using units::turn;
// Chosen: the paper gives no dimension at all.
constexpr double cutter_diameter_mm = 10.0, allowance_mm = 0.2, tool_length_mm = 120.0;
constexpr double offset_of_the_test_mm = 12.0;

Example indexing_cam() {
    Example example;
    SpatialCam& cam = example.cam;
    cam.follower = SpatialFollower::cylindrical_rotating;
    cam.rotation = Rotation::clockwise;
    cam.dimensions = {8.0 * millimetre, 70.0 * millimetre, 150.0 * millimetre, 0.0};
    cam.start = -22.5 * degree;
    cam.roller_length = 20.0 * millimetre;
    example.motion = modified_sine_rise({0.0, 180.0 * degree, 180.0 * degree, 45.0 * degree, turn});
    return example;
}

enum class Reading { printed, corrected };

/// How far a contact point is from meshing: |n · V|/|V| there, V the relative velocity at its place on the
/// roller. Printed: with Q_z = r_r cos(φ_z ± 90) tan φ_y; corrected: Q_z = 0. The largest over the rise.
double meshing_residual(double offset_mm, Reading reading) {
    const Example example = indexing_cam();
    const SpatialCam& cam = example.cam;
    const double dx = offset_mm * millimetre, dy = cam[SpatialDimension::center_distance];
    double largest = 0.0;
    for (int i = 361; i < 720; ++i)
        for (const double r : {0.0, 0.5 * cam.roller_length, cam.roller_length}) {
            const FollowerState state = example.motion.state(0.5 * i * degree);
            const double c = std::cos(cam.start + state.s), s = std::sin(cam.start + state.s);
            const auto velocity = [&](double rho) {
                return Vector3d(-(dy - rho * c), rho * state.velocity + dx * s, -dx * c);
            };
            const double rho = cam[SpatialDimension::arm_length] + r;
            const Vector3d v = velocity(rho);
            const double angle = std::atan2(v.y(), v.x()) + 0.5 * std::numbers::pi;
            const Vector3d normal(std::cos(angle), std::sin(angle), 0.0);
            const double shift =
                cam[SpatialDimension::roller_radius] * normal.x() * std::tan(std::atan2(v.z(), v.x()));
            const Vector3d there = velocity(reading == Reading::printed ? rho + shift : rho);
            largest = std::max(largest, std::abs(normal.dot(there)) / there.norm());
        }
    return largest;
}

/// θ0, θ1 of (20), (21), with tan⁻¹ as printed or with atan2.
struct TableAngles {
    double first = 0.0, second = 0.0;
};

TableAngles table_angles(const Vector3d& axis, Reading reading) {
    TableAngles angles;
    const auto arc = [reading](double y, double x) {
        return reading == Reading::printed ? std::atan(y / x) : std::atan2(y, x);
    };
    angles.first = arc(axis.x(), axis.y());
    angles.second = arc(-axis.z(), axis.x() * std::sin(angles.first) + axis.y() * std::cos(angles.first));
    return angles;
}

/// (22) to (24) without the tool's length. `sign` of the second row: −1 corrected, +1 as printed.
Matrix3d machine_matrix(const TableAngles& angles, double sign) {
    const double s0 = std::sin(angles.first), c0 = std::cos(angles.first), s1 = std::sin(angles.second),
                 c1 = std::cos(angles.second);
    Matrix3d matrix;
    matrix << s0 * s1, c0 * s1, c1, sign * c0, -sign * s0, 0.0, -s0 * c1, -c0 * c1, s1;
    return matrix;
}

/// The machine's spindle points along −z; in so many positions the cutter's axis is turned the other way.
int reversed_positions(const Example& example, int positions, Reading reading) {
    int reversed = 0;
    for (int i = 1; i <= positions; ++i) {
        const double theta = turn * i / (positions + 1);
        const Vector3d axis = roller_axis(example.cam, theta, example.motion.state(theta).s).direction;
        const Vector3d in_machine = machine_matrix(table_angles(axis, reading), -1.0) * axis;
        if (in_machine.z() > 0.0) ++reversed;
    }
    return reversed;
}

struct Pose {
    Vector3d tip, axis;  ///< T, O
    TableAngles angles;
};

/// (11) to (15), (20), (21) with atan2.
Pose pose_at(const Example& example, double theta) {
    const SpatialCam& cam = example.cam;
    const FollowerState state = example.motion.state(theta);
    const Vector3d upper = spatial_point(cam, theta, state, {cam.roller_length, -1}).contact;
    const Vector3d lower = spatial_point(cam, theta, state, {cam.roller_length, 1}).contact;
    const double roller_diameter_mm = 2.0 * cam[SpatialDimension::roller_radius] / millimetre;
    const double share = (cutter_diameter_mm + 2.0 * allowance_mm) / (2.0 * roller_diameter_mm);
    const Vector3d axis = roller_axis(cam, theta, state.s).direction;
    return {lower + share * (upper - lower), axis, table_angles(axis, Reading::corrected)};
}

PaperTable point_table(const Example& example) {
    const double theta = 240.0 * degree;
    const SpatialCam& cam = example.cam;
    const FollowerState state = example.motion.state(theta);
    PaperTable table{
        "points_240",
        "One position: cam angle 240 deg, far end of the roller",
        fmt::format("U, D: the two contacts; T: tip of a cutter of {} mm with {} mm of stock; O: its "
                    "axis; the machine with a tool of {} mm.",
                    cutter_diameter_mm, allowance_mm, tool_length_mm),
        {{"quantity", "quantity", ""},
         {"x", "x", "", 14},
         {"y", "y", "", 14},
         {"z", "z", "", 14},
         {"unit", "unit", ""}},
        {}};
    const auto add = [&](const std::string& name, const Vector3d& value, const std::string& unit) {
        table.rows.push_back({name, value.x(), value.y(), value.z(), unit});
    };
    add("follower: angle, slope, second slope", {cam.start + state.s, state.velocity, state.acceleration},
        "rad");
    for (const int flank : {-1, 1})
        add(flank < 0 ? "U" : "D",
            spatial_point(cam, theta, state, {cam.roller_length, flank}).contact / millimetre, "mm");
    const Pose pose = pose_at(example, theta);
    add("T", pose.tip / millimetre, "mm");
    add("O", pose.axis, "");
    const Vector3d length(0.0, 0.0, tool_length_mm);
    add("machine X, Y, Z (corrected)", machine_matrix(pose.angles, -1.0) * pose.tip / millimetre - length,
        "mm");
    add("machine X, Y, Z (as printed)", machine_matrix(pose.angles, 1.0) * pose.tip / millimetre - length,
        "mm");
    table.rows.push_back({std::string("table angles θ0, θ1"), pose.angles.first, pose.angles.second,
                          cell_of(std::nullopt), std::string("rad")});
    return table;
}

PaperTable formula_table(const Example& example) {
    const Pose pose = pose_at(example, 240.0 * degree);
    constexpr int positions = 359;
    PaperTable table{"formulas",
                     "The printed formulas put to the test",
                     "",
                     {{"formula", "formula", ""},
                      {"measure", "what is measured", ""},
                      {"as_printed", "as printed", "", 4},
                      {"corrected", "corrected", "", 4}},
                     {}};
    for (const double offset : {offset_of_the_test_mm, 0.0})
        table.rows.push_back(
            {std::string("(10)"), fmt::format("|n · V|/|V| at the contact, dx = {} mm", offset),
             meshing_residual(offset, Reading::printed), meshing_residual(offset, Reading::corrected)});
    table.rows.push_back({std::string("(20), (21)"),
                          fmt::format("positions of {} with the tool's axis reversed", positions),
                          static_cast<double>(reversed_positions(example, positions, Reading::printed)),
                          static_cast<double>(reversed_positions(example, positions, Reading::corrected))});
    table.rows.push_back({std::string("(22)-(24)"), std::string("determinant; a motion has +1"),
                          machine_matrix(pose.angles, 1.0).determinant(),
                          machine_matrix(pose.angles, -1.0).determinant()});
    return table;
}

}  // namespace

PaperReport paper_001(const SolveControl&, const PaperProgress& finished) {
    const Example example = indexing_cam();
    PaperReport report;
    report.id = "001";
    report.title = "Open cylindrical cam with a rotating follower";
    report.source =
        "B. K. Gu, J. H. Shin, D. W. Kang, S. W. Chang, \"A Study On the Manufacturing process of "
        "Cylindrical Cam based on Relative Velocity Method and Inverse Kinematics\"";
    report.introduction =
        "A cylindrical cam turns a follower that carries rollers around it. The paper holds no dimension "
        "and no result in numbers: what is shown here is its formulas, corrected, on an example of ours.";
    report.assumptions = {
        "all of it: dx = dz = 0, dy = 150 mm, f_l = 70 mm, roller 8 mm x 20 mm, eight rollers",
        "45 deg in 180 deg by the modified sine, dwell from 0 to 180 deg",
        fmt::format("cutter {} mm, stock {} mm, tool length {} mm", cutter_diameter_mm, allowance_mm,
                    tool_length_mm)};
    report.tables = {formula_table(example), pressure_table(example), undercut_table(example),
                     point_table(example), forward_table(example, {361, 1441, 1601}, finished)};
    report.figures = {
        displacement_figure(example, "figure_5", "Fig. 5: displacement, velocity, acceleration"),
        unrolled_figure(example, "figure_6", "Fig. 6: flanks of one roller's track, unrolled"),
        pressure_figure(example), undercut_figure(example)};
    report.notes = {
        "(1), (6): indices; M_j^0 is M_f^0, A_j^5 is A_f^5.",
        "(10): Q_z is 0. The printed form violates meshing unless dx = 0.",
        "(15): R_f is a direction: without the homogeneous 1.",
        "(20), (21): tan⁻¹ needs both arguments' signs (atan2).",
        "(22) to (24) are a mirror image: their determinant is −1. The smallest repair is the sign of (23); "
        "exchanging X and Y is an equally valid one, as the drawing of the machine is missing.",
        "(2) to (5), (7) to (9), (11) to (14) are right.",
        fmt::format(
            "The flanks by relative velocity (the paper's method) and by envelope differ by at most {:.1e} "
            "mm.",
            method_difference_mm(example))};
    return report;
}

}  // namespace camopt
