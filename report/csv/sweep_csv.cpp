// SPDX-License-Identifier: MIT
#include "report/csv/sweep_csv.hpp"

#include "core/text/parsing.hpp"
#include "core/word_of.hpp"
#include "report/csv/csv_line.hpp"
#include "scene/limit_table.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/ranges.h>

#include <type_traits>

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
constexpr std::array<SweepPartColumn<SweepMachine>, 2> machine_columns = {
    {{"speed_rpm", "", &SweepMachine::speed, &rpm_shown},
     {"impossible_above_rpm", "", &SweepMachine::impossible_above, &rpm_shown}}};

/// visit(columns of a part, the part of a row) for each that the sweep has, in their order.
template <class Row, class Visit>
void for_each_part(const SweepColumns& columns, Row&& row, const Visit& visit) {
    if (columns.cam()) visit(swept_cam_columns, row.cam);
    if (columns.train) visit(train_columns, row.train);
    if (columns.drive) visit(drive_columns, row.drive);
    if (columns.machine) visit(machine_columns, row.machine);
}

std::string dimension_column(DimensionIndex index) {
    return name_of(index) + millimetres_shown.suffix;
}

/// "solved", or "proved from row 17" (SweepRow::proved_from).
std::string proof_cell(const SweepRow& row) {
    return row.proved_from ? fmt::format("{}{}", proved_from_row, *row.proved_from)
                           : std::string(solved_word);
}

std::string csv_line(const SweepColumns& columns, const SweepRow& row) {
    CsvLine line;
    line.count(row.number);
    for (const double value : row.settings) line.number(value);
    line.words(name_of(row.verdict)).words(row.reason).count(row.on_front ? 1 : 0);
    line.number(row.objective).number(row.lower_bound).number(row.gap).number(row.any_curve_limit);
    if (!columns.machine)
        for (const std::optional<double>& figure : row.figures) line.number(figure);
    const auto shown = [&](const ShownUnit& unit, const std::optional<double>& si) {
        line.number(si ? std::optional(unit.of(*si)) : std::nullopt);
    };
    for (const DimensionIndex index : columns.dimensions) shown(millimetres_shown, row.dimension(index));
    for_each_part(columns, row, [&](const auto& of_part, const auto& part) {
        for (const auto& column : of_part) shown(*column.file_unit, part.*column.value);
    });
    line.words(fmt::format("{}", fmt::join(row.active_limits, between_limits))).words(proof_cell(row));
    const EvaluationCounts& counts = row.evaluations;
    if (!columns.machine)
        for (const long count :
             {static_cast<long>(row.iterations), static_cast<long>(row.exchange_rounds), counts.cost,
              counts.gradient, counts.constraints, counts.jacobian, counts.hessian, counts.profile_points})
            line.count(count);
    return line.number(row.seconds_solve).number(row.seconds_total).finish();
}

/// The SI value that is written as so many of the unit, to the last bit.
std::optional<double> si_value(const ShownUnit& unit, const std::optional<double>& shown) {
    if (!shown) return {};
    const double near = *shown * unit.size;
    for (const double value : {near, std::nextafter(near, -infinity), std::nextafter(near, infinity)})
        if (unit.of(value) == *shown) return value;
    return near;
}

/// The cells of one line, taken one after another.
class Cells {
 public:
    Cells(const CsvRecord& record, const std::vector<std::string>& columns, std::string_view name)
        : record_(record), columns_(columns), name_(name) {
        if (record.cells.size() != columns.size())
            throw InputError(fmt::format("{}:{}: found {} cells; allowed: {}, one a column", name,
                                         record.line, record.cells.size(), columns.size()));
    }

    const std::string& words() { return record_.cells[next_++]; }
    std::optional<double> number_or_none() {
        return record_.cells[next_].empty() ? (++next_, std::nullopt) : std::optional(number<double>());
    }
    template <typename Number>
    Number number() {
        const std::string& cell = words();
        if constexpr (std::is_integral_v<Number>) {
            const std::optional<long long> value = integer_in(cell);
            if (!value || !std::in_range<Number>(*value)) fail("a number");
            return static_cast<Number>(*value);
        } else {
            const std::optional<double> value = number_in(cell);
            if (!value) fail("a number");
            return *value;
        }
    }
    Verdict verdict() {
        const std::string& cell = words();
        for (const Verdict value :
             {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible, Verdict::failed})
            if (cell == name_of(value)) return value;
        fail("a verdict");
    }
    std::optional<int> proved_from() {
        const std::string_view cell = words();
        if (cell == solved_word) return std::nullopt;
        const std::optional<long long> row = cell.starts_with(proved_from_row)
                                                 ? integer_in(cell.substr(proved_from_row.size()))
                                                 : std::nullopt;
        if (!row || !std::in_range<int>(*row)) fail("solved, or proved from row and a number");
        return static_cast<int>(*row);
    }
    std::vector<std::string> list() {
        std::vector<std::string> items;
        std::string_view rest = words();
        while (!rest.empty()) {
            const std::size_t end = rest.find(between_limits);
            items.emplace_back(rest.substr(0, end));
            rest = end == std::string_view::npos ? "" : rest.substr(end + between_limits.size());
        }
        return items;
    }

 private:
    [[noreturn]] void fail(std::string_view allowed) const {
        throw InputError(fmt::format("{}:{}: {}: found \"{}\"; allowed: {}", name_, record_.line,
                                     columns_[next_ - 1], record_.cells[next_ - 1], allowed));
    }

    const CsvRecord& record_;
    const std::vector<std::string>& columns_;
    std::string_view name_;
    std::size_t next_ = 0;
};

SweepRow read_row(const SweepColumns& columns, Cells cells) {
    SweepRow row;
    row.number = cells.number<int>();
    for (std::size_t i = 0; i < columns.keys.size(); ++i) row.settings.push_back(cells.number<double>());
    row.verdict = cells.verdict();
    row.reason = cells.words();
    row.on_front = cells.number<int>() != 0;
    for (auto* value : {&row.objective, &row.lower_bound, &row.gap, &row.any_curve_limit})
        *value = cells.number_or_none();
    if (!columns.machine)
        for (auto& figure : row.figures) figure = cells.number_or_none();
    for (const DimensionIndex index : columns.dimensions)
        row.dimensions[static_cast<std::size_t>(index)] = si_value(millimetres_shown, cells.number_or_none());
    for_each_part(columns, row, [&](const auto& of_part, auto& part) {
        for (const auto& column : of_part)
            part.*column.value = si_value(*column.file_unit, cells.number_or_none());
    });
    row.active_limits = cells.list();
    row.proved_from = cells.proved_from();
    if (!columns.machine) {
        row.iterations = cells.number<int>();
        row.exchange_rounds = cells.number<int>();
        EvaluationCounts& counts = row.evaluations;
        for (long* count : {&counts.cost, &counts.gradient, &counts.constraints, &counts.jacobian,
                            &counts.hessian, &counts.profile_points})
            *count = cells.number<long>();
    }
    row.seconds_solve = cells.number<double>();
    row.seconds_total = cells.number<double>();
    return row;
}

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
    columns.machine = has(machine_columns);
    if (cells != sweep_csv_columns(columns))
        throw InputError(fmt::format("{}:{}: found other columns than those of a sweep; allowed: {}", name,
                                     record.line, fmt::join(sweep_csv_columns(columns), ",")));
    return columns;
}

bool is_dimension(const ParetoFront& front, int goal) {
    return std::holds_alternative<DimensionIndex>(front.request.goals[goal]) &&
           !(goal == 0 && front.request.keep_weights);
}

}  // namespace

std::span<const SweepCamColumn> sweep_cam_columns() {
    return swept_cam_columns;
}

std::span<const SweepDriveColumn> sweep_drive_columns() {
    return drive_columns;
}

std::vector<std::string> sweep_csv_columns(const SweepColumns& columns) {
    std::vector<std::string> names = {"row"};
    const auto add = [&](std::initializer_list<const char*> more) {
        names.insert(names.end(), more.begin(), more.end());
    };
    names.insert(names.end(), columns.keys.begin(), columns.keys.end());
    add({"verdict", "reason", "pareto_front", "objective", "lower_bound", "gap", "any_curve_limit"});
    for (int i = 0; i < sweep_figure_count && !columns.machine; ++i)
        add({name_of(static_cast<SweepFigure>(i))});
    for (const DimensionIndex index : columns.dimensions) names.push_back(dimension_column(index));
    for_each_part(columns, SweepRow(), [&](const auto& of_part, const auto&) {
        for (const auto& column : of_part) names.emplace_back(column.name);
    });
    add({"active_limits", "proof"});
    if (!columns.machine)
        add({"iterations", "exchange_rounds", "cost_evaluations", "gradient_evaluations",
             "constraint_evaluations", "jacobian_evaluations", "hessian_evaluations", "profile_points"});
    add({"seconds_solve", "seconds_total"});
    return names;
}

std::string sweep_csv(const SweepTable& table) {
    CsvLine titles;
    for (const std::string& title : sweep_csv_columns(table.columns)) titles.words(title);
    std::string text = titles.finish();
    for (const SweepRow& row : table.rows) text += csv_line(table.columns, row);
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
    const std::vector<std::string> columns = sweep_csv_columns(table.columns);
    for (std::size_t i = 1; i < records.size(); ++i)
        table.rows.push_back(read_row(table.columns, Cells(records[i], columns, name)));
    return table;
}

const char* name_of(FrontEnd value) {
    return word_of<FrontEnd::beyond>(value, {"", "attained", "cut_off", "beyond"});
}

std::string goal_column(const ParetoFront& front, int goal) {
    const std::string name = name_of(front.request.goals[goal]);
    if (goal == 0 && front.request.keep_weights) return "weighted_" + name;
    return is_dimension(front, goal) ? name + millimetres_shown.suffix : name;
}

double goal_value(const ParetoFront& front, int goal, double value) {
    return is_dimension(front, goal) ? millimetres_shown.of(value) : value;
}

std::optional<std::array<double, 2>> any_curve_point(const ParetoFront& front, const FrontPoint& point) {
    const std::optional<LimitCurve>& limit = point.solution.any_curve_limit;
    if (!limit || front.request.keep_weights) return {};
    std::array<double, 2> values{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto* figure = std::get_if<FrontFigure>(&front.request.goals[i]);
        if (figure == nullptr) return {};
        const std::optional<double> value = *figure == FrontFigure::velocity       ? limit->velocity
                                            : *figure == FrontFigure::acceleration ? limit->acceleration
                                            : *figure == FrontFigure::jerk         ? limit->jerk
                                                                                   : std::nullopt;
        if (!value) return {};
        values[i] = *value;
    }
    return values;
}

}  // namespace camopt
