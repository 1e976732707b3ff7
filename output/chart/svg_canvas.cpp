// SPDX-License-Identifier: MIT
#include "output/chart/svg_canvas.hpp"

#include "core/printable.hpp"

#include <fmt/format.h>

namespace camopt {

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
        "role=\"img\">\n<title>{2}</title>\n<style>{3}</style>\n",
        svg_number(width), svg_number(height), xml_text(title), style);
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

std::string SvgCanvas::finish() const {
    return content_ + "</svg>\n";
}

}  // namespace camopt
