// SPDX-License-Identifier: MIT
#include "shop/sheet/sheet_furniture.hpp"

#include "core/text/printable.hpp"

namespace camopt {

namespace {

using Eigen::Vector2d;

// m on the paper.
constexpr double cell_label = 1.8e-3, title_text = 2.5e-3, part_text = 3.5e-3, cell_padding = 1.5e-3,
                 below_words = 1.2e-3, above_label = 0.9e-3;
constexpr double table_text = 2.0e-3, row_height = 3.9e-3, angle_column = 9e-3, radius_column = 15.5e-3,
                 block_gap = 2e-3;
constexpr double note_text = 1.8e-3, note_line = 3.3e-3;

/// A format of ISO 216, landscape.
struct SheetFormat {
    const char* name;
    double width, height;
};
constexpr std::array<SheetFormat, 2> sheet_formats = {{{"A4", 0.297, 0.210}, {"A3", 0.420, 0.297}}};

struct TitleCell {
    double left, bottom, right, top;  ///< from the block's lower left corner
    const char* label;
    std::string words;
    double height = title_text;
};

void add_cell(Drawing& paper, const Vector2d& corner, const TitleCell& cell) {
    paper.rectangle("cell", corner + Vector2d(cell.left, cell.bottom),
                    corner + Vector2d(cell.right, cell.top));
    const double left = corner.x() + cell.left + cell_padding;
    paper.text(
        {"block-words", {left, corner.y() + cell.top - above_label - cell_label}, cell_label, cell.label});
    if (cell.words.empty()) return;
    const double width = cell.right - cell.left - 2.0 * cell_padding;
    double height = cell.height;
    const std::string words = printable(cell.words);
    while (height > cell_label && widest_text(words, height) > width) height -= 0.1e-3;
    paper.text({"block-words",
                {left, corner.y() + cell.bottom + below_words},
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
void add_projection_symbol(Drawing& paper, const Vector2d& left, Projection projection) {
    constexpr double large = 2.0e-3, small = 1.0e-3, length = 6e-3, gap = 2e-3, overhang = 0.8e-3;
    const bool third = projection == Projection::third_angle;
    const double cone = third ? 2.0 * large + gap : 0.0, circles = third ? large : length + gap + large;
    const auto at = [&](double x, double y) -> Vector2d { return left + Vector2d(x, y); };
    paper.polyline("block",
                   std::array<Vector2d, 4>{at(cone, -small), at(cone + length, -large),
                                           at(cone + length, large), at(cone, small)},
                   true);
    for (const double radius : {small, large}) paper.circle("block", at(circles, 0.0), radius);
    paper.line("block-axis", at(-overhang, 0.0), at(2.0 * large + gap + length + overhang, 0.0));
    paper.line("block-axis", at(circles, -large - overhang), at(circles, large + overhang));
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
    Drawing paper;
    paper.rectangle("frame", low, high);
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
        add_cell(paper, corner, cell);
    add_projection_symbol(paper, corner + Vector2d(symbol, 0.5 * row), projection);
    paper.rectangle("block", corner, corner + Vector2d(title_block_width, title_block_height));
    sheet.add_on_paper(std::move(paper));
}

Vector2d room_for_views(const Sheet& sheet, double table_width) {
    return {sheet.width - sheet_left_margin - sheet_margin - table_width - 2.0 * block_distance,
            sheet.height - 2.0 * sheet_margin - title_block_height - 2.0 * block_distance};
}

void choose_format(Sheet& sheet, const Vector2d& size, const Vector2d& words, double table_width) {
    std::optional<StandardScale> chosen;
    for (const SheetFormat& format : sheet_formats) {
        Sheet tried;
        tried.width = format.width;
        tried.height = format.height;
        const StandardScale scale = standard_scale(size, room_for_views(tried, table_width) - words);
        if (chosen && !(scale.value > chosen->value)) continue;
        chosen = scale;
        sheet.format = format.name;
        sheet.width = format.width;
        sheet.height = format.height;
        if (scale.value >= 1.0) break;
    }
    sheet.scale = chosen->value;
    sheet.scale_words = chosen->words;
}

double SheetTable::width() const {
    const double block = angle_column + radius_column * static_cast<double>(head.size() - 1);
    return blocks() * (block + block_gap) - block_gap;
}

void add_table(Sheet& sheet, const SheetTable& table, const Vector2d& top_left) {
    const double block_width = angle_column + radius_column * static_cast<double>(table.head.size() - 1);
    Drawing paper;
    const auto add_row = [&](const std::vector<std::string>& row, double left, double top) {
        double right = left;
        for (std::size_t column = 0; column < row.size(); ++column) {
            right += column == 0 ? angle_column : radius_column;
            paper.text({"numbers",
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
        paper.rectangle("table", {left, bottom}, {left + block_width, top_left.y()});
        paper.line("table", {left, top_left.y() - row_height},
                   {left + block_width, top_left.y() - row_height});
        for (std::size_t column = 1; column < table.head.size(); ++column) {
            const double x = left + angle_column + radius_column * static_cast<double>(column - 1);
            paper.line("table", {x, bottom}, {x, top_left.y()});
        }
    }
    sheet.add_on_paper(std::move(paper));
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
    Drawing paper;
    double y = top_left.y() - note_text;
    for (const std::string& line : lines) {
        paper.text({"notes", {top_left.x(), y}, note_text, line});
        y -= note_line;
    }
    sheet.add_on_paper(std::move(paper));
}

}  // namespace camopt
