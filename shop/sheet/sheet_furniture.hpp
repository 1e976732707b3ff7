// SPDX-License-Identifier: MIT
// What stands around the views of a drawing: frame, title block, tables, notes. m on the paper.
#pragma once

#include "scene/cam_spec.hpp"
#include "shop/sheet/sheet.hpp"

namespace camopt {

inline constexpr double sheet_margin = 10e-3, sheet_left_margin = 20e-3;
inline constexpr double title_block_width = 170e-3, title_block_height = 30e-3;

/// Frame and title block (ISO 7200) of a sheet that has its size and scale; empty cells stay empty.
void add_frame(Sheet& sheet, const TitleBlock& title, const std::string& mass = {},
               Projection projection = Projection::first_angle);

/// Columns of numbers with a head; the first column is the angle. Rows run on in blocks beside each other.
struct SheetTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
    int rows_a_block = 36;

    [[nodiscard]] int blocks() const {
        return (static_cast<int>(rows.size()) + rows_a_block - 1) / rows_a_block;
    }
    [[nodiscard]] double width() const;
};
/// Format and scale of a sheet for views of this size with so much for words around them, m on the paper,
/// beside a table: A4, or A3 where A4 would make it smaller than it is. Throws InputError for what fits no
/// sheet.
void choose_format(Sheet& sheet, const Eigen::Vector2d& size, const Eigen::Vector2d& words,
                   double table_width);
/// For the views of a sheet that has its format, m on the paper.
[[nodiscard]] Eigen::Vector2d room_for_views(const Sheet& sheet, double table_width);
inline constexpr double block_distance = 4e-3;  ///< between views, table and title block

/// `top_left`: of its box.
void add_table(Sheet& sheet, const SheetTable& table, const Eigen::Vector2d& top_left);

/// Lines of words within a box, broken where they are too long; what does not fit is left out from the end
/// and a line says so.
void add_notes(Sheet& sheet, const std::vector<std::string>& notes, const Eigen::Vector2d& top_left,
               const Eigen::Vector2d& size);

/// The words, or as many as fit with "…" behind them.
[[nodiscard]] std::string fitted_words(const std::string& words, double height, double width);

}  // namespace camopt
