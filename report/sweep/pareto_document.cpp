// SPDX-License-Identifier: MIT
#include "report/sweep/pareto_document.hpp"

#include "core/text/list_text.hpp"
#include "report/csv/sweep_csv.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

constexpr int value_digits = 7;

/// What makes the scene of a front's point of that of the front: its weights, and its cap.
std::vector<std::string> front_settings(const FrontPoint& point, const FrontRequest& request) {
    std::vector<std::string> settings;
    const Scene& scene = point.solution.scene;
    for (const CostTerm& term : cost_terms()) {
        const double weight = term.weight_in(scene.objective);
        settings.push_back(setting_text(fmt::format("objective.{}", term.name()), weight));
    }
    for (int d = 0; d < dimension_count; ++d)
        if (const double weight = scene.objective.dimensions[static_cast<std::size_t>(d)]; weight > 0.0)
            settings.push_back(
                setting_text(fmt::format("objective.{}", name_of(static_cast<DimensionIndex>(d))), weight));
    if (!point.cap) return settings;
    const FrontGoal& capped = request.goals[1 - point.minimized];
    if (const auto* const figure = std::get_if<FrontFigure>(&capped)) {
        settings.push_back(setting_text(fmt::format("limits.{}", name_of(*figure)), *point.cap));
    } else if (scene.cam) {
        const Dimension& dimension = *scene.cam->find(std::get<DimensionIndex>(capped));
        settings.push_back(fmt::format("{}={{ min = {}, max = {} }}", dimension.key,
                                       round_trip_text(dimension.low / dimension.unit),
                                       round_trip_text(dimension.high / dimension.unit)));
    }
    return settings;
}

/// The points that are listed: of a finished front its spaced ones and what failed; of a stopped one all.
bool is_listed(const ParetoFront& front, const FrontPoint& point) {
    return !front.complete || point.place >= 0 || !point.is_feasible();
}

Table point_table(const ParetoPicture& picture) {
    const ParetoFront& front = picture.front;
    Table table{"points", "Points of the front"};
    const auto add = [&](Field field, const auto& cell_of) {
        table.add_column(std::move(field), front.points, cell_of);
    };
    const auto add_number = [&](const Field& field, const auto& value) {
        add(field, [&](const FrontPoint& point) {
            return point.is_feasible() ? Cell(value(point), value_digits) : Cell();
        });
    };
    for (const FrontPoint& point : front.points)
        table.motions.push_back({fmt::format("solve {}{}", point.number,
                                             point.place >= 0 ? fmt::format(", point {}", point.place) : ""),
                                 !point.is_feasible() ? "bad"
                                 : point.place >= 0   ? "good"
                                                      : "",
                                 point.number, !is_listed(front, point),
                                 front_settings(point, front.request)});
    if (std::ranges::all_of(table.motions, &RowMotion::only_page)) table.where = Where::page;
    std::size_t item = 0;
    add({.key = "solve", .left = true},
        [&](const FrontPoint& point) { return Cell(point.number).in_words(table.motions[item++].name); });
    add_number({"first", goal_title(picture, 0)},
               [&](const FrontPoint& point) { return shown_goal(picture, point, 0); });
    add_number({"second", goal_title(picture, 1)},
               [&](const FrontPoint& point) { return shown_goal(picture, point, 1); });
    for (const CostTerm& term : cost_terms())
        if (term.kind == CostTerm::Kind::peak &&
            std::ranges::find(front.request.goals, FrontGoal(term.figure)) == front.request.goals.end())
            add_number({term.name(), term.symbol},
                       [&](const FrontPoint& point) { return term.measured.of(point.solution.peaks); });
    add({.key = "verdict", .left = true},
        [](const FrontPoint& point) { return name_of(point.solution.certificate.verdict); });
    add({.key = "reason", .left = true}, [](const FrontPoint& point) {
        return point.is_feasible() ? "" : name_of(point.solution.certificate.reason);
    });
    add({.key = "end", .title = "end of the front", .left = true},
        [](const FrontPoint& point) { return name_of(point.end); });
    table.axes = {"first", "second"};
    return table;
}

/// pareto.csv.
Table csv_table(const ParetoFront& front) {
    struct Point {
        const FrontPoint& point;
        SweepRow row;
        std::optional<std::array<double, 2>> limit;
    };
    std::vector<Point> points;
    for (const FrontPoint& point : front.points)
        if (is_listed(front, point))
            points.push_back(
                {point, sweep_row(point.number, {}, point.solution), any_curve_point(front, point)});
    Table table{.key = "pareto", .file = "pareto.csv"};
    const auto add = [&](Field field, const auto& cell_of) {
        table.add_column(std::move(field), points, cell_of);
    };
    const auto number_of = [](const Point& one, double value) {
        return one.point.is_feasible() ? std::optional(value) : std::nullopt;
    };
    add({"point"}, [](const Point& one) {
        return one.point.place >= 0 ? std::optional<double>(one.point.place) : std::nullopt;
    });
    add({"solve"}, [](const Point& one) { return static_cast<double>(one.point.number); });
    add({"end"}, [](const Point& one) { return name_of(one.point.end); });
    for (const int goal : {0, 1})
        add({goal_column(front, goal)},
            [&](const Point& one) { return number_of(one, goal_value(front, goal, one.point.value[goal])); });
    add({"arc"}, [&](const Point& one) { return number_of(one, one.point.arc); });
    add({"minimized"}, [&](const Point& one) { return goal_column(front, one.point.minimized); });
    add({"cap"}, [&](const Point& one) {
        return one.point.cap ? std::optional(goal_value(front, 1 - one.point.minimized, *one.point.cap))
                             : std::nullopt;
    });
    add({"verdict"}, [](const Point& one) { return name_of(one.row.verdict); });
    add({"reason"}, [](const Point& one) { return one.row.reason; });
    add({"objective"}, [](const Point& one) { return one.row.objective; });
    add({"lower_bound"}, [](const Point& one) { return one.row.lower_bound; });
    add({"gap"}, [](const Point& one) { return one.row.gap; });
    for (const auto& [key, goal] : {std::pair("limit_first", 0), std::pair("limit_second", 1)})
        add({key}, [goal = goal](const Point& one) {
            return one.limit ? std::optional((*one.limit)[goal]) : std::nullopt;
        });
    for (int f = 0; f < sweep_figure_count; ++f)
        add({fmt::format("peak_{}", name_of(static_cast<SweepFigure>(f)))},
            [f](const Point& one) { return one.row.figures[f]; });
    for (int d = 0; d < dimension_count; ++d) {
        const auto which = static_cast<DimensionIndex>(d);
        if (std::ranges::any_of(points,
                                [&](const Point& one) { return one.row.dimension(which).has_value(); }))
            add({fmt::format("cam_{}", name_of(which)), {}, millimetres_shown},
                [which](const Point& one) { return one.row.dimension(which); });
    }
    add({"active_limits"},
        [](const Point& one) { return fmt::format("{}", fmt::join(one.row.active_limits, "; ")); });
    add({"iterations"}, [](const Point& one) { return static_cast<double>(one.row.iterations); });
    add({"seconds_total"}, [](const Point& one) { return one.row.seconds_total; });
    return table;
}

}  // namespace

Document pareto_document(const ParetoPicture& picture, const std::string& title) {
    const ParetoFront& front = picture.front;
    Document document{title, front.complete ? "good" : "fair"};
    document.kind = "Front";
    Section& section = document.sections.emplace_back();
    section.sentences = {{Kind::headline, "goals",
                          fmt::format("{} against {}", capitalised(words_of(name_of(front.request.goals[0]))),
                                      words_of(name_of(front.request.goals[1])))},
                         {Kind::verdict, "points", front_sentence(front) + "."},
                         {Kind::verdict, "ends", end_sentence(picture)}};
    section.pictures = {{"pareto", "The front", pareto_chart(picture)}};
    section.tables = {point_table(picture), csv_table(front)};
    return document;
}

}  // namespace camopt
