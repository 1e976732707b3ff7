// SPDX-License-Identifier: MIT
#include "report/chart/studies/pareto_svg.hpp"

#include "report/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// How a goal is shown: its name, and what its value in the front (normalised, m) is multiplied by. With a
/// speed a peak of one rise or return stands in its unit; a program's is of its strokes, each by its own
/// angle.
struct GoalAxis {
    std::string title;
    double factor = 1.0;
};

GoalAxis figure_axis(const Scene& scene, const CostTerm& term) {
    const ShownUnits units = shown_units(scene);
    std::string name = words_of(term.name());
    if (term.kind != CostTerm::Kind::peak) return {std::move(name), 1.0};
    if (units.in_time && scene.motion.type != MotionType::program)
        for (const ShownDerivative& derivative : units.motion)
            if (derivative.name == name)
                return {fmt::format("{} {} ({})", name, derivative.first.symbol, derivative.first.name),
                        derivative.first.per_normalised};
    return {fmt::format("{} {}", name, term.symbol), 1.0};
}

GoalAxis goal_axis(const ParetoPicture& picture, int goal) {
    const FrontRequest& request = picture.front.request;
    const FrontGoal& which = request.goals[goal];
    if (goal == 0 && request.keep_weights)
        return {words_of(name_of(request.goals[0])) + " and the scene’s other weights", 1.0};
    if (std::holds_alternative<DimensionIndex>(which)) {
        const ShownUnit length = shown_units(picture.scene).length;
        return {fmt::format("{} ({})", words_of(name_of(which)), length.name), 1.0 / length.size};
    }
    return figure_axis(picture.scene, cost_term(std::get<FrontFigure>(which)));
}

}  // namespace

std::string goal_title(const ParetoPicture& picture, int goal) {
    return goal_axis(picture, goal).title;
}

double shown_goal(const ParetoPicture& picture, const FrontPoint& point, int goal) {
    return goal_axis(picture, goal).factor * point.value[goal];
}

namespace {

bool is_drawn(const FrontPoint& point) {
    return point.is_feasible() && !point.dominated && point.end != FrontEnd::beyond;
}

/// The peak of a law that is this goal; none for dimensions.
std::optional<double> law_value(const Peaks& peaks, const FrontGoal& goal) {
    const auto* figure = std::get_if<FrontFigure>(&goal);
    if (figure == nullptr) return {};
    return cost_term(*figure).measured.of(peaks);
}

/// A value along the front: a line through all points that are drawn, dots at those of the result.
ChartPanel panel_along(const ParetoPicture& picture, const std::string& title,
                       const std::function<double(const FrontPoint&)>& value) {
    ChartPanel panel{.width = 400, .height = 190, .by_factors = true};
    panel.frame.horizontal_title = goal_title(picture, 0);
    panel.frame.vertical_title = title;
    ChartSeries line{Look::line, "row-line"}, dots{Look::dot, "row-dot"};
    for (const FrontPoint& point : picture.front.points) {
        if (!is_drawn(point)) continue;
        const double x = shown_goal(picture, point, 0), y = value(point);
        line.points.push_back({x, y});
        if (point.place >= 0 || !picture.front.complete)
            dots.points.push_back(
                {x, y, fmt::format("{}r{}", point.end == FrontEnd::cut_off ? "off " : "", point.row.number)});
    }
    panel.series = {std::move(line), std::move(dots)};
    return panel;
}

/// The bound of all curves at the points of the front. Beyond the last break of its shape it runs to
/// infinity.
ChartSeries bound_series(const ParetoPicture& picture) {
    ChartSeries bound{.css = "limit-line", .compared = true};
    for (const FrontPoint& point : picture.front.points)
        if (const SweepFrontPlace& at = point.row.front; at.limit_first && at.limit_second && is_drawn(point))
            bound.points.push_back({goal_axis(picture, 0).factor * *at.limit_first,
                                    goal_axis(picture, 1).factor * *at.limit_second});
    std::ranges::sort(bound.points, {}, [](const ChartPoint& point) { return std::pair(point.x, point.y); });
    return bound;
}

/// Diamonds, labelled with the titles of the laws, from left to right.
ChartSeries law_series(const ParetoPicture& picture) {
    ChartSeries laws{
        .look = Look::diamond, .css = "law", .label_css = "law-number", .font = 10.5, .compared = true};
    if (picture.laws == nullptr || picture.front.request.keep_weights) return laws;
    for (const ComparisonRow& row : picture.laws->rows) {
        if (row.is_optimum() || !row.misfit.empty()) continue;
        const auto x = law_value(row.peaks, picture.front.request.goals[0]);
        const auto y = law_value(row.peaks, picture.front.request.goals[1]);
        if (x && y && std::isfinite(*x) && std::isfinite(*y))
            laws.points.push_back(
                {goal_axis(picture, 0).factor * *x, goal_axis(picture, 1).factor * *y, "", row.title});
    }
    std::ranges::stable_sort(laws.points, {}, &ChartPoint::x);
    return laws;
}

/// The table of the laws within the axes; their labels become its numbers.
ChartPanel number_laws(ChartPanel& panel) {
    ChartPanel names{.place = ChartPanel::Place::below, .columns = {{}, {}}, .row_height = 17};
    std::vector<ChartPoint>& laws = panel.series[1].points;
    std::erase_if(laws, [&](const ChartPoint& law) {
        return !panel.frame.horizontal.holds(law.x) || !panel.frame.vertical.holds(law.y);
    });
    for (ChartColumn& column : names.columns) column.side = TextSide::start;
    for (std::size_t i = 0; i < laws.size(); ++i) {
        const std::string number = std::to_string(i + 1);
        names.columns[2 * i < laws.size() ? 0 : 1].cells.push_back(
            {number + "  " + std::exchange(laws[i].label, number), "law-number"});
    }
    return names;
}

std::vector<ChartPanel> panels_of(const ParetoPicture& picture) {
    const auto& goals = picture.front.request.goals;
    ChartPanel main = panel_along(picture, goal_title(picture, 1),
                                  [&](const FrontPoint& point) { return shown_goal(picture, point, 1); });
    if (main.series.front().points.empty()) return {};
    main.width = 560;
    main.height = 470;
    main.series.insert(main.series.begin(), {bound_series(picture), law_series(picture)});
    set_axes(main);
    ChartPanel names = number_laws(main);
    std::vector<ChartPanel> panels = {std::move(main)};
    for (const FrontFigure figure : {FrontFigure::jerk, FrontFigure::acceleration, FrontFigure::velocity}) {
        if (std::ranges::find(goals, FrontGoal(figure)) != goals.end() || panels.size() == 3) continue;
        const GoalAxis axis = figure_axis(picture.scene, cost_term(figure));
        panels.push_back(panel_along(picture, axis.title, [&](const FrontPoint& point) {
            return axis.factor * value_of(point.row, FrontGoal(figure));
        }));
        panels.back().place = panels.size() == 2 ? ChartPanel::Place::right : ChartPanel::Place::below;
    }
    if (!names.columns.front().cells.empty()) panels.push_back(std::move(names));
    return panels;
}

bool is_attained(const FrontPoint& point) {
    return point.end == FrontEnd::attained;
}

}  // namespace

std::string front_sentence(const ParetoFront& front) {
    const auto proved = std::ranges::count_if(
        front.points, [](const FrontPoint& point) { return point.row.verdict == Verdict::optimal; });
    const auto placed =
        std::ranges::count_if(front.points, [](const FrontPoint& point) { return point.place >= 0; });
    std::string text =
        fmt::format("{} points of {} solves, {} proved optimal", placed, front.points.size(), proved);
    if (!front.complete) return text + "; not complete";
    if (placed < 2) return text + ": the two goals do not conflict";
    return text + fmt::format("; gaps along the front {} … {} of the unit box, {}",
                              short_text(front.spacing.least, 3), short_text(front.spacing.most, 3),
                              front.even
                                  ? fmt::format("even to {} %", short_text(100.0 * front.request.evenness, 3))
                                  : "less even than requested");
}

std::string end_sentence(const ParetoPicture& picture) {
    const ParetoFront& front = picture.front;
    std::string text;
    for (const FrontPoint& point : front.points) {
        if (point.end == FrontEnd::cut_off)
            text += fmt::format("Cut off where {} is {} times its least. ",
                                words_of(name_of(front.request.goals[1 - point.minimized])),
                                short_text(front.request.cut_off, 3));
        if (point.end == FrontEnd::beyond)
            text += fmt::format("Beyond: {} {} at {} {}. ", goal_title(picture, 0),
                                short_text(shown_goal(picture, point, 0), 5), goal_title(picture, 1),
                                short_text(shown_goal(picture, point, 1), 5));
    }
    if (front.spacing.jumps > 0) text += fmt::format("Jumps in the front: {}. ", front.spacing.jumps);
    if (!text.empty()) return text;
    return std::ranges::any_of(front.points, is_attained) ? "Both ends are attained." : "There is no front.";
}

Chart pareto_chart(const ParetoPicture& picture) {
    return {fmt::format("{}: {} against {}", picture.scene.title.empty() ? "Front" : picture.scene.title,
                        goal_title(picture, 0), goal_title(picture, 1)),
            {front_sentence(picture.front),
             end_sentence(picture) + " Dashed: lower bound for every curve. Diamonds: classical laws."},
            panels_of(picture)};
}

}  // namespace camopt
