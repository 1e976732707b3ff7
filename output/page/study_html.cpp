// SPDX-License-Identifier: MIT
#include "output/page/study_html.hpp"

#include "output/csv/sweep_csv.hpp"
#include "output/document/common_figures.hpp"
#include "output/page/page_html.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

/// A word that a shell leaves as it is.
std::string shell_word(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#!~") == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

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

}  // namespace

std::string sweep_html(const SweepPicture& picture, const SweepIdentity& identity) {
    const SweepTable& table = picture.table;
    Document document{picture.scene.title.empty() ? "Sweep" : picture.scene.title};
    document.kind = "Sweep";
    const auto feasible = std::ranges::count_if(table.rows, &SweepRow::is_feasible);
    const auto optimal = std::ranges::count(table.rows, Verdict::optimal, &SweepRow::verdict);
    const auto on_front = std::ranges::count(table.rows, true, &SweepRow::on_front);
    document.tone = feasible > 0 ? "good" : "bad";
    Section& section = document.sections.emplace_back();
    section.sentences = {
        {Sentence::Kind::headline, "sweep", "Results of the sweep"},
        {Sentence::Kind::verdict, "axes",
         fmt::format("{} solves over {}.", table.rows.size(), fmt::join(identity.axes, ", "))},
        {Sentence::Kind::verdict, "rows",
         fmt::format("{} have a motion that satisfies every limit, {} of them proved optimal; {} are on the "
                     "Pareto front.",
                     feasible, optimal, on_front)}};
    const bool machine = table.columns.machine;
    const bool with_scenes = !machine && table.rows.size() <= static_cast<std::size_t>(most_scenes_of_page);
    Table rows{"rows", "All of them"};
    const auto add = [&](Field field, const auto& cell_of) {
        rows.add_column(std::move(field), table.rows, cell_of);
    };
    add({.key = "row", .title = "solve", .left = true},
        [](const SweepRow& row) { return fmt::format("row {}", row.number); });
    for (std::size_t k = 0; k < table.columns.keys.size(); ++k)
        add({table.columns.keys[k], table.columns.keys[k]},
            [k](const SweepRow& row) { return row.settings[k]; });
    const std::vector<SweepQuantity> quantities = drawn_quantities(table);
    for (const SweepQuantity& quantity : quantities) add({quantity.symbol, quantity.title}, quantity.value);
    add({.key = "verdict", .left = true}, [](const SweepRow& row) { return name_of(row.verdict); });
    add({.key = "front", .title = "Pareto front", .left = true},
        [](const SweepRow& row) { return row.on_front ? "yes" : ""; });
    add({.key = "active", .title = "active limits", .left = true},
        [](const SweepRow& row) { return fmt::format("{}", fmt::join(row.active_limits, "; ")); });
    add({.key = "reason", .left = true}, [](const SweepRow& row) { return row.reason; });
    for (const SweepRow& row : table.rows) {
        std::vector<std::string> own(table.columns.keys.size());
        for (std::size_t k = 0; k < own.size(); ++k)
            own[k] = setting_text(table.columns.keys[k], row.settings[k]);
        RowMotion& motion =
            rows.motions.emplace_back(RowMotion{fmt::format("row {}: {}", row.number, fmt::join(own, ", ")),
                                                !row.is_feasible() ? "bad"
                                                : row.on_front     ? "good"
                                                                   : "",
                                                row.number});
        own.insert(own.begin(), identity.settings.begin(), identity.settings.end());
        if (with_scenes) motion.settings = std::move(own);
    }
    const std::string by = table.columns.keys.empty() ? "row" : table.columns.keys.front();
    if (is_weight_sweep(table))
        rows.axes = {"A", "V"};
    else
        rows.axes = {by, quantities.front().symbol};
    section.pictures = {{"sweep", "The rows of the sweep", sweep_chart(picture)}};
    if (!with_scenes) {
        std::string command =
            fmt::format("camopt {} {}", machine ? "machine" : "solve", shell_word(identity.scene_file));
        for (const std::string& setting : identity.settings) command += " --set " + shell_word(setting);
        rows.without_scenes =
            machine ? "The machine of a row is solved by the command line:"
                    : fmt::format(
                          "This page contains no scenes: the sweep has more than {} rows. The scene "
                          "of a row is solved by the command line:",
                          most_scenes_of_page);
        rows.scene_command = std::move(command);
    }
    section.tables.push_back(std::move(rows));
    return document_html(document, {identity.scene_file, "", machine ? "" : identity.scene_text});
}

std::string pareto_html(const ParetoPicture& picture, const RunOrigin& origin) {
    const ParetoFront& front = picture.front;
    Document document{picture.scene.title.empty() ? "Front" : picture.scene.title,
                      front.complete ? "good" : "fair"};
    document.kind = "Front";
    Section& section = document.sections.emplace_back();
    section.sentences = {{Sentence::Kind::headline, "goals",
                          fmt::format("{} against {}", words_of(name_of(front.request.goals[0])),
                                      words_of(name_of(front.request.goals[1])))}};
    const std::string text = pareto_text(picture);
    for (std::size_t begin = 0, count = 0; begin < text.size() && count < 2; ++count) {
        const std::size_t end = text.find('\n', begin);
        const std::size_t first = text.find_first_not_of(' ', begin);
        section.sentences.push_back({Sentence::Kind::verdict, "front", text.substr(first, end - first)});
        begin = end + 1;
    }
    Table points{"points", "All of them"};
    for (const FrontPoint& point : front.points) {
        points.motions.push_back({fmt::format("solve {}{}", point.number,
                                              point.place >= 0 ? fmt::format(", point {}", point.place) : ""),
                                  !point.is_feasible() ? "bad"
                                  : point.place >= 0   ? "good"
                                                       : "",
                                  point.number, front_settings(point, front.request)});
    }
    const auto add = [&](Field field, const auto& cell_of) {
        points.add_column(std::move(field), front.points, cell_of);
    };
    const auto add_number = [&](std::string key, std::string title,
                                const std::function<double(const FrontPoint&)>& value) {
        add({std::move(key), std::move(title)}, [&](const FrontPoint& point) {
            return point.is_feasible() ? std::optional(value(point)) : std::nullopt;
        });
    };
    std::size_t item = 0;
    add({.key = "solve", .left = true}, [&](const FrontPoint&) { return points.motions[item++].name; });
    for (std::size_t goal = 0; goal < 2; ++goal) {
        const bool length = std::holds_alternative<DimensionIndex>(front.request.goals[goal]);
        const std::string name = words_of(name_of(front.request.goals[goal]));
        const ShownUnit shown = shown_units(picture.scene).length;
        add_number(goal == 0 ? "first" : "second", length ? fmt::format("{} ({})", name, shown.name) : name,
                   [&](const FrontPoint& point) {
                       return length ? shown.of(point.value[goal]) : point.value[goal];
                   });
    }
    const auto is_goal = [&](FrontFigure figure) {
        return std::ranges::find(front.request.goals, FrontGoal(figure)) != front.request.goals.end();
    };
    for (const CostTerm& term : cost_terms())
        if (term.kind == CostTerm::Kind::peak && !is_goal(term.figure))
            add_number(term.name(), term.symbol,
                       [&term](const FrontPoint& point) { return term.measured.of(point.solution.peaks); });
    add({.key = "verdict", .left = true},
        [](const FrontPoint& point) { return name_of(point.solution.certificate.verdict); });
    add({.key = "end", .title = "end of the front", .left = true},
        [](const FrontPoint& point) { return point.end == FrontEnd::none ? "" : name_of(point.end); });
    points.axes = {"first", "second"};
    section.pictures = {{"pareto", "The front", pareto_chart(picture)}};
    section.tables.push_back(std::move(points));
    return document_html(document, origin);
}

}  // namespace camopt
