// SPDX-License-Identifier: MIT
#include "report/sweep/pareto_document.hpp"

#include "core/text/list_text.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

constexpr int value_digits = 7;

/// The points that are listed: of a finished front its spaced ones and what failed; of a stopped one all.
bool is_listed(const ParetoFront& front, const FrontPoint& point) {
    return !front.complete || point.place >= 0 || !point.is_feasible();
}

Table point_table(const ParetoPicture& picture, const std::vector<std::string>& settings) {
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
    for (const FrontPoint& point : front.points) {
        std::vector<std::string> own = settings_of(front.columns.keys, point.row.settings);
        own.insert(own.begin(), settings.begin(), settings.end());
        table.motions.push_back({fmt::format("solve {}{}", point.row.number,
                                             point.place >= 0 ? fmt::format(", point {}", point.place) : ""),
                                 !point.is_feasible() ? "bad"
                                 : point.place >= 0   ? "good"
                                                      : "",
                                 point.row.number, !is_listed(front, point), std::move(own)});
    }
    if (std::ranges::all_of(table.motions, &RowMotion::only_page)) table.where = Where::page;
    std::size_t item = 0;
    add({.key = "solve", .left = true},
        [&](const FrontPoint& point) { return Cell(point.row.number).in_words(table.motions[item++].name); });
    add_number({"first", goal_title(picture, 0)},
               [&](const FrontPoint& point) { return shown_goal(picture, point, 0); });
    add_number({"second", goal_title(picture, 1)},
               [&](const FrontPoint& point) { return shown_goal(picture, point, 1); });
    for (const CostTerm& term : cost_terms())
        if (term.kind == CostTerm::Kind::peak &&
            std::ranges::find(front.request.goals, FrontGoal(term.figure)) == front.request.goals.end())
            add_number({term.name(), term.symbol},
                       [&](const FrontPoint& point) { return value_of(point.row, term.figure); });
    add({.key = "verdict", .left = true}, [](const FrontPoint& point) { return name_of(point.row.verdict); });
    add({.key = "reason", .left = true},
        [](const FrontPoint& point) { return point.is_feasible() ? "" : point.row.reason; });
    add({.key = "end", .title = "end of the front", .left = true},
        [](const FrontPoint& point) { return name_of(point.end); });
    table.axes = {"first", "second"};
    return table;
}

}  // namespace

Document pareto_document(const ParetoPicture& picture, const SweepIdentity& identity) {
    const ParetoFront& front = picture.front;
    Document document{"Front of " + identity.scene_file, front.complete ? "good" : "fair"};
    document.kind = "Front";
    Section& section = document.sections.emplace_back();
    section.sentences = {{Kind::headline, "goals",
                          fmt::format("{} against {}", capitalised(words_of(name_of(front.request.goals[0]))),
                                      words_of(name_of(front.request.goals[1])))},
                         {Kind::verdict, "points", front_sentence(front) + "."},
                         {Kind::verdict, "ends", end_sentence(picture)}};
    section.pictures = {{"pareto", "The front", pareto_chart(picture)}};
    section.tables = {point_table(picture, identity.settings)};
    return document;
}

}  // namespace camopt
