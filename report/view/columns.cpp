// SPDX-License-Identifier: MIT
#include "report/view/columns.hpp"

#include "core/text/list_text.hpp"
#include "report/view/shown_units.hpp"

#include <fmt/format.h>

#include <iterator>

namespace camopt {

namespace {

constexpr std::array<const char*, 4> keys_by_x = {"y", "dy", "ddy", "dddy"},
                                     keys_of_angle = {"s", "ds", "dds", "ddds"},
                                     keys_in_time = {"s", "v", "a", "j"};

// By radians, degrees and seconds.
constexpr auto displacements = units_named<"mm", "m", "in", "deg", "rad">;
constexpr auto velocities =
    units_named<"mm/rad", "mm/deg", "mm/s", "m/rad", "m/deg", "m/s", "in/rad", "in/deg", "in/s", "deg/rad",
                "deg/deg", "deg/s", "rad/rad", "rad/deg", "rad/s">;
constexpr auto accelerations =
    units_named<"mm/rad^2", "mm/deg^2", "mm/s^2", "m/rad^2", "m/deg^2", "m/s^2", "in/rad^2", "in/deg^2",
                "in/s^2", "deg/rad^2", "deg/deg^2", "deg/s^2", "rad/rad^2", "rad/deg^2", "rad/s^2">;
constexpr auto jerks =
    units_named<"mm/rad^3", "mm/deg^3", "mm/s^3", "m/rad^3", "m/deg^3", "m/s^3", "in/rad^3", "in/deg^3",
                "in/s^3", "deg/rad^3", "deg/deg^3", "deg/s^3", "rad/rad^3", "rad/deg^3", "rad/s^3">;

/// Of the motion, or with "output_" before the key of the prescribed output.
void add_derivatives(std::vector<TableColumn>& rows, std::size_t order, std::span<const Spelling> shown,
                     bool output) {
    for (const Spelling& unit : shown) {
        const bool in_time = is_unit_of_time(unit.unit);
        const unsigned need = (is_angle_unit(unit.unit) ? ColumnNeed::angle : ColumnNeed::length) |
                              (in_time ? ColumnNeed::speed : 0U) | (output ? ColumnNeed::output : 0U);
        rows.push_back(
            {fmt::format("{}{}{}", output ? "output_" : "", (in_time ? keys_in_time : keys_of_angle)[order],
                         unit.suffix),
             fmt::format("{}{} in {}", output ? "the output's " : "", derivative_names[order], unit.unit),
             need, order, [=, size = unit.factor](const MotionSpec& motion, const TableRow& row) {
                 const double rate = (in_time ? motion.speed.value() : 1.0) / motion.unit_angle();
                 const MotionPoint& point = output ? row.output.value() : row.motion;
                 return point.derivative[order] * motion.lift * std::pow(rate, static_cast<int>(order)) /
                        size;
             }});
    }
}

struct CamColumn {
    const char* key;
    const char* meaning;
    unsigned need;
    double (*value)(const MechanismPoint& cam, const FollowerLoads& loads);
};

double millimetres(double metres) {
    return metres / units::millimetre;
}

constexpr CamColumn plane_cam_columns[] = {
    {"pressure_angle_deg", "pressure angle in deg", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return cam.pressure_angle / units::degree; }},
    {"cam_radius_mm", "radius of curvature of the cam in mm, > 0 convex", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return millimetres(cam.cam_radius); }},
    {"pitch_radius_mm", "radius of curvature of the pitch curve in mm", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return 1.0 / (cam.pitch_curvature * units::millimetre); }},
    {"pitch_x_mm", "roller centre, x in mm", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return millimetres(cam.pitch.x()); }},
    {"pitch_y_mm", "roller centre, y in mm", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return millimetres(cam.pitch.y()); }},
    {"cam_x_mm", "point of the cam, x in mm", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return millimetres(cam.contact.x()); }},
    {"cam_y_mm", "point of the cam, y in mm", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return millimetres(cam.contact.y()); }},
    {"normal_x", "outward normal of the cam, x", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return cam.normal.x(); }},
    {"normal_y", "outward normal of the cam, y", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return cam.normal.y(); }},
    {"regularity", "<= 0 where the cam is undercut", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return cam.regularity; }},
    {"contact_offset_mm", "where a flat face is touched in mm", ColumnNeed::plane_cam,
     [](const auto& cam, const auto&) { return millimetres(cam.contact_offset); }},
    {"force_n", "force along the lift in N", ColumnNeed::forces | ColumnNeed::length,
     [](const auto&, const auto& loads) { return loads.force; }},
    {"moment_nm", "moment on the arm in N m", ColumnNeed::forces | ColumnNeed::angle,
     [](const auto&, const auto& loads) { return loads.force; }},
    {"torque_nm", "torque on the camshaft in N m", ColumnNeed::forces,
     [](const auto&, const auto& loads) { return loads.torque; }},
    {"driving_force_n", "force that drives a plate along its travel in N",
     ColumnNeed::forces | ColumnNeed::travel,
     [](const auto&, const auto& loads) { return loads.driving_force.value_or(std::nan("")); }},
    {"normal_force_n", "force along the cam's normal in N", ColumnNeed::forces,
     [](const auto&, const auto& loads) { return loads.normal_force; }},
    {"hertz_pressure_mpa", "Hertz pressure in MPa", ColumnNeed::forces | ColumnNeed::contact_width,
     [](const auto&, const auto& loads) {
         return loads.hertz_pressure.value_or(infinity) / units::megapascal;
     }}};

std::vector<TableColumn> all_columns() {
    std::vector<TableColumn> rows;
    const auto add = [&](const char* key, const char* meaning, unsigned need,
                         double (*value)(const MotionSpec&, const TableRow&)) {
        rows.push_back({key, meaning, need, 0, value});
    };
    add("theta_deg", "cam angle in deg", 0, [](const auto&, const auto& row) { return row.theta_deg; });
    add("theta_rad", "cam angle in rad", 0,
        [](const auto&, const auto& row) { return row.theta_deg * units::degree; });
    add("x", "cam angle, normalised", 0, [](const auto&, const auto& row) { return row.motion.x; });
    add("t_s", "time in s", ColumnNeed::speed, [](const auto& motion, const auto& row) {
        return row.theta_deg * units::degree / motion.speed.value();
    });
    for (std::size_t order = 0; order < keys_by_x.size(); ++order)
        rows.push_back({keys_by_x[order], fmt::format("{}, normalised", derivative_names[order]), 0, 0,
                        [order](const auto&, const TableRow& row) { return row.motion.derivative[order]; }});
    for (const bool output : {false, true}) {
        add_derivatives(rows, 0, displacements, output);
        add_derivatives(rows, 1, velocities, output);
        add_derivatives(rows, 2, accelerations, output);
        add_derivatives(rows, 3, jerks, output);
    }
    rows.push_back({"motor_torque_nm", "torque of the motor in N m", ColumnNeed::drive, 0,
                    [](const auto&, const TableRow& row) { return row.drive.torque; }});
    rows.push_back({"motor_speed_rpm", "speed of the motor in rpm", ColumnNeed::drive, 0,
                    [](const auto&, const TableRow& row) { return rpm_shown.of(row.drive.speed); }});
    for (const CamColumn& cam : plane_cam_columns)
        rows.push_back({cam.key, cam.meaning, cam.need, 0,
                        [&cam](const auto&, const TableRow& row) { return cam.value(*row.cam, row.loads); }});
    return rows;
}

bool slides(const Solution& solution) {
    if (!solution.cam) return false;
    const DrivenMechanism& cam = solution.cam->cam;
    const DirectCam* const direct = cam.formulas->direct();
    return direct != nullptr && direct->slide(cam.dimensions).has_value();
}

struct Need {
    unsigned bit;
    const char* words;
    bool (*met)(const Solution& solution);
};

/// In the order of the words; a width of contact is that of forces.
constexpr Need needs[] = {{ColumnNeed::speed, "motion.speed_rpm",
                           [](const Solution& solution) { return solution.scene.motion.speed.has_value(); }},
                          {ColumnNeed::plane_cam, "a plane cam", has_plane_cam},
                          {ColumnNeed::forces, "a cam with [forces]",
                           [](const Solution& solution) { return delivered_loads(solution) != nullptr; }},
                          {ColumnNeed::travel, "a cam that slides", slides},
                          {ColumnNeed::drive, "a [drive] table",
                           [](const Solution& solution) { return solution.drive.has_value(); }},
                          {ColumnNeed::output, "dynamics.prescribe = \"output\"",
                           [](const Solution& solution) { return solution.output != nullptr; }},
                          {ColumnNeed::length, "a lift that is a length",
                           [](const Solution& solution) { return !solution.scene.motion.lift_is_angle; }},
                          {ColumnNeed::angle, "a lift that is an angle",
                           [](const Solution& solution) { return solution.scene.motion.lift_is_angle; }},
                          {ColumnNeed::contact_width, "a width of contact", [](const Solution& solution) {
                               return solution.cam->summary.forces->hertz_pressure.has_value();
                           }}};

using Keys = std::vector<std::string>;

/// Displacement and derivatives by the cam angle.
Keys keys_by_angle(const MotionSpec& motion) {
    if (motion.lift_is_angle) return {"s_deg", "ds_deg_deg", "dds_deg_deg2", "ddds_deg_deg3"};
    return {"s_mm", "ds_mm_rad", "dds_mm_rad2", "ddds_mm_rad3"};
}

}  // namespace

std::string words_of_need(unsigned need) {
    std::string words;
    for (const Need& one : needs)
        if ((need & one.bit) != 0) append_item(words, one.words, " and ");
    return words.empty() ? words : "needs " + words;
}

const std::vector<TableColumn>& table_columns() {
    static const std::vector<TableColumn> columns = all_columns();
    return columns;
}

Columns columns_of(const std::vector<std::string>& keys) {
    Columns columns;
    for (const std::string& key : keys) {
        const auto found = std::ranges::find(table_columns(), key, &TableColumn::key);
        if (found == table_columns().end()) throw std::out_of_range("no column " + key);
        columns.push_back(&*found);
    }
    return columns;
}

bool has_column(const Solution& solution, const TableColumn& column) {
    return std::ranges::all_of(
        needs, [&](const Need& one) { return (column.need & one.bit) == 0 || one.met(solution); });
}

Columns motion_columns(const Scene& scene) {
    const MotionSpec& motion = scene.motion;
    Keys keys = keys_by_angle(motion);
    keys.insert(keys.begin(), "theta_deg");
    keys.insert(keys.end(), {"x", "y", "dy", "ddy", "dddy"});
    if (motion.speed && motion.lift_is_angle)
        keys.insert(keys.end(),
                    {"t_s", "v_deg_s", "a_deg_s2", "j_deg_s3", "v_rad_s", "a_rad_s2", "j_rad_s3"});
    else if (motion.speed)
        keys.insert(keys.end(), {"t_s", "v_mm_s", "a_mm_s2", "j_mm_s3", "a_m_s2", "j_m_s3"});
    if (scene.prescribes_output() && motion.lift_is_angle)
        keys.insert(keys.end(), {"output_s_deg", "output_v_deg_s", "output_a_deg_s2", "output_j_deg_s3"});
    else if (scene.prescribes_output())
        keys.insert(keys.end(), {"output_s_mm", "output_v_mm_s", "output_a_mm_s2", "output_j_mm_s3"});
    if (scene.drive) keys.insert(keys.end(), {"motor_torque_nm", "motor_speed_rpm"});
    return columns_of(keys);
}

Columns profile_columns(const Solution& solution) {
    const CamMechanism& cam = *solution.cam->cam.formulas;
    Keys keys = {"theta_deg",          cam.swings() ? "s_deg" : "s_mm",
                 "pitch_x_mm",         "pitch_y_mm",
                 "cam_x_mm",           "cam_y_mm",
                 "normal_x",           "normal_y",
                 "pressure_angle_deg", "pitch_radius_mm",
                 "cam_radius_mm",      "regularity"};
    if (cam.radius_quantity() == MechanismQuantity::cam_radius) keys.emplace_back("contact_offset_mm");
    if (delivered_loads(solution) == nullptr) return columns_of(keys);
    keys.insert(keys.end(), {cam.swings() ? "moment_nm" : "force_n", "torque_nm"});
    if (slides(solution)) keys.emplace_back("driving_force_n");
    keys.emplace_back("normal_force_n");
    if (solution.cam->summary.forces->hertz_pressure) keys.emplace_back("hertz_pressure_mpa");
    return columns_of(keys);
}

Columns default_columns(const Solution& solution) {
    Keys keys = {"theta_deg"};
    for (const ShownDerivative& shown : shown_units(solution.scene).motion)
        keys.push_back(shown.first.column);
    if (has_plane_cam(solution)) keys.emplace_back("pressure_angle_deg");
    return columns_of(keys);
}

bool has_plane_cam(const Solution& solution) {
    return solution.cam && solution.cam->cam.formulas->radius_quantity();
}

}  // namespace camopt
