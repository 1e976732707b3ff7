// SPDX-License-Identifier: MIT
#include "output/csv/pareto_csv.hpp"

#include "core/units.hpp"
#include "output/csv/csv_line.hpp"
#include "studies/sweep/sweep_run.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

bool is_dimension(const ParetoFront& front, int goal) {
    return std::holds_alternative<DimensionIndex>(front.request.goals[static_cast<std::size_t>(goal)]) &&
           !(goal == 0 && front.request.keep_weights);
}

std::vector<DimensionIndex> dimensions_of(const std::vector<SweepRow>& rows) {
    std::vector<DimensionIndex> dimensions;
    for (int d = 0; d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        if (std::ranges::any_of(rows, [&](const SweepRow& row) { return row.dimension(which).has_value(); }))
            dimensions.push_back(which);
    }
    return dimensions;
}

void add_point(CsvLine& line, const ParetoFront& front, const FrontPoint& point) {
    if (point.place >= 0)
        line.count(point.place);
    else
        line.blank();
    line.count(point.number).words(name_of(point.end));
    for (const int goal : {0, 1}) {
        const double value = goal_value(front, goal, point.value[static_cast<std::size_t>(goal)]);
        line.number(point.is_feasible() ? std::optional(value) : std::nullopt);
    }
    if (point.is_feasible())
        line.number(point.arc);
    else
        line.blank();
    line.words(goal_column(front, point.minimized));
    line.number(point.cap ? std::optional(goal_value(front, 1 - point.minimized, *point.cap)) : std::nullopt);
}

void add_row(CsvLine& line, const SweepRow& row, const std::vector<DimensionIndex>& dimensions) {
    for (const auto& figure : row.figures) line.number(figure);
    for (const DimensionIndex dimension : dimensions) {
        const std::optional<double>& metres = row.dimension(dimension);
        line.number(metres ? std::optional(*metres / units::millimetre) : std::nullopt);
    }
    line.words(fmt::format("{}", fmt::join(row.active_limits, "; ")));
    line.count(row.iterations).number(row.seconds_total);
}

}  // namespace

const char* name_of(FrontEnd value) {
    switch (value) {
        case FrontEnd::none:
            return "";
        case FrontEnd::attained:
            return "attained";
        case FrontEnd::cut_off:
            return "cut_off";
        case FrontEnd::beyond:
            break;
    }
    return "beyond";
}

std::string goal_column(const ParetoFront& front, int goal) {
    const std::string name = name_of(front.request.goals[static_cast<std::size_t>(goal)]);
    if (goal == 0 && front.request.keep_weights) return "weighted_" + name;
    return is_dimension(front, goal) ? name + "_mm" : name;
}

double goal_value(const ParetoFront& front, int goal, double value) {
    return is_dimension(front, goal) ? value / units::millimetre : value;
}

std::vector<const FrontPoint*> tabulated_points(const ParetoFront& front) {
    std::vector<const FrontPoint*> points;
    for (const FrontPoint& point : front.points)
        if (!front.complete || point.place >= 0 || !point.is_feasible()) points.push_back(&point);
    return points;
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

std::string pareto_csv(const ParetoFront& front) {
    const std::vector<const FrontPoint*> points = tabulated_points(front);
    std::vector<SweepRow> rows;
    for (const FrontPoint* point : points) rows.push_back(sweep_row(point->number, {}, point->solution));
    const std::vector<DimensionIndex> dimensions = dimensions_of(rows);
    CsvLine titles;
    titles.words("point").words("solve").words("end").words(goal_column(front, 0));
    titles.words(goal_column(front, 1));
    for (const char* title : {"arc", "minimized", "cap", "verdict", "reason", "objective", "lower_bound",
                              "gap", "limit_first", "limit_second"})
        titles.words(title);
    for (int f = 0; f < sweep_figure_count; ++f)
        titles.words(fmt::format("peak_{}", name_of(static_cast<SweepFigure>(f))));
    for (const DimensionIndex dimension : dimensions)
        titles.words(fmt::format("cam_{}_mm", name_of(dimension)));
    titles.words("active_limits").words("iterations").words("seconds_total");
    std::string text = titles.finish();
    for (std::size_t i = 0; i < points.size(); ++i) {
        CsvLine line;
        add_point(line, front, *points[i]);
        line.words(name_of(rows[i].verdict)).words(rows[i].reason);
        line.number(rows[i].objective).number(rows[i].lower_bound).number(rows[i].gap);
        const auto limit = any_curve_point(front, *points[i]);
        line.number(limit ? std::optional((*limit)[0]) : std::nullopt);
        line.number(limit ? std::optional((*limit)[1]) : std::nullopt);
        add_row(line, rows[i], dimensions);
        text += line.finish();
    }
    return text;
}

}  // namespace camopt
