// SPDX-License-Identifier: MIT
#include "report/csv/motion_csv.hpp"

#include "core/text/parsing.hpp"
#include "report/csv/csv_line.hpp"
#include "report/view/columns.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr double same_x = 1e-12;
constexpr double whole_turn_deg = 360.0;

/// In lifts: what a motion that advances gains in one revolution.
double travel_of(const Motion& motion) {
    return motion.at(motion.end(), Side::left).derivative[0] - motion.at(motion.begin()).derivative[0];
}

std::string header(const Columns& columns) {
    CsvLine titles;
    for (const TableColumn* column : columns) titles.words(column->key);
    return titles.finish();
}

/// A row as the columns read it, of its first station, by the angle of the cam.
TableRow table_row(const View& view, const DeliveredRow& row) {
    return {view.units.degrees_per_x * row.x,
            row.motion,
            row.cam.empty() ? nullptr : &row.cam.front(),
            row.loads.value_or(FollowerLoads()),
            row.drive.value_or(DrivePoint()),
            row.output};
}

void add_cells(CsvLine& line, const View& view, const Columns& columns, const DeliveredRow& row) {
    const TableRow values = table_row(view, row);
    for (const TableColumn* column : columns) line.number(column->value(view.solution.scene.motion, values));
}

std::string line_of(const View& view, const Columns& columns, const DeliveredRow& row) {
    CsvLine line;
    add_cells(line, view, columns, row);
    return line.finish();
}

/// Whether the jerk is the same where a revolution ends and the next one begins.
bool is_smooth_joint(const Solution& solution) {
    constexpr double round_off = 1e-9;  // of the largest jerk
    const MotionChain& motion = *solution.motion;
    const double jump =
        motion.at(motion.end(), Side::left).derivative[3] - motion.at(motion.begin()).derivative[3];
    return std::abs(jump) <= round_off * solution.cam_peaks.jerk.value;
}

/// One revolution of the master from its angle 0, which the motion passes at x = at_zero, a sample: a row
/// there at both ends.
std::string rows_by_master(const View& view, const Columns& columns, double at_zero) {
    const MotionChain& motion = *view.solution.motion;
    const double near = same_x * (motion.end() - motion.begin());
    const double travel = travel_of(motion);
    std::string early, late;
    const auto add = [&](const DeliveredRow& row, bool before) {
        TableRow values = table_row(view, row);
        const bool there = std::abs(row.x - at_zero) <= near;
        values.theta_deg = there ? 0.0 : view.units.degrees_per_x * (row.x - at_zero);
        if (before)
            values.theta_deg = as_written(values.theta_deg + whole_turn_deg);
        else
            values.motion.derivative[0] -= travel;
        CsvLine line;
        for (const TableColumn* column : columns)
            line.number(column->value(view.solution.scene.motion, values));
        (before ? late : early) += line.finish();
    };
    const DeliveredRow* at_end = nullptr;  // of the revolution
    for (const DeliveredRow& row : view.delivered.rows) {
        if (row.closing) continue;
        const bool there = std::abs(row.x - at_zero) <= near;
        const bool before = there ? row.side == Side::left : row.x < at_zero;
        if (there && (before || at_end == nullptr)) at_end = &row;
        // Where the motion begins again without a jump one row is enough.
        const bool ends = row.x >= motion.end() - near && is_smooth_joint(view.solution);
        if (!ends && !(there && before)) add(row, before);
    }
    if (at_end != nullptr) add(*at_end, true);
    return early + late;
}

/// Column names that are allowed for this solution.
std::vector<std::string> allowed_keys(const Solution& solution) {
    std::vector<std::string> keys;
    for (const TableColumn& column : table_columns())
        if (has_column(solution, column)) keys.push_back(column.key);
    return keys;
}

Columns chosen_columns(const Solution& solution, const std::vector<std::string>& keys) {
    if (keys.empty()) return default_columns(solution);
    for (const std::string& key : keys) {
        const auto found = std::ranges::find(table_columns(), key, &TableColumn::key);
        const bool known = found != table_columns().end();
        if (!known || !has_column(solution, *found))
            throw InputError(fmt::format("--columns: found \"{}\"{}; allowed: {}", key,
                                         known ? fmt::format(", which {}", words_of_need(found->need)) : "",
                                         fmt::join(allowed_keys(solution), ", ")));
    }
    return columns_of(keys);
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

std::string motion_csv(const View& view) {
    if (!view.solution.motion) throw InputError("a table needs a motion, and this solution has none");
    const Columns columns = motion_columns(view.solution.scene);
    std::string text = header(columns);
    if (const double at_zero = view.solution.scene.motion.own_place(0.0); at_zero > 0.0)
        return text + rows_by_master(view, columns, at_zero);
    for (const DeliveredRow& row : view.delivered.rows)
        if (!row.closing) text += line_of(view, columns, row);
    return text;
}

std::string profile_csv(const View& view, const std::vector<DeliveredRow>& rows) {
    const Columns columns = profile_columns(view.solution);
    std::string text = header(columns);
    for (const DeliveredRow& row : rows) text += line_of(view, columns, row);
    return text;
}

std::string guide_csv(const View& view, const std::vector<DeliveredRow>& left,
                      const std::vector<DeliveredRow>& right) {
    static constexpr const char* titles =
        "theta_deg,s_mm,middle_x_mm,middle_y_mm,left_x_mm,left_y_mm,right_x_mm,right_y_mm,pressure_angle_deg,"
        "middle_radius_mm,regularity_left,regularity_right\n";
    static const Columns first = columns_of(
                             {"theta_deg", "s_mm", "pitch_x_mm", "pitch_y_mm", "cam_x_mm", "cam_y_mm"}),
                         second = columns_of({"cam_x_mm", "cam_y_mm"}),
                         third = columns_of({"pressure_angle_deg", "pitch_radius_mm", "regularity"}),
                         last = columns_of({"regularity"});
    std::string text = titles;
    for (std::size_t i = 0; i < left.size(); ++i) {
        CsvLine line;
        add_cells(line, view, first, left[i]);
        add_cells(line, view, second, right[i]);
        add_cells(line, view, third, left[i]);
        add_cells(line, view, last, right[i]);
        text += line.finish();
    }
    return text;
}

std::string UniformTable::words() const {
    std::string said = fmt::format("{} rows over the {}, 0 to {} deg", rows,
                                   whole_turn ? "revolution" : "motion, which is not one revolution",
                                   short_text(end_deg, 9));
    if (phase_deg != 0.0)
        said += fmt::format(" of the master, where the motion begins at {} deg", short_text(phase_deg, 9));
    if (last_step_deg > 0.0)
        said += fmt::format("; the last step is {} deg: the step does not divide the angle",
                            short_text(last_step_deg, 6));
    return said;
}

UniformTable uniform_table(const View& view, const UniformTableOptions& options) {
    const Solution& solution = view.solution;
    refuse_digits(options.digits);
    const MotionChain motion = cam_motion(solution);
    const Columns columns = chosen_columns(solution, options.columns);
    const MotionSpec& spec = solution.scene.motion;
    const std::vector<double> breakpoints = motion.breakpoints();
    UniformTable table;
    table.whole_turn = is_whole_turn(motion.end() * spec.unit_angle());
    table.end_deg = table.whole_turn ? whole_turn_deg : as_written(view.units.degrees_per_x * motion.end());
    table.phase_deg = degrees_shown.of(spec.phase);
    const double at_zero = spec.own_place(0.0), travel = at_zero > 0.0 ? travel_of(motion) : 0.0;
    table.text = header(columns);
    const std::vector<double> angles = even_angles(options, table.end_deg);
    const bool plane = has_plane_cam(solution);
    const LoadsAt loads = plane ? delivered_loads(solution) : nullptr;
    const std::optional<DriveAlong> drive =
        solution.drive ? std::optional<DriveAlong>(solution.scene) : std::nullopt;
    for (const double theta : angles) {
        const bool last = theta == angles.back();
        const Side side = last ? Side::left : Side::right;
        const double after_zero = theta / view.units.degrees_per_x + at_zero;
        const bool next = at_zero > 0.0 && after_zero >= motion.end() * (1.0 - same_x);  // it has begun again
        const double x = last && at_zero == 0.0
                             ? motion.end()
                             : place_on(breakpoints, after_zero - (next ? motion.end() : 0.0));
        TableRow row{theta, motion.at(x, side)};
        row.motion.x = x;
        row.output = output_at(solution, x, side);
        if (plane) row.cam = &view.delivered.cam->at(row.motion, 0);
        if (loads) row.loads = loads(row.motion, *view.delivered.cam);
        if (drive) row.drive = drive->at(row.motion, side, row.output ? &*row.output : nullptr);
        if (!next) row.motion.derivative[0] -= travel;
        for (std::size_t i = 0; i < columns.size(); ++i)
            table.text += (i == 0 ? "" : ",") + cell_text(columns[i]->value(spec, row), options.digits);
        table.text += "\n";
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
