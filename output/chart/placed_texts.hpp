// SPDX-License-Identifier: MIT
// Labels that keep out of each other's way: each takes the first of its places that is free.
#pragma once

#include "output/chart/svg_canvas.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace camopt {

/// px: no line of text of this size is wider; of DejaVu Sans, a little more.
[[nodiscard]] double text_width(std::string_view words, double font_size, bool bold = false);

enum class TextSide { start, middle, end };

struct TextPlace {
    double x = 0.0, y = 0.0;  ///< px, anchor on the baseline
    TextSide side = TextSide::start;
};

/// Places around a mark at (x, y), the nearest first: right and left of it, above and below, then farther
/// out.
[[nodiscard]] std::vector<TextPlace> places_around(double x, double y, double width, double font_size);

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
