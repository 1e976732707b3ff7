// SPDX-License-Identifier: MIT
// What stands around the views of a drawing: frame, title block, tables, notes. m on the paper.
#pragma once

#include "output/sheet/sheet.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace camopt {

inline constexpr double sheet_margin = 10e-3, sheet_left_margin = 20e-3;
inline constexpr double title_block_width = 170e-3, title_block_height = 30e-3;

/// A format of ISO 216, landscape.
struct SheetFormat {
    const char* name;
    double width, height;
};

/// Words of the title block; empty cells stay empty.
struct TitleCells {
    std::string part, material, tolerance, drawn_by;
};

/// Frame and title block of a sheet that has its size and scale.
void add_frame(Sheet& sheet, const TitleCells& cells);

/// Columns of numbers with a head; the first column is the angle. Rows run on in blocks beside each other.
struct SheetTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;
    int rows_a_block = 36;

    [[nodiscard]] int blocks() const;
    [[nodiscard]] double width() const;
    [[nodiscard]] double height() const;
};
/// `top_left`: of its box.
void add_table(Sheet& sheet, const SheetTable& table, const Eigen::Vector2d& top_left);

/// Lines of words within a box, broken where they are too long; what does not fit is left out from the end
/// and a line says so.
void add_notes(Sheet& sheet, const std::vector<std::string>& notes, const Eigen::Vector2d& top_left,
               const Eigen::Vector2d& size);

/// The words, or as many as fit with "…" behind them.
[[nodiscard]] std::string fitted_words(const std::string& words, double height, double width);

[[nodiscard]] Eigen::Vector2d unit_vector(double angle);
[[nodiscard]] double direction_angle(const Eigen::Vector2d& direction);

/// What the views show, m on the cam.
struct ModelBox {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(HUGE_VAL), high = Eigen::Vector2d::Constant(-HUGE_VAL);

    void add(const Eigen::Vector2d& point) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    /// From the origin, which lies inside, along the ray to the rim.
    [[nodiscard]] double exit(const Eigen::Vector2d& ray) const;
};

/// Directions for words around the cam, each as far from all before as can be.
class FreeDirections {
 public:
    void take(double angle) { taken_.push_back(angle); }
    [[nodiscard]] double next();

 private:
    std::vector<double> taken_;
};

}  // namespace camopt
