// SPDX-License-Identifier: MIT
#include "output/page/study_html.hpp"

#include "output/csv/sweep_csv.hpp"
#include "output/page/page_parts.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr int overlay_steps = 180;

using Settings = std::vector<std::optional<std::vector<std::string>>>;

/// One column, a value a row.
template <class Row, class Value>
Json column_of(const std::vector<Row>& rows, const Value& value) {
    Json values = Json::array();
    for (const Row& row : rows) values.push_back(value(row));
    return values;
}

/// The motions of all laws by the cam angle, in the units of the scene.
Json overlay_of(const Comparison& comparison) {
    const ShownUnits units = shown_units(comparison.optimum.scene);
    const auto longest =
        std::ranges::find_if(comparison.rows, [](const ComparisonRow& row) { return row.motion != nullptr; });
    if (longest == comparison.rows.end()) return nullptr;
    const double begin = longest->motion->begin(), end = longest->motion->end();
    const auto place = [&](int i) { return begin + (end - begin) * i / overlay_steps; };
    Json angles = Json::array(), curves = Json::array();
    for (int i = 0; i <= overlay_steps; ++i) angles.push_back(rounded_json(units.degrees_per_x * place(i)));
    for (std::size_t order = 0; order < units.motion.size(); ++order) {
        const ShownDerivative& shown = units.motion[order];
        Json lines = Json::array();
        for (const ComparisonRow& row : comparison.rows) {
            if (!row.motion) {
                lines.push_back(nullptr);
                continue;
            }
            Json line = Json::array();
            for (int i = 0; i <= overlay_steps; ++i) {
                const Side side = i < overlay_steps ? Side::right : Side::left;
                const double value =
                    shown.first.per_normalised * row.motion->at(place(i), side).derivative[order];
                constexpr int drawn_digits = 5;
                line.push_back(rounded_json(value, drawn_digits));
            }
            lines.push_back(std::move(line));
        }
        curves.push_back({{"key", shown.name},
                          {"title", shown.name},
                          {"symbol", shown.first.symbol},
                          {"unit", shown.first.name},
                          {"lines", std::move(lines)}});
    }
    return {{"angle", {{"unit", "deg"}, {"values", std::move(angles)}}}, {"curves", std::move(curves)}};
}

/// A word that a shell leaves as it is.
std::string shell_word(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#!~") == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

const char* tone_of(Verdict verdict) {
    if (verdict == Verdict::optimal || verdict == Verdict::local) return "good";
    return verdict == Verdict::feasible ? "fair" : "bad";
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

std::string comparison_html(const Comparison& comparison, const RunOrigin& origin) {
    const std::vector<ComparisonRow>& rows = comparison.rows;
    StudyPage page("Comparison", comparison.optimum.scene.title);
    page.set_verdict(
        tone_of(comparison.optimum.certificate.verdict), "The classical laws on this scene",
        {comparison_sentence(comparison), fmt::format("Objective: {}.", objective_words(comparison)),
         verdict_sentence(comparison.optimum)});
    Settings settings;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ComparisonRow& row = rows[i];
        page.add_item(row_title(row), static_cast<int>(i),
                      row.is_optimum() ? "good"
                      : row.feasible   ? ""
                                       : "bad");
        // A law that does not satisfy the limits, or has an infinite peak that weighs, is nothing to measure
        // by: its scene is the one it was tried on.
        const bool measures = !row.is_optimum() && row.feasible && std::isfinite(row.objective);
        settings.push_back(measures
                               ? std::vector<std::string>{fmt::format("objective.reference=\"{}\"", row.key)}
                               : std::vector<std::string>{});
    }
    const auto number = [&](const std::function<double(const ComparisonRow&)>& value) {
        return column_of(rows, [&](const ComparisonRow& row) {
            return row.motion ? cell_json(value(row)) : Json(nullptr);
        });
    };
    page.add_column("objective", "objective", number([](const ComparisonRow& row) { return row.objective; }));
    page.add_column("loss", "loss (%)",
                    column_of(rows, [](const ComparisonRow& row) { return cell_json(row.loss_percent); }));
    for (const PhysicalPeak& peak : physical_peaks(comparison))
        page.add_column(peak.title, peak.title,
                        number([&](const ComparisonRow& row) { return peak.value(row); }));
    const ShownUnit length = shown_units(comparison.optimum.scene).length;
    page.add_column("velocity", "V",
                    number([](const ComparisonRow& row) { return row.peaks.velocity.value; }));
    page.add_column("acceleration", "A",
                    number([](const ComparisonRow& row) { return row.peaks.acceleration.value; }));
    page.add_column("jerk", "J", number([](const ComparisonRow& row) { return row.peaks.jerk.value; }));
    if (has_bases(comparison))
        page.add_column("base", fmt::format("needed base radius ({})", length.name),
                        column_of(rows, [&](const ComparisonRow& row) {
                            return row.base && row.base->radius ? cell_json(length.of(*row.base->radius))
                                                                : words_json(base_words(comparison, row));
                        }));
    page.add_column(
        "breaks", "breaks",
        column_of(rows,
                  [](const ComparisonRow& row) {
                      return words_json(row.misfit.empty()
                                            ? fmt::format("{}", fmt::join(broken_limits(row), "; "))
                                            : "does not fit: " + row.misfit);
                  }),
        true);
    page.set_axes("acceleration", "velocity");
    page.set_overlay(overlay_of(comparison));
    page.set_scenes(origin, settings);
    return page.html();
}

std::string sweep_html(const SweepPicture& picture, const SweepIdentity& identity) {
    const SweepTable& table = picture.table;
    StudyPage page("Sweep", picture.scene.title);
    const auto feasible = std::ranges::count_if(table.rows, &SweepRow::is_feasible);
    const auto optimal = std::ranges::count(table.rows, Verdict::optimal, &SweepRow::verdict);
    const auto on_front = std::ranges::count(table.rows, true, &SweepRow::on_front);
    std::vector<std::string> sentences = {
        fmt::format("{} solves over {}.", table.rows.size(), fmt::join(identity.axes, ", ")),
        fmt::format("{} have a motion that satisfies every limit, {} of them proved optimal; {} are on the "
                    "Pareto front.",
                    feasible, optimal, on_front)};
    page.set_verdict(feasible > 0 ? "good" : "bad", "Results of the sweep", sentences);
    Settings settings;
    const bool machine = table.columns.machine;
    const bool with_scenes = !machine && table.rows.size() <= static_cast<std::size_t>(most_scenes_of_page);
    for (const SweepRow& row : table.rows) {
        std::vector<std::string> own(table.columns.keys.size());
        for (std::size_t k = 0; k < own.size(); ++k)
            own[k] = setting_text(table.columns.keys[k], row.settings[k]);
        page.add_item(fmt::format("row {}: {}", row.number, fmt::join(own, ", ")), row.number,
                      !row.is_feasible() ? "bad"
                      : row.on_front     ? "good"
                                         : "");
        own.insert(own.begin(), identity.settings.begin(), identity.settings.end());
        settings.push_back(with_scenes ? std::optional(std::move(own)) : std::nullopt);
    }
    page.add_column("row", "row",
                    column_of(table.rows, [](const SweepRow& row) { return Json(row.number); }));
    for (std::size_t k = 0; k < table.columns.keys.size(); ++k)
        page.add_column(
            table.columns.keys[k], table.columns.keys[k],
            column_of(table.rows, [&](const SweepRow& row) { return rounded_json(row.settings[k]); }));
    const std::vector<SweepQuantity> quantities = drawn_quantities(table);
    for (const SweepQuantity& quantity : quantities)
        page.add_column(quantity.symbol, quantity.title, column_of(table.rows, [&](const SweepRow& row) {
                            return cell_json(quantity.value(row));
                        }));
    page.add_column(
        "verdict", "verdict",
        column_of(table.rows, [](const SweepRow& row) { return Json(std::string(name_of(row.verdict))); }),
        true);
    page.add_column(
        "front", "Pareto front",
        column_of(table.rows, [](const SweepRow& row) { return words_json(row.on_front ? "yes" : ""); }),
        true);
    page.add_column("active", "active limits",
                    column_of(table.rows,
                              [](const SweepRow& row) {
                                  return words_json(fmt::format("{}", fmt::join(row.active_limits, "; ")));
                              }),
                    true);
    page.add_column("reason", "reason",
                    column_of(table.rows, [](const SweepRow& row) { return words_json(row.reason); }), true);
    const std::string by = table.columns.keys.empty() ? "row" : table.columns.keys.front();
    page.set_axes(is_weight_sweep(table) ? "A" : by,
                  is_weight_sweep(table) ? "V" : quantities.front().symbol);
    page.set_picture(sweep_svg(picture));
    if (!machine) page.set_scenes({identity.scene_file, "", identity.scene_text}, settings);
    if (!with_scenes) {
        std::string command =
            fmt::format("camopt {} {}", machine ? "machine" : "solve", shell_word(identity.scene_file));
        for (const std::string& setting : identity.settings) command += " --set " + shell_word(setting);
        page.set_without_scenes(
            machine ? "The machine of a row is solved by the command line:"
                    : fmt::format("This page contains no scenes: the sweep has more than {} rows. The scene "
                                  "of a row is solved by the command line:",
                                  most_scenes_of_page),
            command);
    }
    return page.html();
}

std::string pareto_html(const ParetoPicture& picture, const RunOrigin& origin) {
    const ParetoFront& front = picture.front;
    StudyPage page("Front", picture.scene.title);
    const std::string text = pareto_text(picture);
    std::vector<std::string> sentences;
    for (std::size_t begin = 0, count = 0; begin < text.size() && count < 2; ++count) {
        const std::size_t end = text.find('\n', begin);
        const std::size_t first = text.find_first_not_of(' ', begin);
        sentences.push_back(text.substr(first, end - first));
        begin = end + 1;
    }
    page.set_verdict(front.complete ? "good" : "fair",
                     fmt::format("{} against {}", words_of(name_of(front.request.goals[0])),
                                 words_of(name_of(front.request.goals[1]))),
                     sentences);
    Settings settings;
    for (const FrontPoint& point : front.points) {
        page.add_item(fmt::format("solve {}{}", point.number,
                                  point.place >= 0 ? fmt::format(", point {}", point.place) : ""),
                      point.number,
                      !point.is_feasible() ? "bad"
                      : point.place >= 0   ? "good"
                                           : "");
        settings.push_back(front_settings(point, front.request));
    }
    const auto number = [&](const std::function<double(const FrontPoint&)>& value) {
        return column_of(front.points, [&](const FrontPoint& point) {
            return point.is_feasible() ? cell_json(value(point)) : Json(nullptr);
        });
    };
    for (std::size_t goal = 0; goal < 2; ++goal) {
        const bool length = std::holds_alternative<DimensionIndex>(front.request.goals[goal]);
        const std::string name = words_of(name_of(front.request.goals[goal]));
        const ShownUnit shown = shown_units(picture.scene).length;
        page.add_column(goal == 0 ? "first" : "second",
                        length ? fmt::format("{} ({})", name, shown.name) : name,
                        number([&](const FrontPoint& point) {
                            return length ? shown.of(point.value[goal]) : point.value[goal];
                        }));
    }
    const auto is_goal = [&](FrontFigure figure) {
        return std::ranges::find(front.request.goals, FrontGoal(figure)) != front.request.goals.end();
    };
    for (const CostTerm& term : cost_terms())
        if (term.kind == CostTerm::Kind::peak && !is_goal(term.figure))
            page.add_column(term.name(), term.symbol, number([&term](const FrontPoint& point) {
                                return term.measured.of(point.solution.peaks);
                            }));
    page.add_column("verdict", "verdict",
                    column_of(front.points,
                              [](const FrontPoint& point) {
                                  return Json(std::string(name_of(point.solution.certificate.verdict)));
                              }),
                    true);
    page.add_column(
        "end", "end of the front",
        column_of(front.points,
                  [](const FrontPoint& point) {
                      return words_json(point.end == FrontEnd::none ? "" : std::string(name_of(point.end)));
                  }),
        true);
    page.set_axes("first", "second");
    page.set_picture(pareto_svg(picture));
    page.set_scenes(origin, settings);
    return page.html();
}

}  // namespace camopt
