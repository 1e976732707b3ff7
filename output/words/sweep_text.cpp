// SPDX-License-Identifier: MIT
#include "output/words/sweep_text.hpp"

#include "output/words/number_text.hpp"
#include "output/words/shown_units.hpp"
#include "studies/sweep/sweep_axis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

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
    // Where no weight varies every row is a front of its own.
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
        const MotionUnit& unit = shown.motion[static_cast<std::size_t>(order)].first;
        if (const std::optional<double>& peak = row.figure(figure))
            text +=
                fmt::format("{}{} {}", text.empty() ? "" : ", ", unit.symbol, unit.normalised_text(*peak));
    }
    return text.empty() ? text : "    peaks there: " + text + "\n";
}

std::string best_line(const SweepTable& table, const Scene* scene) {
    const SweepRow* best = nullptr;
    for (const SweepRow& row : table.rows)
        if (row.objective && (!best || *row.objective < *best->objective)) best = &row;
    if (!best) return {};
    std::vector<std::string> settings;
    for (std::size_t i = 0; i < table.columns.keys.size(); ++i)
        settings.push_back(fmt::format("{} {}", table.columns.keys[i], short_text(best->settings[i])));
    return fmt::format("  least objective: {} in row {} ({})\n", short_text(*best->objective, row_figures),
                       best->number, fmt::join(settings, ", ")) +
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

}  // namespace

std::string sweep_text(const SweepTable& table, const Scene* scene) {
    double seconds = 0.0;
    for (const SweepRow& row : table.rows) seconds += row.seconds_total;
    return verdict_line(table.rows) + front_line(table) + best_line(table, scene) +
           failure_lines(table.rows) + fmt::format("  solving: {} s\n", short_text(seconds, 3));
}

}  // namespace camopt
