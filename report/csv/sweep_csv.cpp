// SPDX-License-Identifier: MIT
#include "report/csv/sweep_csv.hpp"

#include "core/text/parsing.hpp"
#include "report/csv/csv_line.hpp"
#include "scene/limit_table.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr std::string_view between_limits = "; ";
constexpr std::string_view solved_word = "solved", proved_from_row = "proved from row ";

const ShownUnit without_unit, newton_metres = unit_named<"N m">;

// Of sweeps of different cams, with a follower train, with a motor, of machines.
constexpr std::array<SweepCamColumn, 3> swept_cam_columns = {
    {{"pressure_angle_deg", figure_words::pressure_angle, &SweepCam::pressure_angle, &degrees_shown},
     {"convex_radius_mm", figure_words::convex_radius, &SweepCam::convex_radius, &millimetres_shown},
     {"concave_radius_mm", figure_words::concave_radius, &SweepCam::concave_radius, &millimetres_shown}}};
constexpr std::array<SweepPartColumn<SweepTrain>, 3> train_columns = {
    {{"residual", "", &SweepTrain::residual, &without_unit},
     {"dynamic_acceleration", "", &SweepTrain::dynamic_acceleration, &without_unit},
     {"dynamic_contact_force", "", &SweepTrain::contact_force, &without_unit}}};
constexpr std::array<SweepDriveColumn, 3> drive_columns = {
    {{"motor_torque_nm", "torque of the motor", &SweepDrive::torque, &newton_metres},
     {"motor_torque_rms_nm", "rms torque of the motor", &SweepDrive::rms_torque, &newton_metres},
     {"motor_speed_rpm", "speed of the motor", &SweepDrive::speed, &rpm_shown}}};
constexpr std::array<SweepPartColumn<SweepSpring>, 2> spring_columns = {
    {{"preload", "", &SweepSpring::preload, &without_unit},
     {"spring_rate", "", &SweepSpring::spring_rate, &without_unit}}};
constexpr std::array<SweepPartColumn<SweepSought>, 2> sought_columns = {
    {{"sought_value", "", &SweepSought::value, &without_unit},
     {"sought_impossible", "", &SweepSought::impossible, &without_unit}}};
constexpr std::array<SweepPartColumn<SweepMachine>, 2> machine_columns = {
    {{"speed_rpm", "", &SweepMachine::speed, &rpm_shown},
     {"impossible_above_rpm", "", &SweepMachine::impossible_above, &rpm_shown}}};
constexpr std::array<SweepPartColumn<SweepFrontPlace>, 5> front_columns = {
    {{"point", "", &SweepFrontPlace::point, &without_unit},
     {"arc", "", &SweepFrontPlace::arc, &without_unit},
     {"weighted", "", &SweepFrontPlace::weighted, &without_unit},
     {"limit_first", "", &SweepFrontPlace::limit_first, &without_unit},
     {"limit_second", "", &SweepFrontPlace::limit_second, &without_unit}}};

/// visit(columns of a part, the part of a row) for each that the sweep has, in their order.
void for_each_part(const SweepColumns& columns, SweepRow& row, const auto& visit) {
    if (columns.cam()) visit(swept_cam_columns, row.cam);
    if (columns.train) visit(train_columns, row.train);
    if (columns.drive) visit(drive_columns, row.drive);
    if (columns.spring) visit(spring_columns, row.spring);
    if (columns.sought) visit(sought_columns, row.sought);
    if (columns.machine) visit(machine_columns, row.machine);
    if (columns.front) visit(front_columns, row.front);
}

std::string dimension_column(DimensionIndex index) {
    return name_of(index) + millimetres_shown.suffix;
}

/// cell(name, value) of each column in their order, with the unit of the file where that is not SI.
void for_each_cell(auto&& cell, const SweepColumns& columns, SweepRow& row) {
    cell("row", row.number);
    row.settings.resize(columns.keys.size());
    for (std::size_t i = 0; i < columns.keys.size(); ++i) {
        if (!columns.front) {
            cell(columns.keys[i], row.settings[i]);
            continue;
        }
        std::optional<double> cap;  // of a solve without one the cell is empty
        if (!std::isnan(row.settings[i])) cap = row.settings[i];
        cell(columns.keys[i], cap);
        row.settings[i] = cap.value_or(std::numeric_limits<double>::quiet_NaN());
    }
    cell("verdict", row.verdict);
    cell("reason", row.reason);
    cell("pareto_front", row.on_front);
    cell("objective", row.objective);
    cell("lower_bound", row.lower_bound);
    cell("gap", row.gap);
    cell("any_curve_limit", row.any_curve_limit);
    for (int i = 0; i < sweep_figure_count && !columns.machine; ++i)
        cell(name_of(static_cast<SweepFigure>(i)), row.figures[static_cast<std::size_t>(i)]);
    for (const DimensionIndex index : columns.dimensions)
        cell(dimension_column(index), row.dimensions[static_cast<std::size_t>(index)], millimetres_shown);
    for_each_part(columns, row, [&](const auto& of_part, auto& part) {
        for (const auto& column : of_part) cell(column.name, part.*column.value, *column.file_unit);
    });
    if (columns.front) cell("end", row.front.end);
    cell("active_limits", row.active_limits);
    cell("proof", row.proved_from);
    if (!columns.machine) {
        cell("iterations", row.iterations);
        cell("exchange_rounds", row.exchange_rounds);
        cell("cost_evaluations", row.evaluations.cost);
        cell("gradient_evaluations", row.evaluations.gradient);
        cell("constraint_evaluations", row.evaluations.constraints);
        cell("jacobian_evaluations", row.evaluations.jacobian);
        cell("hessian_evaluations", row.evaluations.hessian);
        cell("profile_points", row.evaluations.profile_points);
    }
    cell("seconds_solve", row.seconds_solve);
    cell("seconds_total", row.seconds_total);
}

/// The cells of one line, written or read one after another.
class Cells {
 public:
    explicit Cells(CsvLine& line) : out_(&line) {}
    Cells(const CsvRecord& record, std::string_view name) : in_(&record), name_(name) {}

    template <std::integral Number>
    void operator()(std::string_view column, Number& value) {
        if (out_ != nullptr) {
            out_->count(value);
        } else {
            const std::optional<long long> whole = integer_in(next());
            if (!whole || !std::in_range<Number>(*whole)) fail(column, "a number");
            value = static_cast<Number>(*whole);
        }
    }
    void operator()(std::string_view column, bool& value) {
        int number = value ? 1 : 0;
        (*this)(column, number);
        value = number != 0;
    }
    void operator()(std::string_view column, double& value) {
        std::optional<double> number = value;
        (*this)(column, number);
        if (!number) fail(column, "a number");
        value = *number;
    }
    void operator()(std::string_view column, std::optional<double>& value) {
        if (out_ != nullptr) {
            out_->number(value);
        } else {
            const std::string& cell = next();
            value = number_in(cell);
            if (!value && !cell.empty()) fail(column, "a number");
        }
    }
    void operator()(std::string_view column, std::optional<double>& si, const ShownUnit& unit) {
        std::optional<double> shown;
        if (si) shown = unit.of(*si);
        (*this)(column, shown);
        si.reset();
        if (shown) si = unit.si_of(*shown);
    }
    void operator()(std::string_view, std::string& words) {
        if (out_ != nullptr)
            out_->words(words);
        else
            words = next();
    }
    void operator()(std::string_view column, Verdict& value) {
        using enum Verdict;
        std::string word = name_of(value);
        (*this)(column, word);
        const auto verdict = choice_named(word, {optimal, local, feasible, infeasible, failed});
        if (!verdict) fail(column, "a verdict");
        value = *verdict;
    }
    void operator()(std::string_view column, std::vector<std::string>& list) {
        std::string cell = fmt::format("{}", fmt::join(list, between_limits));
        (*this)(column, cell);
        list.clear();
        for (std::string_view rest = cell; !rest.empty();) {
            const std::size_t end = rest.find(between_limits);
            list.emplace_back(rest.substr(0, end));
            rest = end == std::string_view::npos ? "" : rest.substr(end + between_limits.size());
        }
    }
    /// "solved", or "proved from row 17" (SweepRow::proved_from).
    void operator()(std::string_view column, std::optional<int>& proof) {
        std::string cell = proof ? fmt::format("{}{}", proved_from_row, *proof) : std::string(solved_word);
        (*this)(column, cell);
        proof.reset();
        if (cell == solved_word) return;
        const std::optional<long long> row = cell.starts_with(proved_from_row)
                                                 ? integer_in(cell.substr(proved_from_row.size()))
                                                 : std::nullopt;
        if (!row || !std::in_range<int>(*row)) fail(column, "solved, or proved from row and a number");
        proof = static_cast<int>(*row);
    }

 private:
    const std::string& next() { return in_->cells[next_++]; }
    [[noreturn]] void fail(std::string_view column, std::string_view allowed) const {
        throw InputError(fmt::format("{}:{}: {}: found \"{}\"; allowed: {}", name_, in_->line, column,
                                     in_->cells[next_ - 1], allowed));
    }

    CsvLine* out_ = nullptr;
    const CsvRecord* in_ = nullptr;
    std::string_view name_;
    std::size_t next_ = 0;
};

/// What varies, from the first line.
SweepColumns read_columns(const CsvRecord& record, std::string_view name) {
    SweepColumns columns;
    const std::vector<std::string>& cells = record.cells;
    const auto verdict = std::ranges::find(cells, "verdict");
    if (verdict != cells.end()) columns.keys.assign(cells.begin() + 1, verdict);
    for (int i = 0; i < dimension_count; ++i) {
        const auto index = static_cast<DimensionIndex>(i);
        if (std::find(verdict, cells.end(), dimension_column(index)) != cells.end())
            columns.dimensions.push_back(index);
    }
    const auto has = [&](const auto& of_part) {
        return std::find(verdict, cells.end(), of_part.front().name) != cells.end();
    };
    columns.train = has(train_columns);
    columns.drive = has(drive_columns);
    columns.spring = has(spring_columns);
    columns.sought = has(sought_columns);
    columns.machine = has(machine_columns);
    columns.front = has(front_columns);
    if (cells != sweep_csv_columns(columns))
        throw InputError(fmt::format("{}:{}: found other columns than those of a sweep; allowed: {}", name,
                                     record.line, fmt::join(sweep_csv_columns(columns), ",")));
    return columns;
}

}  // namespace

std::span<const SweepCamColumn> sweep_cam_columns() {
    return swept_cam_columns;
}

std::span<const SweepDriveColumn> sweep_drive_columns() {
    return drive_columns;
}

std::vector<std::string> sweep_csv_columns(const SweepColumns& columns) {
    std::vector<std::string> names;
    SweepRow row;
    for_each_cell([&](std::string_view name, const auto&...) { names.emplace_back(name); }, columns, row);
    return names;
}

std::string sweep_csv(const SweepTable& table) {
    CsvLine titles;
    for (const std::string& title : sweep_csv_columns(table.columns)) titles.words(title);
    std::string text = titles.finish();
    for (SweepRow row : table.rows) {  // a copy: what takes cells may fill a row
        CsvLine line;
        for_each_cell(Cells(line), table.columns, row);
        text += line.finish();
    }
    return text;
}

SweepTable read_sweep_csv(std::string_view text, std::string_view name) {
    const std::vector<CsvRecord> records = csv_records(text, name);
    if (records.empty()) throw InputError(fmt::format("{}:1: found nothing; allowed: a sweep.csv", name));
    if (!text.ends_with('\n'))
        throw InputError(fmt::format("{}:{}: found a line without an end; allowed: a complete sweep.csv",
                                     name, records.back().line));
    SweepTable table;
    table.columns = read_columns(records.front(), name);
    for (const CsvRecord& record : std::span(records).subspan(1)) {
        if (const std::size_t columns = records.front().cells.size(); record.cells.size() != columns)
            throw InputError(fmt::format("{}:{}: found {} cells; allowed: {}, one a column", name,
                                         record.line, record.cells.size(), columns));
        for_each_cell(Cells(record, name), table.columns, table.rows.emplace_back());
    }
    return table;
}

}  // namespace camopt
