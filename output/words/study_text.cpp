// SPDX-License-Identifier: MIT
#include "output/words/study_text.hpp"

#include "core/text/printable.hpp"
#include "output/view/shown_units.hpp"
#include "output/words/solution_text.hpp"
#include "studies/sweep/sweep_axis.hpp"

#include <fmt/ranges.h>

namespace camopt {

namespace {

constexpr int row_figures = 9;

std::string verdict_line(const std::vector<SweepRow>& rows) {
    std::vector<std::string> parts;
    for (const Verdict verdict :
         {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible, Verdict::failed}) {
        const auto count = std::ranges::count(rows, verdict, &SweepRow::verdict);
        if (count > 0) parts.push_back(fmt::format("{} {}", count, name_of(verdict)));
    }
    return fmt::format("  rows: {} ({})\n", rows.size(), fmt::join(parts, ", "));
}

std::string front_line(const SweepTable& table) {
    const auto count = std::ranges::count_if(table.rows, &SweepRow::on_front);
    // Where no weight varies every row is its own front.
    if (count == 0 || std::ranges::none_of(table.columns.keys, is_weight_key)) return {};
    return fmt::format("  Pareto front: {} row{}, weighing {}\n", count, count == 1 ? "" : "s",
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
            text +=
                fmt::format("{}{} {}", text.empty() ? "" : ", ", unit.symbol, unit.normalised_text(*peak));
    }
    return text.empty() ? text : "    peaks there: " + text + "\n";
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
        searched ? fmt::format("largest speed: {} rpm", short_text(rpm_shown.of(*best->machine.speed)))
                 : fmt::format("least objective: {}", short_text(*best->objective, row_figures));
    return fmt::format("  {} in row {} ({})\n", what, best->number, fmt::join(settings, ", ")) +
           (scene != nullptr ? physical_text(table, *best, *scene) : "");
}

std::string failure_lines(const std::vector<SweepRow>& rows) {
    std::map<std::string, std::vector<int>> reasons;
    for (const SweepRow& row : rows)
        if (row.verdict == Verdict::failed) reasons[row.reason].push_back(row.number);
    std::string text;
    for (const auto& [reason, numbers] : reasons)
        text += fmt::format("  failed, {}: {} row{}, the first is {}\n", words_of(reason), numbers.size(),
                            numbers.size() == 1 ? "" : "s", numbers.front());
    return text;
}

/// How many rows needed no solve; empty: none.
std::string reuse_words(const std::vector<SweepRow>& rows) {
    const auto proved =
        std::ranges::count_if(rows, [](const SweepRow& row) { return row.proved_from.has_value(); });
    if (proved == 0) return "";
    return fmt::format(" ({} rows solved, {} proved from the motion of another row)",
                       static_cast<std::ptrdiff_t>(rows.size()) - proved, proved);
}

}  // namespace

std::string sweep_text(const SweepTable& table, const Scene* scene) {
    double seconds = 0.0;
    for (const SweepRow& row : table.rows) seconds += row.seconds_total;
    return verdict_line(table.rows) + front_line(table) + best_line(table, scene) +
           failure_lines(table.rows) +
           fmt::format("  solving: {} s{}\n", short_text(seconds, 3), reuse_words(table.rows));
}

}  // namespace camopt
