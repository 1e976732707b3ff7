// SPDX-License-Identifier: MIT
// A picture in SVG, drawn element by element, and labels that keep out of each other's way: each takes the
// first of its places that is free. Lengths in px, y downwards; looks come from CSS classes. Text is escaped.
// Nothing is checked and nothing throws.
#pragma once

#include "core/base/standard.hpp"

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
    /// Of paper, in mm: printed to scale, with no other rules than `style`, coordinates within 0.1 µm.
    [[nodiscard]] static SvgCanvas on_paper(double width, double height, std::string_view style,
                                            std::string_view title);

    void line(double x1, double y1, double x2, double y2, std::string_view css_class);
    void rectangle(double x, double y, double width, double height, std::string_view css_class);
    void circle(double x, double y, double radius, std::string_view css_class);
    /// data: SVG path data.
    void path(std::string_view data, std::string_view css_class);
    /// (x, y): the anchor on the text's baseline; rotated counterclockwise by `turn` degrees about it. size:
    /// of the font, where no rule gives it.
    void text(double x, double y, std::string_view words, std::string_view css_class, double turn = 0.0,
              double size = 0.0);

    /// SVG elements made elsewhere, moved to (x, y).
    void insert(double x, double y, std::string_view elements);

    /// A coordinate as this canvas prints it.
    [[nodiscard]] std::string number(double value) const;
    [[nodiscard]] const std::string& elements() const { return content_; }
    [[nodiscard]] std::string finish() const { return content_ + "</svg>\n"; }

 private:
    void begin(double width, double height, std::string_view unit, std::string_view style,
               std::string_view title);

    std::string content_;
    int decimals_ = 2;
};

/// A coordinate, without zeros at its end: a hundredth of a pixel is exact enough.
[[nodiscard]] std::string svg_number(double value, int decimals = 2);

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

    /// Labels keep off this line where they find such a place.
    void avoid(const TextPlace& from, const TextPlace& to);

    /// The first free place inside, drawn and taken; where there is none, nothing is drawn. False then.
    bool draw(SvgCanvas& canvas, std::string_view words, std::span<const TextPlace> places,
              std::string_view css_class, double font_size = 12.0, bool bold = false);

 private:
    struct Box {
        double left, top, right, bottom;
    };
    double left_, top_, right_, bottom_;
    std::vector<Box> taken_, avoided_;
};

// Axes of a plot: round numbers for them, from numbers to px, linear or logarithmic, and the frame with its
// grid and labels.
//
// px lie as on the canvas, y downwards: a vertical axis begins at its bottom. Nothing throws; a logarithmic
// axis needs positive bounds.

struct PlotTick {
    double value = 0.0;
    std::string words;  ///< empty: a line of the grid without a label
};

/// Multiples of a round step (1, 2 or 5 times a power of ten) in [lower, upper]: about `wanted` of them.
[[nodiscard]] std::vector<double> round_ticks(double lower, double upper, int wanted);

/// The same for an angle in degrees: steps a protractor knows (1, 2, 5, 10, 15, 30, 45, 60, 90 …).
[[nodiscard]] std::vector<double> degree_ticks(double lower, double upper, int wanted);

/// round_ticks with their texts: just the decimals that the step between them needs, however few they are.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(double lower, double upper, int wanted);

/// Powers of ten in [lower, upper], every `stride`-th with a label: "10⁻⁹".
[[nodiscard]] std::vector<PlotTick> decade_ticks(double lower, double upper, int stride);

/// The number with just the decimals that tell it from its neighbours.
[[nodiscard]] std::string tick_text(double value, double step);

/// The least and the largest of the finite numbers seen; [0, 0] before the first one.
struct ValueRange {
    double lower = 0.0, upper = 0.0;
    bool started = false;

    void add(double value);
    [[nodiscard]] bool empty() const { return !(upper >= lower) || !started; }
    /// A little wider, and never of no width.
    [[nodiscard]] ValueRange padded(double part) const;
    /// So large a factor that one extreme value would flatten the rest of a linear axis.
    [[nodiscard]] bool spans_factors() const;
};

struct PlotAxis {
    double lower = 0.0, upper = 0.0;
    double begin = 0.0, end = 1.0;  ///< px of lower and upper
    bool logarithmic = false;

    [[nodiscard]] double place(double value) const;
    [[nodiscard]] bool holds(double value) const { return value >= lower && value <= upper; }
};

/// Over a range with some room.
[[nodiscard]] PlotAxis axis_over(const ValueRange& range, bool logarithmic);

/// Of a linear axis round numbers; of a logarithmic one decades, or 1, 2, 5 of each where they are few.
[[nodiscard]] std::vector<PlotTick> labelled_ticks(const PlotAxis& axis, int wanted);

struct PlotFrame {
    PlotAxis horizontal, vertical;
    std::vector<PlotTick> horizontal_ticks, vertical_ticks;
    std::string horizontal_title, vertical_title;  ///< empty: none
};

void draw_plot_frame(SvgCanvas& canvas, const PlotFrame& frame);

/// px that labels and title of the vertical axis take left of the frame.
[[nodiscard]] double room_before(const PlotFrame& frame);

}  // namespace camopt
