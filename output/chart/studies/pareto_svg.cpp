// SPDX-License-Identifier: MIT
#include "output/chart/placed_texts.hpp"
#include "output/chart/studies/study_svg.hpp"
#include "output/chart/sweep/sweep_quantities.hpp"
#include "output/csv/sweep_csv.hpp"
#include "output/view/number_text.hpp"
#include "output/view/shown_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace camopt {

namespace {

constexpr double margin = 40, top = 118, main_left = 100, main_width = 560, main_height = 470;
constexpr double law_size = 10.5, law_column = 228, diamond = 3.0;  // of the laws' numbers, names, marks
constexpr double side_left = 780, side_width = 400, side_height = 190, page_width = 1220;

/// How a goal is shown: its name, and what its value in the front (normalised, m) is multiplied by. With a
/// speed a peak of one rise or return stands in its unit; a program's is of its segments, each by its own
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
    const FrontGoal& which = request.goals[static_cast<std::size_t>(goal)];
    if (goal == 0 && request.keep_weights)
        return {words_of(name_of(request.goals[0])) + " and the scene’s other weights", 1.0};
    if (std::holds_alternative<DimensionIndex>(which)) {
        const ShownUnit length = shown_units(picture.scene).length;
        return {fmt::format("{} ({})", words_of(name_of(which)), length.name), 1.0 / length.size};
    }
    return figure_axis(picture.scene, cost_term(std::get<FrontFigure>(which)));
}

std::string goal_title(const ParetoPicture& picture, int goal) {
    return goal_axis(picture, goal).title;
}

double shown(const ParetoPicture& picture, const FrontPoint& point, int goal) {
    return goal_axis(picture, goal).factor * point.value[static_cast<std::size_t>(goal)];
}

bool is_drawn(const FrontPoint& point) {
    return point.is_feasible() && !point.dominated && point.end != FrontEnd::beyond;
}

/// The peak of a law that is this goal; none for dimensions.
std::optional<double> law_value(const Peaks& peaks, const FrontGoal& goal) {
    const auto* figure = std::get_if<FrontFigure>(&goal);
    if (figure == nullptr) return {};
    return cost_term(*figure).measured.of(peaks);
}

struct LawMark {
    double x = 0.0, y = 0.0;
    std::string title;
};

std::vector<LawMark> law_marks(const ParetoPicture& picture) {
    std::vector<LawMark> marks;
    if (picture.laws == nullptr || picture.front.request.keep_weights) return marks;
    for (const ComparisonRow& row : picture.laws->rows) {
        if (row.is_optimum() || !row.misfit.empty()) continue;
        const auto x = law_value(row.peaks, picture.front.request.goals[0]);
        const auto y = law_value(row.peaks, picture.front.request.goals[1]);
        if (x && y && std::isfinite(*x) && std::isfinite(*y))
            marks.push_back(
                {goal_axis(picture, 0).factor * *x, goal_axis(picture, 1).factor * *y, row.title});
    }
    return marks;
}

PlotFrame frame_of(const ValueRange& x, const ValueRange& y, const PanelFrame& place) {
    PlotFrame frame;
    frame.horizontal = axis_over(x, place.left, place.left + place.width);
    frame.vertical = axis_over(y, place.top + place.height, place.top);
    frame.horizontal_ticks = labelled_ticks(frame.horizontal, 6);
    frame.vertical_ticks = labelled_ticks(frame.vertical, 6);
    return frame;
}

using Points = std::vector<std::array<double, 2>>;

void draw_polyline(SvgCanvas& canvas, const PlotFrame& frame, const Points& points, const char* look) {
    std::string path;
    for (const auto& [x, y] : points)
        path += fmt::format("{}{} {}", path.empty() ? "M" : "L", svg_number(frame.horizontal.place(x)),
                            svg_number(frame.vertical.place(y)));
    if (points.size() > 1) canvas.path(path, look);
}

/// Numbered diamonds, and their names below the other panels.
void draw_law_marks(SvgCanvas& canvas, const PlotFrame& frame, std::vector<LawMark> marks) {
    std::erase_if(marks, [&](const LawMark& mark) {
        return !frame.horizontal.holds(mark.x) || !frame.vertical.holds(mark.y);
    });
    std::ranges::stable_sort(marks, {}, &LawMark::x);
    PlacedTexts numbers(frame.horizontal.begin, frame.vertical.end, frame.horizontal.end,
                        frame.vertical.begin);
    for (const LawMark& mark : marks)
        numbers.keep_free(frame.horizontal.place(mark.x), frame.vertical.place(mark.y), diamond);
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const LawMark& mark = marks[i];
        const double x = frame.horizontal.place(mark.x), y = frame.vertical.place(mark.y);
        canvas.path(fmt::format("M{0} {1}l4 4l-4 4l-4 -4Z", svg_number(x), svg_number(y - 4)), "law");
        const std::string number = std::to_string(i + 1);
        numbers.draw(canvas, number, places_around(x, y, text_width(number, law_size), law_size),
                     "law-number", law_size);
        const std::size_t rows = (marks.size() + 1) / 2;
        canvas.text(side_left - 20 + law_column * static_cast<double>(i / rows),
                    top + side_height + 70 + 17.0 * static_cast<double>(i % rows),
                    fmt::format("{}  {}", i + 1, mark.title), "law-number");
    }
}

void draw_front(SvgCanvas& canvas, const ParetoPicture& picture) {
    const ParetoFront& front = picture.front;
    Points all, limit;
    ValueRange x, y;
    for (const FrontPoint& point : front.points) {
        if (!is_drawn(point)) continue;
        all.push_back({shown(picture, point, 0), shown(picture, point, 1)});
        x.add(all.back()[0]);
        y.add(all.back()[1]);
        if (const auto bound = any_curve_point(front, point))
            limit.push_back(
                {goal_axis(picture, 0).factor * (*bound)[0], goal_axis(picture, 1).factor * (*bound)[1]});
    }
    if (all.empty()) return;
    // Beyond the last break of its shape the limit runs to infinity: what leaves the picture is not drawn.
    for (const auto& [across, up] : limit) {
        if (up <= y.upper) x.add(across);
        if (across <= x.upper) y.add(std::min(up, y.upper));
    }
    std::vector<LawMark> marks = law_marks(picture);
    for (const LawMark& mark : marks) {
        if (mark.x > x.upper + 0.35 * (x.upper - x.lower) || mark.y > 1.05 * y.upper) continue;
        x.add(mark.x);
        y.add(mark.y);
    }
    PlotFrame frame = frame_of(x, y, {main_left, top, main_width, main_height});
    frame.horizontal_title = goal_title(picture, 0);
    frame.vertical_title = goal_title(picture, 1);
    draw_plot_frame(canvas, frame);
    std::erase_if(limit, [&](const auto& point) {
        return !frame.horizontal.holds(point[0]) || !frame.vertical.holds(point[1]);
    });
    std::ranges::sort(limit);
    draw_polyline(canvas, frame, limit, "limit-line");
    draw_polyline(canvas, frame, all, "row-line");
    draw_law_marks(canvas, frame, std::move(marks));
    for (const FrontPoint& point : front.points) {
        if (!is_drawn(point) || (point.place < 0 && front.complete)) continue;
        canvas.circle(
            frame.horizontal.place(shown(picture, point, 0)), frame.vertical.place(shown(picture, point, 1)),
            4.0,
            fmt::format("{} r{}", point.end == FrontEnd::cut_off ? "row-dot off" : "row-dot", point.number));
    }
}

/// A figure that is no goal, along the front.
void draw_other(SvgCanvas& canvas, const ParetoPicture& picture, FrontFigure figure, double panel_top) {
    const ParetoFront& front = picture.front;
    const GoalAxis axis = figure_axis(picture.scene, cost_term(figure));
    const auto value = [&](const FrontPoint& point) {
        return axis.factor * value_of(point.solution, FrontGoal(figure));
    };
    Points all;
    ValueRange x, y;
    for (const FrontPoint& point : front.points) {
        if (!is_drawn(point)) continue;
        all.push_back({shown(picture, point, 0), value(point)});
        x.add(all.back()[0]);
        y.add(all.back()[1]);
    }
    if (all.empty()) return;
    PlotFrame frame = frame_of(x, y, {side_left, panel_top, side_width, side_height});
    frame.horizontal_title = goal_title(picture, 0);
    frame.vertical_title = axis.title;
    draw_plot_frame(canvas, frame);
    draw_polyline(canvas, frame, all, "row-line");
    for (const FrontPoint& point : front.points) {
        if (!is_drawn(point) || (point.place < 0 && front.complete)) continue;
        canvas.circle(frame.horizontal.place(shown(picture, point, 0)), frame.vertical.place(value(point)),
                      3.0, fmt::format("row-dot r{}", point.number));
    }
}

std::string count_sentence(const ParetoFront& front) {
    const auto proved = std::ranges::count_if(front.points, [](const FrontPoint& point) {
        return point.solution.certificate.verdict == Verdict::optimal;
    });
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

bool is_attained(const FrontPoint& point) {
    return point.end == FrontEnd::attained;
}

std::string end_sentence(const ParetoPicture& picture) {
    const ParetoFront& front = picture.front;
    std::string text;
    for (const FrontPoint& point : front.points) {
        if (point.end == FrontEnd::cut_off)
            text += fmt::format(
                "Cut off where {} is {} times its least. ",
                words_of(name_of(front.request.goals[static_cast<std::size_t>(1 - point.minimized)])),
                short_text(front.request.cut_off, 3));
        if (point.end == FrontEnd::beyond)
            text += fmt::format("Beyond: {} {} at {} {}. ", goal_title(picture, 0),
                                short_text(shown(picture, point, 0), 5), goal_title(picture, 1),
                                short_text(shown(picture, point, 1), 5));
    }
    if (front.spacing.jumps > 0) text += fmt::format("Jumps in the front: {}. ", front.spacing.jumps);
    if (!text.empty()) return text;
    return std::ranges::any_of(front.points, is_attained) ? "Both ends are attained." : "There is no front.";
}

}  // namespace

std::string pareto_svg(const ParetoPicture& picture) {
    const ParetoFront& front = picture.front;
    const std::string title =
        fmt::format("{}: {} against {}", picture.scene.title.empty() ? "Front" : picture.scene.title,
                    goal_title(picture, 0), goal_title(picture, 1));
    const double height = top + main_height + 64;
    SvgCanvas canvas(page_width, height, sweep_panel_style(), title);
    canvas.rectangle(0, 0, page_width, height, "page");
    canvas.text(margin, 38, title, "title");
    canvas.text(margin, 61, count_sentence(front), "subtitle");
    canvas.text(margin, 80,
                end_sentence(picture) + " Dashed: lower bound for every curve. Diamonds: classical laws.",
                "subtitle");
    draw_front(canvas, picture);
    double side_top = top;
    int panels = 0;
    for (const FrontFigure figure : {FrontFigure::jerk, FrontFigure::acceleration, FrontFigure::velocity}) {
        const auto& goals = front.request.goals;
        if (std::ranges::find(goals, FrontGoal(figure)) != goals.end() || panels == 2) continue;
        draw_other(canvas, picture, figure, side_top);
        side_top += main_height - side_height;
        ++panels;
    }
    return canvas.finish();
}

std::string pareto_text(const ParetoPicture& picture) {
    const ParetoFront& front = picture.front;
    std::string text = fmt::format("  {}\n  {}\n", count_sentence(front), end_sentence(picture));
    for (const FrontPoint* point : tabulated_points(front)) {
        if (!point->is_feasible()) {
            text += fmt::format("  solve {}: {} {}\n", point->number,
                                name_of(point->solution.certificate.verdict),
                                name_of(point->solution.certificate.reason));
            continue;
        }
        text += fmt::format(
            "  {:>4}  {} {:<10}  {} {:<10}  {}\n", point->place >= 0 ? std::to_string(point->place) : "",
            goal_title(picture, 0), short_text(shown(picture, *point, 0), 7), goal_title(picture, 1),
            short_text(shown(picture, *point, 1), 7), name_of(point->solution.certificate.verdict));
    }
    return text;
}

}  // namespace camopt
