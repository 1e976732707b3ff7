// SPDX-License-Identifier: MIT
// A sheet handed out element by element on the paper: what SVG and PDF have in common.
#pragma once

#include "scene/cam_spec.hpp"
#include "shop/sheet/sheet.hpp"

namespace camopt {

/// Line width and dash pattern, m on the paper.
struct PenLook {
    double width;
    std::span<const double> dashes;  ///< line, gap, line, …; empty: continuous
};
inline constexpr double thick_line = 0.5e-3, thin_line = 0.25e-3;
inline constexpr std::array<double, 2> dashed_line = {3.0e-3, 1.0e-3};
inline constexpr std::array<double, 4> chain_line = {6.0e-3, 1.0e-3, 1.0e-3, 1.0e-3};

// Inline, as bulge_arc: a painter may be in a separate part (core/platform/parts.hpp).
[[nodiscard]] inline PenLook look_of(SheetPen pen) {
    switch (pen) {
        case SheetPen::thick:
            return {thick_line, {}};
        case SheetPen::thin:
            return {thin_line, {}};
        case SheetPen::dashed:
            return {thin_line, dashed_line};
        case SheetPen::chain:
            break;
    }
    return {thin_line, chain_line};
}

/// Takes paper coordinates: m, y upwards.
class SheetPainter {
 public:
    virtual ~SheetPainter() = default;
    virtual void path(const SheetPath& path) = 0;
    virtual void circle(const SheetCircle& circle) = 0;
    virtual void text(const DrawnText& text) = 0;

 protected:
    SheetPainter() = default;
    SheetPainter(const SheetPainter&) = default;
    SheetPainter& operator=(const SheetPainter&) = default;
};

/// Lines first, words above them.
void paint(const Sheet& sheet, SheetPainter& painter);

// How a dimension looks on the paper: its lines, arrow heads and words (ISO 129-1). Pictures draw them; a DXF
// file keeps them in the dimension's block.
inline constexpr double dimension_text_height = 2.5e-3;  ///< m

/// On the paper, m.
struct DimensionMarks {
    std::vector<SheetPath> lines;  ///< thin; arcs among them
    std::vector<std::array<Eigen::Vector2d, 3>> arrows;
    DrawnText text;
};

[[nodiscard]] DimensionMarks dimension_marks(const DrawnDimension& dimension, const SheetView& view);

/// Gives the dimensions the sheet's unit, and moves them, one after another, outwards or about the circle
/// that they measure, until no words lie on the words or lines of those before. One that finds no such place
/// stays.
void separate_dimensions(Sheet& sheet);

// What stands around the views of a drawing: frame, title block, tables, notes. m on the paper.

inline constexpr double sheet_margin = 10e-3, sheet_left_margin = 20e-3;
inline constexpr double title_block_width = 170e-3, title_block_height = 30e-3;

/// A format of ISO 216, landscape.
struct SheetFormat {
    const char* name;
    double width, height;
};

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
