// SPDX-License-Identifier: MIT
#include "output/words/tables/reference_table_text.hpp"

#include "output/words/tables/reference_table_rows.hpp"
#include "output/words/tables/text_table.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace camopt {

namespace {

constexpr int table_line_width = 100;
constexpr const char* title = "The best cubic spline beside the modified sine";
constexpr const char* introduction =
    "Rise between two dwells; C2 cubic spline on n equal segments, y(x) + y(1 − x) = 1. Every optimum is "
    "found and "
    "proved by camopt; what a paper of 1994 prints stands beside it. Source: T.-Y. Shon, M.-Y. Yang, "
    "\"Synthesis of "
    "Optimum CAM Curve by Cubic Spline\", 1994.";

}  // namespace

std::string reference_table_text(const ReferenceTable& table) {
    std::string text = fmt::format("{}\n\n{}", title, wrapped_text(introduction, "", table_line_width));
    const std::string warning = unproved_warning(table);
    if (!warning.empty()) text += fmt::format("\n{}", wrapped_text(warning, "WARNING  ", table_line_width));
    for (const TableSection& section : reference_table_sections(table)) {
        text += fmt::format("\n{}\n{}\n{}", section.title,
                            wrapped_text(section.introduction, "", table_line_width),
                            aligned_text(section.table));
    }
    if (!table.notes.empty()) text += "\nNotes\n";
    for (std::size_t i = 0; i < table.notes.size(); ++i)
        text += wrapped_text(table.notes[i], fmt::format("{}. ", i + 1), table_line_width);
    return text;
}

std::string reference_table_markdown(const ReferenceTable& table) {
    std::string text = fmt::format("# {}\n\n{}\n", title, introduction);
    const std::string warning = unproved_warning(table);
    if (!warning.empty()) text += fmt::format("\n**Warning.** {}\n", warning);
    for (const TableSection& section : reference_table_sections(table)) {
        text += fmt::format("\n## {}\n\n{}\n\n{}", section.title, section.introduction,
                            markdown_text(section.table));
    }
    if (!table.notes.empty()) text += "\n## Notes\n\n";
    for (std::size_t i = 0; i < table.notes.size(); ++i)
        text += fmt::format("{}. {}\n", i + 1, table.notes[i]);
    return text;
}

}  // namespace camopt
