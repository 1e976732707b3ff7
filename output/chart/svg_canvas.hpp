// SPDX-License-Identifier: MIT
// A picture in SVG, drawn element by element. Lengths in px, y downwards; looks come from CSS classes. Text
// is escaped. Nothing is checked and nothing throws.
#pragma once

#include <string>
#include <string_view>

namespace camopt {

/// Fonts of every picture and page, as CSS names them.
inline constexpr std::string_view picture_fonts = "'DejaVu Sans','Helvetica Neue',Arial,sans-serif";

class SvgCanvas {
 public:
    /// style: CSS rules besides those that every picture has (page, title, subtitle, caption, value, head,
    /// frame and ticks of a plot …), which they overrule; title: what a screen reader says.
    SvgCanvas(double width, double height, std::string_view style, std::string_view title);

    void line(double x1, double y1, double x2, double y2, std::string_view css_class);
    void rectangle(double x, double y, double width, double height, std::string_view css_class);
    void circle(double x, double y, double radius, std::string_view css_class);
    /// data: SVG path data.
    void path(std::string_view data, std::string_view css_class);
    /// (x, y): the anchor on the text's baseline; rotated counterclockwise by `turn` degrees about it.
    void text(double x, double y, std::string_view words, std::string_view css_class, double turn = 0.0);

    /// SVG elements made elsewhere, moved to (x, y).
    void insert(double x, double y, std::string_view elements);

    [[nodiscard]] std::string finish() const;

 private:
    std::string content_;
};

/// A coordinate: a hundredth of a pixel is exact enough.
[[nodiscard]] std::string svg_number(double value);

}  // namespace camopt
