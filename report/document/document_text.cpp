// SPDX-License-Identifier: MIT
#include "report/document/document_text.hpp"

#include "core/text/printable.hpp"
#include "core/version.hpp"
#include "report/chart/curve_chart.hpp"
#include "report/csv/csv_line.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

constexpr auto said_first = {Kind::headline, Kind::verdict, Kind::warning, Kind::remark};
constexpr int console_width = 110;

std::string figure_line(const Figure& figure) {
    const std::string place = place_text(figure);
    return fmt::format("{}: {}{}", figure.field.shown_title(), shown_text(figure.cell, figure.field),
                       place.empty() ? "" : " at " + place);
}

std::vector<const Figure*> figures_of(const Document& document) {
    std::vector<const Figure*> all;
    for (const Section& section : document.sections)
        for (const Figure& figure : section.figures) all.push_back(&figure);
    return all;
}

void add_cell(CsvLine& line, const Cell& cell, const Field& field) {
    if (cell.value)
        line.number(file_number(cell, field));
    else if (cell.holds)
        line.words(*cell.holds ? "true" : "false");
    else
        line.words(file_words(cell));
}

std::string cell_line(std::string_view table, std::string_view row, const Cell& cell, const Field& field) {
    CsvLine line;
    line.words(table).words(row).words(field.file_key());
    add_cell(line, cell, field);
    return line.words(has_own_unit(cell, field) ? cell.unit->name : field.unit.name).finish();
}

/// Its numbers are in their units already.
Table table_of(const Curves& curves) {
    const auto column = [](const std::string& key, const ShownUnit& unit) {
        return Field{key, {}, ShownUnit(unit.name, 1.0, unit.suffix)};
    };
    Table table{curves.key, {}, {column(curves.angle_key, curves.angle_unit)}};
    for (const Curve& curve : curves.curves) table.columns.push_back(column(curve.key, curve.unit));
    for (std::size_t i = 0; i < curves.angles.size(); ++i) {
        std::vector<Cell>& row = table.rows.emplace_back();
        row.emplace_back(curves.angles[i]);
        for (const Curve& curve : curves.curves) row.emplace_back(curve.values[i]);
    }
    return table;
}

/// Of these readers; figures without a title are for files.
std::vector<std::string> figure_lines(const Section& section, unsigned to) {
    std::vector<std::string> lines;
    for (const Figure& figure : section.figures)
        if (!figure.field.title.empty() && (section.where & figure.field.where & to) != 0)
            lines.push_back(figure_line(figure));
    return lines;
}

std::string console_section(const Section& section) {
    const std::vector<std::string> said = section.said(said_first, Where::console);
    const std::string lead = section.title.empty() ? "" : "  ";
    std::string text = lead.empty() || said.empty() ? "" : "\n" + section.title + "\n";
    for (const std::string& sentence : said) text += wrapped_text(printable(sentence), lead, console_width);
    for (const std::string& line : figure_lines(section, Where::console)) text += "  " + line + "\n";
    for (const Table* table : section.shown_tables(Where::console)) {
        text += fmt::format("\n{}\n{}", table->title, aligned_text(text_table(*table, Where::console)));
        if (!table->note.empty() && (table->note_where & Where::console) != 0)
            text += wrapped_text(table->note, "", console_width);
    }
    return text;
}

std::string markdown_list(const std::vector<std::string>& sentences) {
    std::string text;
    for (const std::string& sentence : sentences) text += "- " + markdown_words(sentence) + "\n";
    return text;
}

/// In a fence that is longer than any in it.
std::string fenced(const std::string& code) {
    std::string fence = "```";
    while (code.find(fence) != std::string::npos) fence += '`';
    return fmt::format("\n{}toml\n{}{}{}\n", fence, printable_lines(code), code.ends_with('\n') ? "" : "\n",
                       fence);
}

std::string markdown_section(const Section& section) {
    std::string text;
    for (const std::string& words : section.said({Kind::headline}, Where::markdown))
        text += fmt::format("**{}{}**\n\n", markdown_words(words), words.ends_with('.') ? "" : ".");
    if (section.title.empty())
        for (const std::string& words :
             section.said({Kind::verdict, Kind::warning, Kind::remark}, Where::markdown))
            text += markdown_words(words) + "\n\n";
    else
        text += markdown_list(
            section.said({Kind::verdict, Kind::warning, Kind::remark, Kind::effort}, Where::markdown));
    text += markdown_list(figure_lines(section, Where::markdown));
    if (section.curves && !section.curves->curves.empty())
        text += fmt::format("\n![{}]({}.svg)\n", section.curves->caption, section.curves->key);
    for (const Picture& picture : section.pictures)
        if ((picture.where & Where::markdown) != 0)
            text += fmt::format("\n![{}]({}.svg)\n", picture.caption, picture.key);
    for (const Table* table : section.shown_tables(Where::markdown)) {
        text += (table->title.empty() ? "" : fmt::format("\n## {}\n\n", table->title)) +
                markdown_text(text_table(*table, Where::markdown));
        if (!table->note.empty() && (table->note_where & Where::markdown) != 0)
            text += "\n" + table->note + "\n";
    }
    if (!section.code.empty()) text += fenced(section.code);
    return section.title.empty() || text.empty() ? text : fmt::format("\n## {}\n\n{}", section.title, text);
}

}  // namespace

std::string console_text(const Document& document) {
    std::string text = printable(document.title) + "\n";
    for (const Section& section : document.sections) text += console_section(section);
    const std::vector<std::string> effort = document.sentences({Kind::effort}, Where::console);
    if (!effort.empty()) text += "\n";
    for (const std::string& note : document.sentences({Kind::note}, Where::console))
        text += "note: " + printable(note) + "\n";
    for (const std::string& sentence : effort) text += printable(sentence) + "\n";
    return text;
}

std::string document_markdown(const Document& document, const RunOrigin& origin) {
    std::string text = fmt::format("# {}\n\n", markdown_words(document.title));
    for (const Section& section : document.sections)
        if ((section.where & Where::markdown) != 0) text += markdown_section(section);
    const std::vector<std::string> notes = document.sentences({Kind::note}, Where::markdown);
    if (!notes.empty()) text += "\n## Notes\n\n" + markdown_list(notes);
    const std::string command =
        origin.command.empty() ? "" : fmt::format("Command: {}, ", markdown_code(origin.command));
    return text + fmt::format("\n{}camopt {}\n", command, version());
}

std::string cells_csv(const Document& document) {
    std::string text = "table,row,column,value,unit\n";
    for (const Figure* figure : figures_of(document)) {
        text += cell_line("figures", figure->field.key, figure->cell, figure->field);
        if (!figure->at) continue;
        const Figure place = place_figure(*figure);
        text += cell_line("figures", figure->field.key, place.cell, place.field);
    }
    for (const Section& section : document.sections) {
        if (!section.code.empty()) continue;  // its file says it
        for (const Table* table : section.shown_tables(Where::texts))
            for (std::size_t r = 0; r < table->rows.size(); ++r)
                for (std::size_t i = 0; i < table->rows[r].size(); ++i)
                    text +=
                        cell_line(table->key, fmt::format("{}", r + 1), table->rows[r][i], table->columns[i]);
    }
    return text;
}

std::string table_csv(const Table& table) {
    CsvLine titles;
    for (const Field& field : table.columns) titles.words(field.file_key());
    std::string text = titles.finish();
    for (const std::vector<Cell>& row : table.rows) {
        CsvLine line;
        for (std::size_t i = 0; i < row.size(); ++i) add_cell(line, row[i], table.columns[i]);
        text += line.finish();
    }
    return text;
}

std::string curves_svg(const Document& document, const Curves& curves) {
    return curve_set_svg(curves,
                         {.title = document.title,
                          .lines = document.sentences({Kind::headline}),
                          .angle_title = fmt::format("{} ({})", curves.angle_title, curves.angle_unit.name),
                          .line_title = curves.line_title});
}

std::vector<FolderFile> text_files(const Document& document, const RunOrigin& origin) {
    std::vector<FolderFile> files = {{"report.md", document_markdown(document, origin)}};
    std::string cells = cells_csv(document);
    const bool has_cells = cells.find('\n') + 1 < cells.size();
    if (has_cells) files.push_back({"tables.csv", std::move(cells)});
    for (const Section& section : document.sections)
        for (const Table& table : section.tables)
            if (!table.file.empty() && !table.rows.empty()) files.push_back({table.file, table_csv(table)});
    for (const Picture* picture : document.pictures())
        if (picture->chart) files.push_back({picture->key + ".svg", chart_svg(*picture->chart)});
    if (const Curves* curves = document.curves()) {
        files.push_back({curves->key + ".svg", curves_svg(document, *curves)});
        if (curves->table) files.push_back({curves->key + ".csv", table_csv(table_of(*curves))});
    }
    return files;
}

}  // namespace camopt
