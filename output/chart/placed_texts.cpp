// SPDX-License-Identifier: MIT
#include "output/chart/placed_texts.hpp"

#include <algorithm>
#include <string>

namespace camopt {

namespace {

constexpr double bold_wider = 1.1;
constexpr double ascent = 0.78, descent = 0.26;  // of the font's size
constexpr double apart = 1.0;                    // px

}  // namespace

double text_width(std::string_view words, double font_size, bool bold) {
    double ems = 0.0;
    for (const char c : words) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xc0U) == 0x80U) continue;  // inside a letter of UTF-8
        constexpr std::string_view narrow = " ,.:;|!'()ijlIft[]r-/", wide = "mwMWOQ%@";
        ems += narrow.find(c) != std::string_view::npos                          ? 0.42
               : wide.find(c) != std::string_view::npos                          ? 0.99
               : (c >= 'A' && c <= 'Z') || byte >= 0x80U || c == '=' || c == '+' ? 0.84
                                                                                 : 0.64;
    }
    return ems * font_size * (bold ? bold_wider : 1.0);
}

std::vector<TextPlace> places_around(double x, double y, double width, double font_size) {
    constexpr double gap = 6.0, step = 4.0;
    constexpr int rings = 20;
    std::vector<TextPlace> places;
    for (int ring = 0; ring < rings; ++ring) {
        const double out = step * ring;
        const double right = x + gap + 0.5 * out, left = x - gap - 0.5 * out - width;
        for (const double up : {y - 3.0 - out, y + 0.8 * font_size + out}) {
            places.push_back({right, up});
            places.push_back({left, up});
        }
        places.push_back({x - 0.5 * width, y - gap - out});
        places.push_back({x - 0.5 * width, y + gap + font_size + out});
    }
    return places;
}

bool PlacedTexts::draw(SvgCanvas& canvas, std::string_view words, std::span<const TextPlace> places,
                       std::string_view css_class, double font_size, bool bold) {
    const double width = text_width(words, font_size, bold);
    for (const TextPlace& place : places) {
        const double part = place.side == TextSide::start ? 0.0 : place.side == TextSide::middle ? 0.5 : 1.0;
        const Box box{place.x - part * width - apart, place.y - ascent * font_size - apart,
                      place.x + (1.0 - part) * width + apart, place.y + descent * font_size + apart};
        if (box.left < left_ || box.top < top_ || box.right > right_ || box.bottom > bottom_) continue;
        const auto covers = [&](const Box& other) {
            return box.left < other.right && other.left < box.right && box.top < other.bottom &&
                   other.top < box.bottom;
        };
        if (std::ranges::any_of(taken_, covers)) continue;
        taken_.push_back(box);
        std::string classes(css_class);
        if (place.side != TextSide::start) classes += place.side == TextSide::middle ? " middle" : " end";
        canvas.text(place.x, place.y, words, classes);
        return true;
    }
    return false;
}

}  // namespace camopt
