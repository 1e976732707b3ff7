// SPDX-License-Identifier: MIT
// A sheet handed out element by element on the paper: what SVG and PDF have in common.
#pragma once

#include "output/sheet/sheet.hpp"

#include <array>
#include <span>
#include <vector>

namespace camopt {

/// Line width and dash pattern, m on the paper.
struct PenLook {
    double width;
    std::span<const double> dashes;  ///< line, gap, line, …; empty: continuous
};
[[nodiscard]] PenLook look_of(SheetPen pen);

/// Takes paper coordinates: m, y upwards.
class SheetPainter {
 public:
    virtual ~SheetPainter() = default;
    virtual void path(const SheetPath& path) = 0;
    virtual void circle(const SheetCircle& circle) = 0;
    virtual void text(const SheetText& text) = 0;

 protected:
    SheetPainter() = default;
    SheetPainter(const SheetPainter&) = default;
    SheetPainter& operator=(const SheetPainter&) = default;
};

/// Lines first, words above them.
void paint(const Sheet& sheet, SheetPainter& painter);

/// An arc between two vertices as a circle: bulge not 0.
struct BulgeArc {
    Eigen::Vector2d center;
    double radius, from, to;  ///< rad; to > from where it turns to the left
};
[[nodiscard]] BulgeArc bulge_arc(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double bulge);

// How a dimension looks on the paper: its lines, arrow heads and words (ISO 129-1). Pictures draw them; a DXF
// file keeps them in the dimension's block.
inline constexpr double dimension_text_height = 2.5e-3;  ///< m

/// On the paper, m.
struct DimensionMarks {
    std::vector<SheetPath> lines;  ///< thin; arcs among them
    std::vector<std::array<Eigen::Vector2d, 3>> arrows;
    SheetText text;
};

[[nodiscard]] DimensionMarks dimension_marks(const SheetDimension& dimension, const SheetView& view);

}  // namespace camopt
