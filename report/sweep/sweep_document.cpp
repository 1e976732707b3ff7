// SPDX-License-Identifier: MIT
#include "report/sweep/sweep_document.hpp"

#include "core/text/list_text.hpp"
#include "report/view/shown_units.hpp"
#include "studies/sweep/sweep_plan.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr int row_figures = 9;

using Kind = Sentence::Kind;

std::string verdict_line(const std::vector<SweepRow>& rows) {
    std::vector<std::string> parts;
    for (const Verdict verdict :
         {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible, Verdict::failed}) {
        const auto count = std::ranges::count(rows, verdict, &SweepRow::verdict);
        if (count > 0) parts.push_back(fmt::format("{} {}", count, name_of(verdict)));
    }
    return fmt::format("Rows: {} ({})", rows.size(), fmt::join(parts, ", "));
}

std::string front_line(const SweepTable& table) {
    const auto count = std::ranges::count_if(table.rows, &SweepRow::on_front);
    // Where no weight varies every row is its own front.
    if (count == 0 || std::ranges::none_of(table.columns.keys, is_weight_key)) return {};
    return fmt::format("Pareto front: {} row{}, weighing {}.", count, count == 1 ? "" : "s",
                       fmt::join(table.columns.criteria, ", "));
}

/// The peaks of a row in time; empty without a speed, of a program (whose peaks are of its segments) and
/// where the rows differ in their motion.
std::string physical_text(const SweepTable& table, const SweepRow& row, const Scene& scene) {
    const auto of_motion = [](const std::string& key) { return key.starts_with("motion."); };
    const ShownUnits shown = shown_units(scene);
    if (!shown.in_time || scene.motion.type == MotionType::program ||
        std::ranges::any_of(table.columns.keys, of_motion))
        return {};
    std::string text;
    for (const auto& [figure, order] :
         {std::pair(SweepFigure::velocity, 1), std::pair(SweepFigure::acceleration, 2),
          std::pair(SweepFigure::jerk, 3)}) {
        const MotionUnit& unit = shown.motion[order].first;
        if (const std::optional<double>& peak = row.figure(figure))
            append_item(text, fmt::format("{} {}", unit.symbol, unit.normalised_text(*peak)));
    }
    return text.empty() ? text : "; peaks there: " + text;
}

/// Of machines whose speed is searched the fastest one, else the row of the least objective.
std::string best_line(const SweepTable& table, const Scene* scene) {
    const SweepRow *best = nullptr, *fastest = nullptr;
    bool searched = false;
    for (const SweepRow& row : table.rows) {
        searched = searched || row.machine.impossible_above;
        if (row.objective && (!best || *row.objective < *best->objective)) best = &row;
        if (row.machine.speed && (!fastest || *row.machine.speed > *fastest->machine.speed)) fastest = &row;
    }
    if (searched && fastest) best = fastest;
    if (!best) return {};
    std::vector<std::string> settings(table.columns.keys.size());
    for (std::size_t i = 0; i < settings.size(); ++i)
        settings[i] = fmt::format("{} {}", table.columns.keys[i], short_text(best->settings[i]));
    const std::string what =
        searched ? fmt::format("Largest speed: {} rpm", short_text(rpm_shown.of(*best->machine.speed)))
                 : fmt::format("Least objective: {}", short_text(*best->objective, row_figures));
    return fmt::format("{} in row {} ({}){}.", what, best->number, fmt::join(settings, ", "),
                       scene != nullptr ? physical_text(table, *best, *scene) : "");
}

void add_failures(std::vector<Sentence>& sentences, const std::vector<SweepRow>& rows) {
    std::map<std::string, std::vector<int>> reasons;
    for (const SweepRow& row : rows)
        if (row.verdict == Verdict::failed) reasons[row.reason].push_back(row.number);
    for (const auto& [reason, numbers] : reasons)
        sentences.push_back({Kind::warning, "failed",
                             fmt::format("Failed, {}: {} row{}, the first is {}.", words_of(reason),
                                         numbers.size(), numbers.size() == 1 ? "" : "s", numbers.front())});
}

/// How many rows needed no solve; empty: none.
std::string reuse_words(const std::vector<SweepRow>& rows) {
    const auto proved =
        std::ranges::count_if(rows, [](const SweepRow& row) { return row.proved_from.has_value(); });
    if (proved == 0) return "";
    return fmt::format(" ({} rows solved, {} proved from the motion of another row)",
                       static_cast<std::ptrdiff_t>(rows.size()) - proved, proved);
}

/// A word that a shell leaves as it is.
std::string shell_word(const std::string& word) {
    if (!word.empty() && word.find_first_of(" \t\n\"'\\$`*?[](){}<>|&;#!~") == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

}  // namespace

Document sweep_summary(const SweepTable& table, const Scene* scene, const std::string& title) {
    const bool feasible = std::ranges::any_of(table.rows, &SweepRow::is_feasible);
    Document document{title, feasible ? "good" : "bad"};
    std::vector<Sentence>& sentences = document.sections.emplace_back().sentences;
    sentences = {{Kind::headline, "rows", verdict_line(table.rows)}};
    for (const auto& [key, text] :
         {std::pair("front", front_line(table)), std::pair("best", best_line(table, scene))})
        if (!text.empty()) sentences.push_back({Kind::verdict, key, text});
    add_failures(sentences, table.rows);
    double seconds = 0.0;
    for (const SweepRow& row : table.rows) seconds += row.seconds_total;
    sentences.push_back({Kind::effort, "seconds",
                         fmt::format("solving: {} s{}", short_text(seconds, 3), reuse_words(table.rows))});
    return document;
}

Document sweep_document(const SweepPicture& picture, const SweepIdentity& identity) {
    const SweepTable& table = picture.table;
    Document document =
        sweep_summary(table, &picture.scene, picture.scene.title.empty() ? "Sweep" : picture.scene.title);
    document.kind = "Sweep";
    Section& section = document.sections.front();
    section.sentences.push_back(
        {Kind::remark, "axes", fmt::format("Over {}.", fmt::join(identity.axes, ", "))});
    const bool machine = table.columns.machine;
    const bool with_scenes = !machine && table.rows.size() <= static_cast<std::size_t>(most_scenes_of_page);
    Table rows{"rows", "All of them"};
    rows.where = Where::page;
    const auto add = [&](Field field, const auto& cell_of) {
        rows.add_column(std::move(field), table.rows, cell_of);
    };
    add({.key = "row", .title = "solve", .left = true},
        [](const SweepRow& row) { return Cell(row.number).in_words(fmt::format("row {}", row.number)); });
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
        std::vector<std::string> own = settings_of(table.columns.keys, row.settings);
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
    section.pictures = {{identity.study, "The rows of the sweep", sweep_chart(picture)}};
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
    return document;
}

}  // namespace camopt
