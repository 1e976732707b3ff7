// SPDX-License-Identifier: MIT
// A drawing sheet as a list of what stands on it: one description, from which SVG, PDF and DXF are made.
//
// Two spaces. paper: m on the sheet, the origin at its lower left corner, y upwards. model: m of the part;
// paper = view.origin + view.scale · model. A DXF file is the model at true size, the paper around it.
// Nothing here knows a cam.
#pragma once

#include "core/units.hpp"
#include "shop/dxf/arc_chain.hpp"

namespace camopt {

enum class SheetSpace { paper, model };

struct SheetView {
    Eigen::Vector2d origin = {0.0, 0.0};  ///< paper, of the model's origin
    double scale = 1.0;                   ///< paper / model

    [[nodiscard]] Eigen::Vector2d on_paper(const Eigen::Vector2d& model) const {
        return origin + scale * model;
    }
    [[nodiscard]] Eigen::Vector2d in_model(const Eigen::Vector2d& paper) const {
        return (paper - origin) / scale;
    }
};

/// Lines of ISO 128: thick ones are twice as wide as thin ones.
enum class SheetPen { thick, thin, dashed, chain };

struct SheetPath {
    std::string layer;
    SheetPen pen = SheetPen::thin;
    std::vector<ArcVertex> vertices;  ///< closed: the last arc leads back to the first
    bool closed = false;
    SheetSpace space = SheetSpace::model;
    bool filled = false;
};

struct SheetCircle {
    std::string layer;
    SheetPen pen = SheetPen::thin;
    Eigen::Vector2d center = {0.0, 0.0};
    double radius = 0.0;
    SheetSpace space = SheetSpace::model;
};

/// "⌀25", "R40.5", "30°": lengths as drawn_length, degrees with two decimals.
[[nodiscard]] std::string words_of(const DrawnDimension& dimension);

struct Sheet {
    std::string title;
    std::string format;                    ///< "A4"
    double width = 0.297, height = 0.210;  ///< m
    SheetView view;
    std::string scale_words;                      ///< "1:2"
    LengthUnit lengths = LengthUnit::millimetre;  ///< of all numbers on it
    std::vector<SheetPath> paths;
    std::vector<SheetCircle> circles;
    std::vector<DrawnText> texts;  ///< on the paper
    std::vector<DrawnDimension> dimensions;

    void line(const std::string& layer, SheetPen pen, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
              SheetSpace space = SheetSpace::model);
    void rectangle(const std::string& layer, SheetPen pen, const Eigen::Vector2d& low,
                   const Eigen::Vector2d& high, SheetSpace space = SheetSpace::model);
    /// Of a circle, from angle to angle (rad), counterclockwise where `to` is larger.
    void arc(const std::string& layer, SheetPen pen, const SheetCircle& circle, double from, double to);
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
