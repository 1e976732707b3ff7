// SPDX-License-Identifier: MIT
#include "tests/soak/stability/table/stability_report.hpp"

#include "report/csv/csv_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace camopt::stability {

namespace {

std::string verdicts_text(const StabilityRow& row) {
    std::string text;
    if (row.backend.empty()) return text;
    for (const Verdict verdict : row.expected.verdicts)
        text += (text.empty() ? "" : " or ") + std::string(name_of(verdict));
    return text;
}

/// What stands between two rows of the summary: the worst of a group.
struct GroupSummary {
    std::string name;
    int rows = 0, ok = 0, unsolved = 0, wrong = 0, absent = 0;
    double error = 0.0, violation = 0.0, gap = 0.0;
};

int& count_of(GroupSummary& group, Judgement judgement) {
    switch (judgement) {
        case Judgement::ok:
            return group.ok;
        case Judgement::unsolved:
            return group.unsolved;
        case Judgement::absent:
            return group.absent;
        default:
            return group.wrong;
    }
}

std::vector<GroupSummary> summaries(std::span<const StabilityRow> rows) {
    std::vector<GroupSummary> all;
    for (const StabilityRow& row : rows) {
        if (all.empty() || all.back().name != row.group) all.push_back({row.group});
        GroupSummary& group = all.back();
        ++group.rows;
        ++count_of(group, row.judgement);
        if (row.verdict != name_of(Verdict::optimal)) continue;
        group.error = std::max(group.error, std::abs(row.relative_error.value_or(0.0)));
        group.violation = std::max(group.violation, row.violation.value_or(0.0));
        group.gap = std::max(group.gap, row.gap.value_or(0.0));
    }
    return all;
}

std::string figure(const std::optional<double>& value) {
    return value ? fmt::format("{:.1e}", *value) : "–";
}

std::string expected_text(const StabilityRow& row) {
    const Expectation& expected = row.expected;
    if (!expected.least && !expected.most) return "–";
    if (!expected.least) return fmt::format("≤ {:.10g}", *expected.most);
    if (!expected.most) return fmt::format("≥ {:.10g}", *expected.least);
    if (*expected.most - *expected.least <= 1e-9 * std::abs(*expected.most))
        return fmt::format("{:.10g}", *expected.most);
    return fmt::format("{:.10g} … {:.10g}", *expected.least, *expected.most);
}

std::string row_line(const StabilityRow& row) {
    return fmt::format(
        "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n", row.name, row.backend, verdicts_text(row),
        expected_text(row), row.verdict, row.found ? fmt::format("{:.10g}", *row.found) : "–",
        figure(row.relative_error), figure(row.gap), figure(row.violation),
        row.judgement == Judgement::ok ? "ok" : std::string(name_of(row.judgement)) + ": " + row.why);
}

}  // namespace

std::string stability_csv(std::span<const StabilityRow> rows) {
    std::string text =
        "group,case,backend,quantity,expected_verdict,expected_least,expected_most,digits,accuracy,source,"
        "verdict,"
        "reason,found,gap,violation,jerk_jump,relative_error,condition_acceleration,condition_jerk,seconds,"
        "judgement,"
        "why\n";
    for (const StabilityRow& row : rows) {
        const Expectation& expected = row.expected;
        CsvLine line;
        line.words(row.group)
            .words(row.name)
            .words(row.backend)
            .words(row.quantity)
            .words(verdicts_text(row));
        line.number(expected.least).number(expected.most).number(expected.digits).number(expected.accuracy);
        line.words(expected.source).words(row.verdict).words(row.reason).number(row.found).number(row.gap);
        line.number(row.violation)
            .number(row.jerk_jump)
            .number(row.relative_error)
            .number(row.condition_acceleration);
        line.number(row.condition_jerk).number(row.seconds).words(name_of(row.judgement)).words(row.why);
        text += line.finish();
    }
    return text;
}

std::string stability_markdown(std::span<const StabilityRow> rows, const std::string& machine) {
    std::string text = "<!-- written by the program `stability`; the whole table is stability.csv -->\n\n";
    text += fmt::format(
        "{} rows: {} wrong, {} unsolved (a weaker verdict than hoped for, and true), {} on backends this "
        "build has "
        "not. {}\n\n",
        rows.size(), std::ranges::count(rows, Judgement::wrong, &StabilityRow::judgement),
        std::ranges::count(rows, Judgement::unsolved, &StabilityRow::judgement),
        std::ranges::count(rows, Judgement::absent, &StabilityRow::judgement), machine);
    text +=
        "| group | rows | ok | unsolved | wrong | absent | worst relative error where optimal | worst "
        "violation | "
        "largest gap |\n"
        "| :--- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n";
    for (const GroupSummary& group : summaries(rows))
        text += fmt::format("| {} | {} | {} | {} | {} | {} | {:.1e} | {:.1e} | {:.1e} |\n", group.name,
                            group.rows, group.ok, group.unsolved, group.wrong, group.absent, group.error,
                            group.violation, group.gap);
    std::string group;
    for (const StabilityRow& row : rows) {
        if (row.group != group) {
            group = row.group;
            text += fmt::format(
                "\n### {}\n\n| case | solver | expected | objective | verdict | found | relative error | gap "
                "| "
                "violation | |\n| :--- | :--- | :--- | ---: | :--- | ---: | ---: | ---: | ---: | :--- |\n",
                group);
        }
        text += row_line(row);
    }
    return text;
}

}  // namespace camopt::stability
