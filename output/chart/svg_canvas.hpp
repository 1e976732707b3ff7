// SPDX-License-Identifier: MIT
// A picture in SVG, drawn element by element, and labels that keep out of each other's way: each takes the
// first of its places that is free. Lengths in px, y downwards; looks come from CSS classes. Text is escaped.
// Nothing is checked and nothing throws.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// Fonts of every picture and page, as CSS names them.
inline constexpr std::string_view picture_fonts = "'DejaVu Sans','Helvetica Neue',Arial,sans-serif";

class SvgCanvas {
 public:
    /// Elements for insert().
    SvgCanvas() = default;
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

    [[nodiscard]] const std::string& elements() const { return content_; }
    [[nodiscard]] std::string finish() const;

 private:
    std::string content_;
};

/// A coordinate: a hundredth of a pixel is exact enough.
[[nodiscard]] std::string svg_number(double value);

/// px: no line of text of this size is wider; of DejaVu Sans, a little more.
[[nodiscard]] double text_width(std::string_view words, double font_size, bool bold = false);

enum class TextSide { start, middle, end };

struct TextPlace {
    double x = 0.0, y = 0.0;  ///< px, anchor on the baseline
    TextSide side = TextSide::start;
};

/// Where a label is best placed from its mark; beside: at its height.
enum class LabelSide { aside, beside, above, below };

/// Places around a mark at (x, y), the nearest first: on that side, right and left of it, above and below,
/// then further out.
[[nodiscard]] std::vector<TextPlace> places_around(double x, double y, double width, double font_size,
                                                   LabelSide side = LabelSide::aside);

/// Places along a horizontal line: at its beginning, its end, between, beyond; above or below first.
[[nodiscard]] std::vector<TextPlace> places_along(double from, double to, double y, bool above);

/// Of what has been placed so far.
class PlacedTexts {
 public:
    /// px: labels stay within.
    PlacedTexts(double left, double top, double right, double bottom)
        : left_(left), top_(top), right_(right), bottom_(bottom) {}

    /// No label covers the mark at (x, y), so far out on each side.
    void keep_free(double x, double y, double half) {
        taken_.push_back({x - half, y - half, x + half, y + half});
    }

    /// The first free place inside, drawn and taken; where there is none, nothing is drawn. False then.
    bool draw(SvgCanvas& canvas, std::string_view words, std::span<const TextPlace> places,
              std::string_view css_class, double font_size = 12.0, bool bold = false);

 private:
    struct Box {
        double left, top, right, bottom;
    };
    double left_, top_, right_, bottom_;
    std::vector<Box> taken_;
};

}  // namespace camopt
