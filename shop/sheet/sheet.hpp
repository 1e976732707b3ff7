// SPDX-License-Identifier: MIT
// A drawing sheet: a drawing of the part at true size with the paper around it, from which SVG, PDF and DXF
// are made.
//
// Everything lies in the model, m of the part: what stands on the paper is scale times as large there, and
// paper = origin + scale · model, the paper's origin at its lower left corner, y upwards. Nothing here knows
// a cam.
#pragma once

#include "core/units.hpp"
#include "report/drawing/drawing.hpp"

namespace camopt {

/// Lines of ISO 128: thick ones are twice as wide as thin ones.
enum class SheetPen { thick, thin, dashed, chain, filled, words };

/// Line width and dash pattern, m on the paper; what is filled and words have none.
struct PenLook {
    double width;
    std::span<const double> dashes;  ///< line, gap, line, …; empty: continuous
};
inline constexpr double thick_line = 0.5e-3, thin_line = 0.25e-3;
inline constexpr std::array<double, 2> dashed_line = {3.0e-3, 1.0e-3};
inline constexpr std::array<double, 4> chain_line = {6.0e-3, 1.0e-3, 1.0e-3, 1.0e-3};
inline constexpr double words_halo = 0.8e-3;  ///< m: the white rim of words

// Inline, as bulge_arc: the PDF's painter may be in a separate part (core/platform/parts.hpp).
[[nodiscard]] inline PenLook look_of(SheetPen pen) {
    switch (pen) {
        case SheetPen::thick:
            return {thick_line, {}};
        case SheetPen::thin:
            return {thin_line, {}};
        case SheetPen::dashed:
            return {thin_line, dashed_line};
        case SheetPen::chain:
            return {thin_line, chain_line};
        case SheetPen::filled:
        case SheetPen::words:
            break;
    }
    return {0.0, {}};
}

/// How a style of a sheet's drawing looks, and in which layer of a DXF file it lies.
struct SheetStyle {
    const char* name = "";
    const char* layer = "";
    SheetPen pen = SheetPen::thin;
    int color = 8;  ///< AutoCAD colour index (shop/dxf/dxf_drawing.hpp)
};
/// What lies lower comes first. The names of a cam's outlines are those of report/drawing/plane_cam.hpp.
inline constexpr std::array<SheetStyle, 27> sheet_styles = {{{"cam", "CAM", SheetPen::thick, 7},
                                                             {"groove", "OUTER_FLANK", SheetPen::thick},
                                                             {"rim", "CAM", SheetPen::thick, 7},
                                                             {"pitch", "PITCH", SheetPen::dashed, 5},
                                                             {"open", "OPEN", SheetPen::dashed, 1},
                                                             {"axes", "AXES", SheetPen::chain, 1},
                                                             {"bore", "BORE", SheetPen::thick, 7},
                                                             {"datum", "DATUM", SheetPen::thin, 1},
                                                             {"datum-mark", "DATUM", SheetPen::thick, 1},
                                                             {"section", "SECTION", SheetPen::thick, 7},
                                                             {"hatch", "HATCH"},
                                                             {"rotation", "ROTATION", SheetPen::thick},
                                                             {"rotation-head", "ROTATION", SheetPen::filled},
                                                             {"circle", "BASE_CIRCLE", SheetPen::chain},
                                                             {"prime", "PRIME_CIRCLE", SheetPen::chain},
                                                             {"frame", "FRAME", SheetPen::thick},
                                                             {"cell", "TITLE_BLOCK"},
                                                             {"block", "TITLE_BLOCK", SheetPen::thick},
                                                             {"block-axis", "TITLE_BLOCK", SheetPen::chain},
                                                             {"table", "TABLE"},
                                                             {"dimension", "DIMENSIONS", SheetPen::thin, 3},
                                                             {"arrow", "DIMENSIONS", SheetPen::filled, 3},
                                                             {"measure", "DIMENSIONS", SheetPen::words, 3},
                                                             {"datum-words", "DATUM", SheetPen::words, 1},
                                                             {"block-words", "TITLE_BLOCK", SheetPen::words},
                                                             {"numbers", "TABLE", SheetPen::words},
                                                             {"notes", "NOTES", SheetPen::words}}};

struct Sheet {
    std::string title;
    std::string format;                           ///< "A4"
    double width = 0.297, height = 0.210;         ///< of the paper, m
    Eigen::Vector2d origin = {0.0, 0.0};          ///< on the paper, of the model's origin
    double scale = 1.0;                           ///< paper / model
    std::string scale_words;                      ///< "1:2"
    LengthUnit lengths = LengthUnit::millimetre;  ///< of all numbers on it
    Drawing drawing;
    std::vector<DrawnDimension> dimensions;

    /// Of the model, in so much on the paper; m.
    [[nodiscard]] double paper(double length) const { return length / scale; }
    /// Takes in what is drawn on the paper.
    void add_on_paper(Drawing drawn);
    /// Pictures of the paper: so many of their units in a metre of it.
    [[nodiscard]] PicturePlace place(double a_metre) const {
        return {a_metre * Eigen::Vector2d(origin.x(), height - origin.y()),
                Eigen::Vector2d::Constant(a_metre * scale)};
    }
};

/// No text is wider: of DejaVu Sans, whose letters are wider than those of other fonts in its place, at this
/// height of a capital letter; m.
[[nodiscard]] double widest_text(std::string_view words, double height);

/// A micrometre, or a ten-thousandth of an inch.
[[nodiscard]] int drawn_decimals(LengthUnit unit);
/// That many decimals at most, no trailing zeros.
[[nodiscard]] std::string drawn_length(double metres, LengthUnit unit = LengthUnit::millimetre);

/// The largest scale of ISO 5455 (…, 2:1, 1:1, 1:2, 1:5, 1:10, …) at which `size` fits into `room`; m.
struct StandardScale {
    double value = 1.0;
    std::string words;
};
[[nodiscard]] StandardScale standard_scale(const Eigen::Vector2d& size, const Eigen::Vector2d& room);

}  // namespace camopt
