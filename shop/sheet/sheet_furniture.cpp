// SPDX-License-Identifier: MIT
#include "core/text/printable.hpp"
#include "shop/sheet/sheet_painter.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

// m on the paper.
constexpr double cell_label = 1.8e-3, title_text = 2.5e-3, part_text = 3.5e-3, cell_padding = 1.5e-3,
                 below_words = 1.2e-3, above_label = 0.9e-3;
constexpr double table_text = 2.0e-3, row_height = 3.9e-3, angle_column = 9e-3, radius_column = 15.5e-3,
                 block_gap = 2e-3;
constexpr double note_text = 1.8e-3, note_line = 3.3e-3;
const char* const block_layer = "TITLE_BLOCK";

struct TitleCell {
    double left, bottom, right, top;  ///< from the block's lower left corner
    const char* label;
    std::string words;
    double height = title_text;
};

void add_cell(Sheet& sheet, const Vector2d& corner, const TitleCell& cell) {
    sheet.rectangle(block_layer, SheetPen::thin, corner + Vector2d(cell.left, cell.bottom),
                    corner + Vector2d(cell.right, cell.top), SheetSpace::paper);
    const Vector2d left = corner + Vector2d(cell.left + cell_padding, 0.0);
    sheet.texts.push_back(
        {block_layer, {left.x(), corner.y() + cell.top - above_label - cell_label}, cell_label, cell.label});
    if (cell.words.empty()) return;
    const double width = cell.right - cell.left - 2.0 * cell_padding;
    double height = cell.height;
    const std::string words = printable(cell.words);
    while (height > cell_label && widest_text(words, height) > width) height -= 0.1e-3;
    sheet.texts.push_back({block_layer,
                           {left.x(), corner.y() + cell.bottom + below_words},
                           height,
                           fitted_words(words, height, width)});
}

/// A word that is longer than a line is broken where the line ends.
std::vector<std::string> broken_lines(const std::string& words, double width) {
    std::vector<std::string> lines;
    std::string line;
    std::size_t at = 0;
    while (at < words.size()) {
        const std::size_t space = std::min(words.find(' ', at), words.size());
        const std::string word = words.substr(at, space - at);
        std::string longer = line;
        longer.append(line.empty() ? "" : " ").append(word);
        if (widest_text(longer, note_text) <= width) {
            line = longer;
        } else {
            if (!line.empty()) lines.push_back(line);
            line = fitted_words(word, note_text, width);
        }
        at = space + 1;
    }
    if (!line.empty()) lines.push_back(line);
    return lines;
}

/// ISO 5456-2: a frustum seen from the side and, where the view from the left stands, from its small end.
void add_projection_symbol(Sheet& sheet, const Vector2d& left, Projection projection) {
    constexpr double large = 2.0e-3, small = 1.0e-3, length = 6e-3, gap = 2e-3, overhang = 0.8e-3;
    const bool third = projection == Projection::third_angle;
    const double cone = third ? 2.0 * large + gap : 0.0, circles = third ? large : length + gap + large;
    const auto at = [&](double x, double y) -> Vector2d { return left + Vector2d(x, y); };
    sheet.paths.push_back({block_layer,
                           SheetPen::thick,
                           {{at(cone, -small), 0.0},
                            {at(cone + length, -large), 0.0},
                            {at(cone + length, large), 0.0},
                            {at(cone, small), 0.0}},
                           true,
                           SheetSpace::paper});
    for (const double radius : {small, large})
        sheet.circles.push_back({block_layer, SheetPen::thick, at(circles, 0.0), radius, SheetSpace::paper});
    const auto axis = [&](const Vector2d& from, const Vector2d& to) {
        sheet.line(block_layer, SheetPen::chain, from, to, SheetSpace::paper);
    };
    axis(at(-overhang, 0.0), at(2.0 * large + gap + length + overhang, 0.0));
    axis(at(circles, -large - overhang), at(circles, large + overhang));
}

}  // namespace

std::string fitted_words(const std::string& words, double height, double width) {
    if (widest_text(words, height) <= width) return words;
    std::string shorter = words;
    do {
        do shorter.pop_back();
        while (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0xc0U) == 0x80U);
        if (!shorter.empty() && (static_cast<unsigned char>(shorter.back()) & 0xc0U) == 0xc0U)
            shorter.pop_back();
    } while (!shorter.empty() && widest_text(shorter + "…", height) > width);
    return shorter + "…";
}

void add_frame(Sheet& sheet, const TitleBlock& title, const std::string& mass, Projection projection) {
    const Vector2d low(sheet_left_margin, sheet_margin),
        high(sheet.width - sheet_margin, sheet.height - sheet_margin);
    sheet.rectangle("FRAME", SheetPen::thick, low, high, SheetSpace::paper);
    const Vector2d corner(high.x() - title_block_width, low.y());
    constexpr double row = title_block_height / 4.0, end = title_block_width, middle = 70e-3, last = 128e-3,
                     symbol = 150e-3;
    const std::string format = sheet.format + ", " + name_of(sheet.lengths);
    for (const TitleCell& cell :
         {TitleCell{0.0, 2.0 * row, middle, 4.0 * row, "part", title.part, part_text},
          TitleCell{middle, 3.0 * row, 110e-3, 4.0 * row, "number", title.number},
          TitleCell{110e-3, 3.0 * row, last, 4.0 * row, "revision", title.revision},
          TitleCell{last, 3.0 * row, end, 4.0 * row, "date", title.date},
          TitleCell{middle, 2.0 * row, last, 3.0 * row, "organisation", title.organisation},
          TitleCell{last, 2.0 * row, end, 3.0 * row, "drawn by", title.drawn_by},
          TitleCell{0.0, row, middle, 2.0 * row, "material", title.material},
          TitleCell{middle, row, last, 2.0 * row, "tolerances", title.tolerance},
          TitleCell{last, row, end, 2.0 * row, "profile tolerance", title.profile_tolerance},
          TitleCell{0.0, 0.0, 38e-3, row, "surface finish", title.surface_finish},
          TitleCell{38e-3, 0.0, middle, row, "mass", mass},
          TitleCell{middle, 0.0, 92e-3, row, "scale", sheet.scale_words},
          TitleCell{92e-3, 0.0, last, row, "format, lengths", format},
          TitleCell{last, 0.0, end, row, "projection", ""}})
        add_cell(sheet, corner, cell);
    add_projection_symbol(sheet, corner + Vector2d(symbol, 0.5 * row), projection);
    sheet.rectangle(block_layer, SheetPen::thick, corner,
                    corner + Vector2d(title_block_width, title_block_height), SheetSpace::paper);
}

double SheetTable::width() const {
    const double block = angle_column + radius_column * static_cast<double>(head.size() - 1);
    return blocks() * (block + block_gap) - block_gap;
}

void add_table(Sheet& sheet, const SheetTable& table, const Vector2d& top_left) {
    const double block_width = angle_column + radius_column * static_cast<double>(table.head.size() - 1);
    const auto add_row = [&](const std::vector<std::string>& row, double left, double top) {
        double right = left;
        for (std::size_t column = 0; column < row.size(); ++column) {
            right += column == 0 ? angle_column : radius_column;
            sheet.texts.push_back({"TABLE",
                                   {right - cell_padding, top - row_height + 1.0e-3},
                                   table_text,
                                   row[column],
                                   TextSide::end});
        }
    };
    for (int block = 0; block < table.blocks(); ++block) {
        const double left = top_left.x() + block * (block_width + block_gap);
        const auto first = static_cast<std::size_t>(block) * static_cast<std::size_t>(table.rows_a_block);
        const std::size_t last =
            std::min(first + static_cast<std::size_t>(table.rows_a_block), table.rows.size());
        add_row(table.head, left, top_left.y());
        for (std::size_t row = first; row < last; ++row)
            add_row(table.rows[row], left, top_left.y() - row_height * static_cast<double>(1 + row - first));
        const double bottom = top_left.y() - row_height * static_cast<double>(1 + last - first);
        sheet.rectangle("TABLE", SheetPen::thin, {left, bottom}, {left + block_width, top_left.y()},
                        SheetSpace::paper);
        sheet.line("TABLE", SheetPen::thin, {left, top_left.y() - row_height},
                   {left + block_width, top_left.y() - row_height}, SheetSpace::paper);
        for (std::size_t column = 1; column < table.head.size(); ++column) {
            const double x = left + angle_column + radius_column * static_cast<double>(column - 1);
            sheet.line("TABLE", SheetPen::thin, {x, bottom}, {x, top_left.y()}, SheetSpace::paper);
        }
    }
}

void add_notes(Sheet& sheet, const std::vector<std::string>& notes, const Vector2d& top_left,
               const Vector2d& size) {
    std::vector<std::string> lines;
    for (const std::string& note : notes)
        for (std::string& line : broken_lines(printable(note), size.x())) lines.push_back(std::move(line));
    const auto room = static_cast<std::size_t>(size.y() / note_line);
    if (lines.size() > room) {
        lines.resize(room);
        lines.back() = "… more in the report";
    }
    double y = top_left.y() - note_text;
    for (const std::string& line : lines) {
        sheet.texts.push_back({"NOTES", {top_left.x(), y}, note_text, line});
        y -= note_line;
    }
}

Vector2d unit_vector(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

double direction_angle(const Vector2d& direction) {
    return std::atan2(direction.y(), direction.x());
}

double ModelBox::exit(const Vector2d& ray) const {
    double reach = HUGE_VAL;
    for (int i = 0; i < 2; ++i) {
        const double side = ray(i) > 0.0 ? high(i) : low(i);
        if (std::abs(ray(i)) > 1e-12) reach = std::min(reach, side / ray(i));
    }
    return reach;
}

double FreeDirections::next() {
    constexpr int steps = 24;
    double best = 0.0, most = -1.0;
    for (int k = 0; k < steps; ++k) {
        const double angle = (k + 0.5) * units::turn / steps;
        double nearest = units::turn;
        for (const double other : taken_)
            nearest = std::min(nearest, std::abs(std::remainder(angle - other, units::turn)));
        if (nearest > most + 1e-9) most = nearest, best = angle;
    }
    take(best);
    return best;
}

}  // namespace camopt
