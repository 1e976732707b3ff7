// SPDX-License-Identifier: MIT
#include "output/chart/svg_canvas.hpp"

#include "core/text/printable.hpp"

#include <fmt/format.h>

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

}  // namespace camopt
