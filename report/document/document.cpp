// SPDX-License-Identifier: MIT
#include "report/document/document.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

const char* bound_words(Bound bound) {
    switch (bound) {
        case Bound::exact:
            return "";
        case Bound::at_least:
            return "at least ";
        case Bound::at_most:
            return "at most ";
    }
    throw ModelError("bound_words: found an unknown bound");
}

}  // namespace

std::string Field::file_key() const {
    return key + unit.suffix;
}

std::string Field::shown_title() const {
    if (!title.empty()) return title;
    return words_of(key) + (unit.name.empty() ? "" : " " + unit.name);
}

std::string shown_text(const Cell& cell, const Field& field) {
    if (!cell.words.empty()) return cell.words;
    if (cell.holds) return *cell.holds ? "yes" : "no";
    if (!cell.value) return field.left ? "" : "–";
    if (field.decimals) return fixed_text(field.unit.of(*cell.value), *field.decimals);
    const std::string number = cell.unit ? cell.unit->text(*cell.value, cell.digits)
                                         : short_text(field.unit.of(*cell.value), cell.digits);
    return bound_words(cell.bound) + number;
}

std::string place_text(const Figure& figure) {
    if (!figure.at_words.empty() || !figure.at) return figure.at_words;
    return figure.place.text(*figure.at);
}

bool has_own_unit(const Cell& cell, const Field& field) {
    return cell.value && cell.unit && field.unit.name.empty();
}

std::optional<double> file_number(const Cell& cell, const Field& field) {
    if (!cell.value) return {};
    return (has_own_unit(cell, field) ? *cell.unit : field.unit).of(*cell.value);
}

const std::string& file_words(const Cell& cell) {
    return cell.key.empty() ? cell.words : cell.key;
}

Figure place_figure(const Figure& figure) {
    return {{figure.field.key + "_at", {}, figure.place}, Cell(*figure.at)};
}

TextTable text_table(const Table& table, unsigned to) {
    TextTable shown;
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < table.rows.size(); ++r)
        if (table.in_texts(r)) rows.push_back(r);
    shown.rows.resize(rows.size());
    shown.folders = table.folders;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const auto is_empty = [&](const std::vector<Cell>& row) {
            return i >= row.size() || (row[i].words.empty() && !row[i].value && !row[i].holds);
        };
        const Field& field = table.columns[i];
        if ((field.where & to) == 0 || std::ranges::all_of(table.rows, is_empty)) continue;
        shown.columns.push_back({field.shown_title(), field.left, field.code});
        for (std::size_t r = 0; r < rows.size(); ++r)
            shown.rows[r].push_back(shown_text(table.rows[rows[r]][i], field));
    }
    return shown;
}

void Section::say(Sentence::Kind kind, const std::string& about, std::vector<std::string> texts,
                  unsigned to) {
    for (std::string& text : texts) sentences.push_back({kind, about, std::move(text), to});
}

Section listing(std::string key, std::string title, std::vector<std::string> remarks, unsigned where) {
    Section section{.key = std::move(key), .title = std::move(title)};
    section.where = where;
    section.say(Sentence::Kind::remark, section.key, std::move(remarks));
    return section;
}

std::vector<std::string> Section::said(std::initializer_list<Sentence::Kind> kinds, unsigned to) const {
    std::vector<std::string> all;
    for (const Sentence& sentence : sentences)
        if ((where & sentence.where & to) != 0 && std::ranges::find(kinds, sentence.kind) != kinds.end())
            all.push_back(sentence.text);
    return all;
}

std::vector<const Table*> Section::shown_tables(unsigned to) const {
    std::vector<const Table*> all;
    for (const Table& table : tables)
        if (table.file.empty() && !table.rows.empty() && (where & table.where & to) != 0)
            all.push_back(&table);
    return all;
}

std::vector<std::string> Document::sentences(std::initializer_list<Sentence::Kind> kinds, unsigned to) const {
    std::vector<std::string> all;
    for (const Section& section : sections)
        std::ranges::move(section.said(kinds, to), std::back_inserter(all));
    return all;
}

std::vector<const Picture*> Document::pictures() const {
    std::vector<const Picture*> all;
    for (const Section& section : sections)
        for (const Picture& picture : section.pictures) all.push_back(&picture);
    return all;
}

const Curves* Document::curves() const {
    for (const Section& section : sections)
        if (section.curves && !section.curves->curves.empty()) return &*section.curves;
    return nullptr;
}

}  // namespace camopt
