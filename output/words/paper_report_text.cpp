// SPDX-License-Identifier: MIT
#include "output/words/paper_report_text.hpp"

#include "output/words/number_text.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace camopt {

namespace {

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

}  // namespace

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

}  // namespace camopt
