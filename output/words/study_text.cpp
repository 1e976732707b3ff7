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

constexpr int paper_line_width = 100;

std::string title_of(const PaperReport& report) {
    return fmt::format("Paper {}: {}", report.id, report.title);
}

bool holds_words(const PaperTable& table, std::size_t column) {
    return std::ranges::any_of(table.rows, [&](const auto& row) {
        return column < row.size() && std::holds_alternative<std::string>(row[column]);
    });
}

std::string cell_text(const PaperCell& cell, int digits) {
    if (const double* number = std::get_if<double>(&cell))
        return std::isnan(*number) ? std::string("–") : short_text(*number, digits);
    if (const std::string* words = std::get_if<std::string>(&cell)) return *words;
    return "–";
}

TextTable text_table_of(const PaperTable& table) {
    TextTable text;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const PaperColumn& column = table.columns[i];
        const std::string title =
            column.unit.empty() ? column.title : fmt::format("{} [{}]", column.title, column.unit);
        text.columns.push_back({title, holds_words(table, i)});
    }
    for (const auto& row : table.rows) {
        std::vector<std::string> cells;
        for (std::size_t i = 0; i < row.size() && i < table.columns.size(); ++i)
            cells.push_back(cell_text(row[i], table.columns[i].digits));
        text.rows.push_back(std::move(cells));
    }
    return text;
}

std::string numbered(const std::string& title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) return {};
    std::string text = fmt::format("\n{}\n", title);
    for (std::size_t i = 0; i < sentences.size(); ++i)
        text += wrapped_text(sentences[i], fmt::format("{}. ", i + 1), paper_line_width);
    return text;
}

std::string numbered_markdown(const std::string& title, const std::vector<std::string>& sentences) {
    if (sentences.empty()) return {};
    std::string text = fmt::format("\n## {}\n\n", title);
    for (std::size_t i = 0; i < sentences.size(); ++i) text += fmt::format("{}. {}\n", i + 1, sentences[i]);
    return text;
}

constexpr const char* faults_title = "NOT COMPUTED OR NOT PROVED";
constexpr const char* assumptions_title = "Chosen by us, not given by the paper";

constexpr int comparison_line_width = 110;
constexpr int objective_decimals = 6, peak_decimals = 4;

std::string limits_cell(const Comparison& comparison, const ComparisonRow& row) {
    if (!row.misfit.empty()) return "left out: " + row.misfit;
    const std::vector<std::string> broken = broken_limits(row);
    if (!broken.empty()) return fmt::format("{}", fmt::join(broken, "; "));
    if (row.limits.empty()) return "";
    if (row.is_optimum() && !row.feasible)
        return fmt::format("the solve is {}", name_of(comparison.optimum.certificate.verdict));
    return "kept";
}

TextTable table_of(const Comparison& comparison) {
    const bool bases = has_bases(comparison);
    TextTable table;
    const std::vector<PhysicalPeak> physical = physical_peaks(comparison);
    table.columns = {{"law", true}, {"objective"}, {"loss"}};
    for (const PhysicalPeak& peak : physical) table.columns.push_back({peak.title});
    for (const char* const symbol : {"V", "A", "J"}) table.columns.push_back({symbol});
    if (bases) table.columns.push_back({base_title(comparison)});
    table.columns.push_back({"limits", true});
    for (const ComparisonRow& row : comparison.rows) {
        std::vector<std::string> cells = {row_title(row)};
        if (row.misfit.empty()) {
            cells.insert(cells.end(), {fixed_text(row.objective, objective_decimals), loss_words(row)});
            for (const PhysicalPeak& peak : physical) cells.push_back(peak.text(row));
            cells.insert(cells.end(), {fixed_text(row.peaks.velocity.value, peak_decimals),
                                       fixed_text(row.peaks.acceleration.value, peak_decimals),
                                       fixed_text(row.peaks.jerk.value, peak_decimals)});
        } else {
            cells.insert(cells.end(), 5 + physical.size(), "");
        }
        if (bases) cells.push_back(base_words(comparison, row));
        cells.push_back(limits_cell(comparison, row));
        table.rows.push_back(std::move(cells));
    }
    return table;
}

/// How many rows needed no solve; empty: none.
std::string reuse_words(const std::vector<SweepRow>& rows) {
    const auto proved =
        std::ranges::count_if(rows, [](const SweepRow& row) { return row.proved_from.has_value(); });
    if (proved == 0) return "";
    return fmt::format(" ({} rows solved, {} proved from the motion of another row)",
                       static_cast<std::ptrdiff_t>(rows.size()) - proved, proved);
}

std::string counted(int count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string searched_line(const SolvePlan& plan) {
    std::vector<std::string> parts;
    if (!plan.prescribed) parts.emplace_back("the motion");
    if (plan.displacements > 0) parts.push_back(counted(plan.displacements, "free displacement"));
    if (plan.dimensions > 0) parts.push_back(counted(plan.dimensions, "dimension") + " of the cam");
    if (plan.breakpoints > 0) parts.push_back(counted(plan.breakpoints, "breakpoint"));
    if (plan.angles > 0) parts.push_back("the angles of " + counted(plan.angles, "segment"));
    if (parts.empty()) return "Searched: nothing, the motion is prescribed";
    return fmt::format("Searched: {}", fmt::join(parts, ", "));
}

std::string starts_sentence(const SolvePlan& plan) {
    if (plan.breakpoints > 0)
        return fmt::format(
            "first on the given breakpoints, then the structured solver moves them from at most {}: the "
            "given ones, then random ones (seed {})",
            counted(plan.starts, "start"), plan.seed);
    return fmt::format(
        "a convex relaxation first ({}), then the best of at most {}: {}its optimum, the smoothest motion, "
        "random ones (seed {})",
        plan.relaxations.size() > 1
            ? "without the limits that are not convex, then with those that are for sensible displacements"
            : "without the limits that are not convex",
        counted(plan.starts, "start"), plan.from_measured ? "the measured motion, " : "", plan.seed);
}

std::string verdict_sentence(const SolvePlan& plan) {
    if (plan.contradiction) return "its conditions contradict each other: infeasible, proved";
    if (plan.breakpoints > 0)
        return fmt::format(
            "{}local or feasible; infeasibility is not proved",
            plan.proof == ProofKind::none ? "" : "optimal if the limit of any curve is reached, else ");
    if (plan.angles > 0)
        return fmt::format(
            "{}{}",
            plan.proof == ProofKind::boxes ? "optimal or infeasible if the boxes prove it, else " : "",
            plan.angles == 2 ? "local or feasible" : "feasible");
    if (plan.proof == ProofKind::boxes)
        return "optimal or infeasible if the relaxation or a bound over boxes proves it, else local or "
               "feasible with a bound";
    if (plan.proof == ProofKind::none) return "local or feasible, without a bound";
    return plan.reason.empty() && plan.solver != "structured"
               ? fmt::format("optimal or infeasible, both with a proof; if {} fails, feasible", plan.solver)
               : "optimal or infeasible, both with a proof";
}

}  // namespace

std::string sweep_text(const SweepTable& table, const Scene* scene) {
    double seconds = 0.0;
    for (const SweepRow& row : table.rows) seconds += row.seconds_total;
    return verdict_line(table.rows) + front_line(table) + best_line(table, scene) +
           failure_lines(table.rows) +
           fmt::format("  solving: {} s{}\n", short_text(seconds, 3), reuse_words(table.rows));
}

std::string paper_report_text(const PaperReport& report) {
    std::string text = title_of(report) + "\n" + wrapped_text(report.source, "", paper_line_width);
    text += "\n" + wrapped_text(report.introduction, "", paper_line_width);
    text += numbered(faults_title, report.faults);
    text += numbered(assumptions_title, report.assumptions);
    for (const PaperTable& table : report.tables) {
        text += fmt::format("\n{}\n", table.title);
        if (!table.introduction.empty()) text += wrapped_text(table.introduction, "", paper_line_width);
        text += aligned_text(text_table_of(table));
    }
    if (!report.figures.empty()) text += "\nFigures (--out DIR writes them)\n";
    for (const PaperFigure& figure : report.figures)
        text += wrapped_text(fmt::format("{}.svg  {}", figure.key, figure.title), "  ", paper_line_width);
    return text + numbered("Notes", report.notes);
}

std::string paper_report_markdown(const PaperReport& report) {
    std::string text =
        fmt::format("# {}\n\n{}\n\n{}\n", title_of(report), report.source, report.introduction);
    text += numbered_markdown(faults_title, report.faults);
    text += numbered_markdown(assumptions_title, report.assumptions);
    for (const PaperTable& table : report.tables) {
        text += fmt::format("\n## {}\n\n", table.title);
        if (!table.introduction.empty()) text += table.introduction + "\n\n";
        text += markdown_text(text_table_of(table));
    }
    for (const PaperFigure& figure : report.figures)
        text += fmt::format("\n## {}\n\n![{}]({}.svg)\n", figure.title, figure.title, figure.key);
    return text + numbered_markdown("Notes", report.notes);
}

std::string comparison_text(const Comparison& comparison) {
    const Solution& solution = comparison.optimum;
    std::string text;
    if (!solution.scene.title.empty()) text += printable(solution.scene.title) + "\n";
    text += verdict_sentence(solution) + "\n";
    if (!solution.motion) text += "For the suggested changes run camopt solve.\n";
    for (const std::string& note : solution.notes) text += fmt::format("  note: {}\n", note);
    text += wrapped_text(comparison_sentence(comparison), "", comparison_line_width);
    text += "\n" + aligned_text(table_of(comparison));
    const std::string objective = objective_words(comparison);
    text += fmt::format("\nobjective: {}\n", objective.empty() ? "none" : objective);
    if (has_bases(comparison))
        text += wrapped_text(
            "the smallest base radius at which the motion satisfies every limit, the cam's other dimensions "
            "unchanged; none: no radius tried satisfies them",
            base_title(comparison) + ": ", comparison_line_width);
    return text;
}

std::vector<std::string> plan_lines(const SolvePlan& plan) {
    std::vector<std::string> lines = {searched_line(plan)};
    if (plan.prescribed && plan.dimensions == 0)
        lines.push_back("Solved: by no solver, " +
                        no_solver_words(plan.reason.empty() ? plan.solver : "auto"));
    else
        lines.push_back(fmt::format(
            "Solved: {}by {} ({}), design vector: {}, at most {} s",
            plan.relaxations.empty() ? "" : "by structured where the convex relaxation decides, else ",
            plan.solver, plan.reason.empty() ? "named in the scene" : "chosen", name_of(plan.design),
            short_text(plan.seconds)));
    if (!plan.reason.empty()) lines.push_back("Reason: " + plan.reason);
    if (plan.angles > 0)
        lines.push_back(
            fmt::format("Angles: each set of angles that is tried is solved by its own plan; boxes of angles "
                        "are {}bounded",
                        plan.proof == ProofKind::boxes ? "" : "not "));
    if (!plan.relaxations.empty() || plan.breakpoints > 0) lines.push_back("Steps: " + starts_sentence(plan));
    if (plan.strokes_first_free)
        lines.emplace_back(
            "Strokes: rules of motion.within_lift and motion.monotone are added if the motion leaves a "
            "range");
    if (!plan.next_solver.empty())
        lines.push_back(fmt::format("Without a proof: {} is tried next", plan.next_solver));
    if (plan.cost_scale != 1.0)
        lines.push_back(fmt::format("Scale: the objective is divided by {} while it is solved",
                                    short_text(plan.cost_scale)));
    if (plan.tie_break) lines.emplace_back("Ties: of equal optima the smoothest motion");
    lines.push_back("Expected verdict: " + verdict_sentence(plan));
    if (plan.explain_seconds > 0.0)
        lines.push_back(fmt::format("Without a motion: changes that help are searched for at most {} s",
                                    short_text(plan.explain_seconds)));
    return lines;
}

}  // namespace camopt
