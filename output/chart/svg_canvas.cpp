// SPDX-License-Identifier: MIT
#include "output/chart/svg_canvas.hpp"

#include "core/text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

/// What every picture has: its page, titles, the frame of a plot. A picture's own rules come behind and hold.
constexpr std::string_view common_style =
    ".page{fill:#fff}.title{font-size:20px;font-weight:600;fill:#111}.subtitle{font-size:13px;fill:#444}"
    ".caption{font-size:14px;font-weight:600;fill:#111}.value{font-size:12px;fill:#222}"
    ".value.right,.end{text-anchor:end}.middle{text-anchor:middle}.faint{fill:#777}"
    ".head{font-size:12px;font-weight:600;fill:#333;text-anchor:end}.head.left{text-anchor:start}"
    ".grid{stroke:#e6e6e6;stroke-width:1}.frame{fill:none;stroke:#8a8a8a;stroke-width:1}"
    ".zero{stroke:#a8a8a8;stroke-width:1}"
    ".tick{font-size:11px;fill:#444}.tick.middle{text-anchor:middle}.tick.right{text-anchor:end}"
    ".axis-title{font-size:12px;fill:#333;text-anchor:middle}";

constexpr double bold_wider = 1.1;
constexpr double ascent = 0.78, descent = 0.26;  // of the font's size
constexpr double apart = 1.0;                    // px

}  // namespace

std::string svg_number(double value) {
    std::string text = fmt::format("{:.2f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

SvgCanvas::SvgCanvas(double width, double height, std::string_view style, std::string_view title) {
    content_ = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "role=\"img\">\n<title>{2}</title>\n<style>text{{font-family:{3};font-size:12px;fill:#222}}{4}{5}</"
        "style>\n",
        svg_number(width), svg_number(height), xml_text(title), picture_fonts, common_style, style);
}

void SvgCanvas::line(double x1, double y1, double x2, double y2, std::string_view css_class) {
    content_ += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" class=\"{}\"/>\n", svg_number(x1),
                            svg_number(y1), svg_number(x2), svg_number(y2), css_class);
}

void SvgCanvas::rectangle(double x, double y, double width, double height, std::string_view css_class) {
    content_ += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" class=\"{}\"/>\n",
                            svg_number(x), svg_number(y), svg_number(width), svg_number(height), css_class);
}

void SvgCanvas::circle(double x, double y, double radius, std::string_view css_class) {
    content_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"{}\"/>\n", svg_number(x),
                            svg_number(y), svg_number(radius), css_class);
}

void SvgCanvas::path(std::string_view data, std::string_view css_class) {
    content_ += fmt::format("<path d=\"{}\" class=\"{}\"/>\n", data, css_class);
}

void SvgCanvas::text(double x, double y, std::string_view words, std::string_view css_class, double turn) {
    const std::string rotation = turn == 0.0 ? std::string{}
                                             : fmt::format(" transform=\"rotate({} {} {})\"",
                                                           svg_number(-turn), svg_number(x), svg_number(y));
    content_ += fmt::format("<text x=\"{}\" y=\"{}\" class=\"{}\"{}>{}</text>\n", svg_number(x),
                            svg_number(y), css_class, rotation, xml_text(words));
}

void SvgCanvas::insert(double x, double y, std::string_view elements) {
    content_ +=
        fmt::format("<g transform=\"translate({} {})\">\n{}</g>\n", svg_number(x), svg_number(y), elements);
}

std::string SvgCanvas::finish() const {
    return content_ + "</svg>\n";
}

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

std::vector<TextPlace> places_around(double x, double y, double width, double font_size, LabelSide side) {
    constexpr double gap = 6.0, gap_of_side = 9.0, step = 4.0;
    constexpr int rings = 20, rings_of_side = 6;
    std::vector<TextPlace> places;
    if (side == LabelSide::beside) places = {{x + gap, y + 4.0}, {x - gap - width, y + 4.0}};
    for (int ring = 0; side >= LabelSide::above && ring < rings_of_side; ++ring) {
        const double out = gap_of_side + step * ring;
        const double base = side == LabelSide::above ? y - out : y + out + 0.8 * font_size;
        for (const double left : {x - 0.5 * width, x + gap, x - gap - width}) places.push_back({left, base});
    }
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

std::vector<TextPlace> places_along(double from, double to, double y, bool above) {
    std::vector<TextPlace> places;
    for (const double base : {above ? y - 6 : y + 15, above ? y + 15 : y - 6}) {
        places.push_back({from + 6, base, TextSide::start});
        places.push_back({to - 6, base, TextSide::end});
        places.push_back({0.5 * (from + to), base, TextSide::middle});
        places.push_back({to + 6, base, TextSide::start});
        places.push_back({from - 6, base, TextSide::end});
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
