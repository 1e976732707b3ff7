// SPDX-License-Identifier: MIT
#include "output/csv/uniform_csv.hpp"

#include "core/errors.hpp"
#include "core/numbers/extremum.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "output/words/number_text.hpp"
#include "profiles/sampling.hpp"
#include "studies/delivered/delivered.hpp"
#include "studies/delivered/driven_mechanism.hpp"
#include "studies/delivered/follower_loads.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace camopt {

namespace {

/// What a value of a row is made of.
struct TableRow {
    const MotionSpec* motion = nullptr;
    MotionPoint point;  ///< normalised
    double theta_deg = 0.0;
    const MechanismPoint* cam = nullptr;
    FollowerLoads loads;  ///< where the cam has forces
};

using RowValue = double (*)(const TableRow&);

/// By what a derivative is taken.
enum class TablePer { x, degree, radian, second };

struct ColumnRow {
    TableColumn column;
    RowValue value = nullptr;        ///< neither this nor `cam`: a derivative of the motion
    const CamColumn* cam = nullptr;  ///< of the cam
    std::size_t order = 0;
    double unit = 1.0;  ///< SI
    TablePer per = TablePer::x;
};

double per_x(const MotionSpec& motion, TablePer per) {
    if (per == TablePer::degree) return motion.unit_angle() / units::degree;
    if (per == TablePer::radian) return motion.unit_angle();
    if (per == TablePer::second) return motion.unit_angle() / motion.speed.value();
    return 1.0;
}

double value_of_row(const ColumnRow& column, const TableRow& row) {
    if (column.value) return column.value(row);
    if (column.cam) return column.cam->value(*row.cam, row.loads);
    const double y = row.point.derivative[column.order];
    if (column.per == TablePer::x) return y;
    return y * row.motion->lift / column.unit /
           std::pow(per_x(*row.motion, column.per), static_cast<int>(column.order));
}

unsigned need_of(bool swings, TablePer per) {
    return (swings ? ColumnNeed::angle : ColumnNeed::length) |
           (per == TablePer::second ? ColumnNeed::speed : 0U);
}

struct DerivativeUnit {
    const char* key;    ///< "mm"
    const char* words;  ///< "mm"
    double si;
    bool swings;
};

constexpr std::array<const char*, 4> uniform_derivatives = {"displacement", "velocity", "acceleration",
                                                            "jerk"};

/// "", "2", "3": the exponent of what a derivative is taken by.
std::string exponent_of(std::size_t order) {
    return order < 2 ? "" : std::to_string(order);
}

void add_derivatives(std::vector<ColumnRow>& rows, const DerivativeUnit& unit) {
    const auto add = [&](std::string key, std::size_t order, TablePer per, const std::string& words) {
        rows.push_back({.column = {std::move(key), fmt::format("{} in {}", uniform_derivatives[order], words),
                                   need_of(unit.swings, per)},
                        .order = order,
                        .unit = unit.si,
                        .per = per});
    };
    add(fmt::format("s_{}", unit.key), 0, TablePer::radian, unit.words);
    constexpr std::array<const char*, 4> by_angle = {"s", "ds", "dds", "ddds"},
                                         by_time = {"s", "v", "a", "j"};
    for (std::size_t order = 1; order < 4; ++order) {
        const std::string power = exponent_of(order);
        add(fmt::format("{}_{}_rad{}", by_angle[order], unit.key, power), order, TablePer::radian,
            fmt::format("{}/rad{}", unit.words, power));
        add(fmt::format("{}_{}_deg{}", by_angle[order], unit.key, power), order, TablePer::degree,
            fmt::format("{}/deg{}", unit.words, power));
        add(fmt::format("{}_{}_s{}", by_time[order], unit.key, power), order, TablePer::second,
            fmt::format("{}/s{}", unit.words, power));
    }
}

void add_normalised(std::vector<ColumnRow>& rows) {
    constexpr std::array<const char*, 4> keys = {"y", "dy", "ddy", "dddy"};
    for (std::size_t order = 0; order < keys.size(); ++order)
        rows.push_back({.column = {keys[order], fmt::format("{}, normalised", uniform_derivatives[order])},
                        .order = order});
}

double millimetres(double metres) {
    return metres / units::millimetre;
}

constexpr CamColumn cam_columns[] = {
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
    {"normal_force_n", "force along the cam's normal in N", ColumnNeed::forces,
     [](const auto&, const auto& loads) { return loads.normal_force; }},
    {"hertz_pressure_mpa", "Hertz pressure in MPa", ColumnNeed::forces | ColumnNeed::contact_width,
     [](const auto&, const auto& loads) {
         return loads.hertz_pressure.value_or(infinity) / units::megapascal;
     }}};

std::vector<ColumnRow> column_rows() {
    std::vector<ColumnRow> rows;
    const auto add = [&](const char* key, const char* meaning, unsigned need, RowValue value) {
        rows.push_back({{key, meaning, need}, value});
    };
    add("theta_deg", "cam angle in deg", 0, [](const TableRow& row) { return row.theta_deg; });
    add("theta_rad", "cam angle in rad", 0,
        [](const TableRow& row) { return row.theta_deg * units::degree; });
    add("x", "cam angle, normalised", 0, [](const TableRow& row) { return row.point.x; });
    add("t_s", "time in s", ColumnNeed::speed,
        [](const TableRow& row) { return row.theta_deg * units::degree / row.motion->speed.value(); });
    add_normalised(rows);
    for (const DerivativeUnit& unit :
         {DerivativeUnit{"mm", "mm", units::millimetre, false}, DerivativeUnit{"m", "m", 1.0, false},
          DerivativeUnit{"in", "in", units::inch, false}, DerivativeUnit{"deg", "deg", units::degree, true},
          DerivativeUnit{"rad", "rad", 1.0, true}})
        add_derivatives(rows, unit);
    for (const CamColumn& cam : cam_columns)
        rows.push_back({.column = {cam.key, cam.meaning, cam.need}, .cam = &cam});
    return rows;
}

const std::vector<ColumnRow>& all_column_rows() {
    static const std::vector<ColumnRow> rows = column_rows();
    return rows;
}

/// Of a disk cam with two sides the first.
bool has_plane_cam(const Solution& solution) {
    if (!solution.cam) return false;
    const CamMechanism& cam = *solution.cam->cam.formulas;
    return cam.planar() && (cam.stations() == 1 || cam.is_direct());
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
                          {ColumnNeed::length, "a lift that is a length",
                           [](const Solution& solution) { return !solution.scene.motion.lift_is_angle; }},
                          {ColumnNeed::angle, "a lift that is an angle",
                           [](const Solution& solution) { return solution.scene.motion.lift_is_angle; }},
                          {ColumnNeed::contact_width, "a width of contact", [](const Solution& solution) {
                               return solution.cam->summary.forces->hertz_pressure.has_value();
                           }}};

bool has_column(const Solution& solution, unsigned need) {
    return std::ranges::all_of(needs,
                               [&](const Need& one) { return (need & one.bit) == 0 || one.met(solution); });
}

std::vector<std::string> columns_of(const Solution& solution) {
    std::vector<std::string> keys;
    for (const ColumnRow& row : all_column_rows())
        if (has_column(solution, row.column.need)) keys.push_back(row.column.key);
    return keys;
}

std::vector<std::string> default_columns(const Solution& solution) {
    const MotionSpec& motion = solution.scene.motion;
    std::vector<std::string> keys = {"theta_deg"};
    const auto add = [&](std::initializer_list<const char*> more) {
        keys.insert(keys.end(), more.begin(), more.end());
    };
    if (motion.lift_is_angle && motion.speed)
        add({"s_deg", "v_rad_s", "a_rad_s2", "j_rad_s3"});
    else if (motion.lift_is_angle)
        add({"s_deg", "ds_deg_deg", "dds_deg_deg2", "ddds_deg_deg3"});
    else if (solution.scene.length_unit == LengthUnit::inch && motion.speed)
        add({"s_in", "v_in_s", "a_in_s2", "j_in_s3"});
    else if (solution.scene.length_unit == LengthUnit::inch)
        add({"s_in", "ds_in_rad", "dds_in_rad2", "ddds_in_rad3"});
    else if (motion.speed)
        add({"s_mm", "v_mm_s", "a_m_s2", "j_m_s3"});
    else
        add({"s_mm", "ds_mm_rad", "dds_mm_rad2", "ddds_mm_rad3"});
    if (has_plane_cam(solution)) add({"pressure_angle_deg"});
    return keys;
}

std::vector<const ColumnRow*> chosen_columns(const Solution& solution, std::vector<std::string> keys) {
    if (keys.empty()) keys = default_columns(solution);
    std::vector<const ColumnRow*> chosen;
    for (const std::string& key : keys) {
        const auto found =
            std::ranges::find(all_column_rows(), key, [](const ColumnRow& row) { return row.column.key; });
        const bool known = found != all_column_rows().end();
        if (!known || !has_column(solution, found->column.need))
            throw InputError(
                fmt::format("--columns: found \"{}\"{}; allowed: {}", key,
                            known ? fmt::format(", which {}", words_of_need(found->column.need)) : "",
                            fmt::join(columns_of(solution), ", ")));
        chosen.push_back(&*found);
    }
    return chosen;
}

/// Angles in degrees; none of them is a sum.
std::vector<double> even_angles(const UniformTableOptions& options, double end) {
    constexpr int default_rows = 361, most_rows = 1'000'000;
    std::vector<double> angles;
    if (!options.step_deg) {
        const int last = options.rows.value_or(default_rows) - 1;
        if (last < 1) throw InputError("a table: allowed: 2 rows or more");
        for (int i = 0; i < last; ++i) angles.push_back(end * i / last);
        angles.push_back(end);
        return angles;
    }
    const double step = *options.step_deg;
    if (!(step > 0.0 && step <= end) || end / step > most_rows)
        throw InputError(
            fmt::format("--step-deg: found {}; allowed: a number > 0 and <= {:.9g}, at most {} rows", step,
                        end, most_rows));
    constexpr double part_of_step = 1e-6;  // a row that close to the end is the end
    for (int i = 0; i * step < end - part_of_step * step; ++i) angles.push_back(i * step);
    angles.push_back(end);
    return angles;
}

/// x of the angle, and the breakpoint itself where it is one but for rounding.
double place_on(const std::vector<double>& breakpoints, double x) {
    constexpr double same_x = 1e-12;
    const double tolerance = same_x * std::max(1.0, breakpoints.back());
    const auto next = std::ranges::lower_bound(breakpoints, x - tolerance);
    if (next != breakpoints.end() && *next <= x + tolerance) return *next;
    return std::clamp(x, breakpoints.front(), breakpoints.back());
}

std::string cell_text(double value, const std::optional<int>& digits) {
    if (!digits || !std::isfinite(value)) return round_trip_text(value == 0.0 ? 0.0 : value);
    return fmt::format("{:.{}g}", value == 0.0 ? 0.0 : value, *digits);
}

void refuse_digits(const std::optional<int>& digits) {
    constexpr int most = std::numeric_limits<double>::max_digits10;
    if (digits && (*digits < 1 || *digits > most))
        throw InputError(fmt::format("--digits: found {}; allowed: 1 to {}", *digits, most));
}

}  // namespace

std::string words_of_need(unsigned need) {
    std::string words;
    for (const Need& one : needs)
        if ((need & one.bit) != 0) words += (words.empty() ? "needs " : " and ") + std::string(one.words);
    return words;
}

const CamColumn& cam_column(std::string_view key) {
    const auto* const found = std::ranges::find(cam_columns, key, &CamColumn::key);
    if (found == std::end(cam_columns)) throw std::out_of_range("no column " + std::string(key));
    return *found;
}

const std::vector<TableColumn>& table_columns() {
    static const std::vector<TableColumn> columns = [] {
        std::vector<TableColumn> all;
        for (const ColumnRow& row : all_column_rows()) all.push_back(row.column);
        return all;
    }();
    return columns;
}

std::string UniformTable::words() const {
    std::string said = fmt::format("{} rows over the {}, 0 to {} deg", rows,
                                   whole_turn ? "revolution" : "motion, which is not one revolution",
                                   short_text(end_deg, 9));
    if (last_step_deg > 0.0)
        said += fmt::format("; the last step is {} deg: the step does not divide the angle",
                            short_text(last_step_deg, 6));
    return said;
}

UniformTable uniform_table(const Solution& solution, const UniformTableOptions& options) {
    refuse_digits(options.digits);
    const MotionChain motion = cam_motion(solution);
    const std::vector<const ColumnRow*> columns = chosen_columns(solution, options.columns);
    const MotionSpec& spec = solution.scene.motion;
    const double degrees_per_x = spec.unit_angle() / units::degree;
    const std::vector<double> breakpoints = motion.breakpoints();
    UniformTable table;
    table.whole_turn = is_whole_turn(motion.end() * spec.unit_angle());
    constexpr double whole = 360.0;
    table.end_deg = table.whole_turn ? whole : as_written(motion.end() * degrees_per_x);
    for (const ColumnRow* column : columns)
        table.text += (table.text.empty() ? "" : ",") + column->column.key;
    table.text += "\n";
    const std::vector<double> angles = even_angles(options, table.end_deg);
    const bool plane = has_plane_cam(solution);
    const LoadsAt loads = plane ? delivered_loads(solution) : nullptr;
    for (const double theta : angles) {
        const bool last = theta == angles.back();
        const double x = last ? motion.end() : place_on(breakpoints, theta / degrees_per_x);
        TableRow row{&spec, motion.at(x, last ? Side::left : Side::right), theta, nullptr, {}};
        row.point.x = x;
        std::optional<MechanismPoint> cam;
        if (plane) {
            cam = mechanism_point(solution.cam->cam, row.point, motion_scale(solution.scene));
            row.cam = &*cam;
            if (loads) row.loads = loads(row.point, *row.cam);
        }
        std::string line;
        for (std::size_t i = 0; i < columns.size(); ++i)
            line += (i == 0 ? "" : ",") + cell_text(value_of_row(*columns[i], row), options.digits);
        table.text += line + "\n";
    }
    table.rows = static_cast<int>(angles.size());
    if (options.step_deg) {
        const double last_step = angles.back() - angles[angles.size() - 2];
        constexpr double same_step = 1e-6;
        if (last_step < *options.step_deg * (1.0 - same_step)) table.last_step_deg = last_step;
    }
    return table;
}

std::vector<std::string> column_names(std::string_view list) {
    std::vector<std::string> names;
    for (const std::string_view name : split_text(list, ',')) {
        if (name.empty()) throw InputError("--columns: found an empty name; allowed: names between commas");
        names.emplace_back(name);
    }
    return names;
}

}  // namespace camopt
