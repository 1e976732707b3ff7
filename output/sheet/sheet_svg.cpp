// SPDX-License-Identifier: MIT
#include "output/sheet/sheet_svg.hpp"

#include "core/text/printable.hpp"
#include "core/units.hpp"
#include "output/chart/svg_canvas.hpp"
#include "output/sheet/sheet_painter.hpp"

#include <fmt/format.h>

#include <cmath>

namespace camopt {

namespace {

using Eigen::Vector2d;
using units::degree, units::millimetre;

constexpr double capital_height = 0.729;  // of the font's size

std::string mm_text(double metres) {
    std::string text = fmt::format("{:.4f}", metres / millimetre);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

const char* class_of(SheetPen pen) {
    switch (pen) {
        case SheetPen::thick:
            return "thick";
        case SheetPen::thin:
            return "thin";
        case SheetPen::dashed:
            return "dashed";
        case SheetPen::chain:
            break;
    }
    return "chain";
}

std::string style() {
    std::string rules;
    for (const SheetPen pen : {SheetPen::thick, SheetPen::thin, SheetPen::dashed, SheetPen::chain}) {
        const PenLook look = look_of(pen);
        std::string dashes;
        for (const double length : look.dashes) dashes += (dashes.empty() ? "" : " ") + mm_text(length);
        rules +=
            fmt::format(".{}{{fill:none;stroke:#000;stroke-linejoin:round;stroke-width:{}{}}}", class_of(pen),
                        mm_text(look.width), dashes.empty() ? "" : ";stroke-dasharray:" + dashes);
    }
    return rules + ".filled{fill:#000;stroke:none}.page{fill:#fff}" +
           fmt::format("text{{font-family:{};fill:#000;paint-order:stroke;stroke:#fff;stroke-width:.8}}",
                       picture_fonts);
}

class SvgSheet final : public SheetPainter {
 public:
    explicit SvgSheet(const Sheet& sheet) : height_(sheet.height) {
        text_ = fmt::format(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
            "width=\"{0}mm\" height=\"{1}mm\" viewBox=\"0 0 {0} {1}\" role=\"img\">\n<title>{2}</title>\n"
            "<style>{3}</style>\n<rect class=\"page\" width=\"{0}\" height=\"{1}\"/>\n",
            mm_text(sheet.width), mm_text(sheet.height), xml_text(sheet.title), style());
    }

    void path(const SheetPath& path) override {
        std::string data = "M" + place(path.vertices.front().position);
        const std::size_t count = path.vertices.size();
        for (std::size_t i = 0; i < count; ++i) {
            if (i + 1 == count && !path.closed) break;
            const ArcVertex &from = path.vertices[i], &to = path.vertices[(i + 1) % count];
            data += step(from, to.position);
        }
        text_ += fmt::format("<path class=\"{}\" d=\"{}{}\"/>\n", path.filled ? "filled" : class_of(path.pen),
                             data, path.closed ? "Z" : "");
    }
    void circle(const SheetCircle& circle) override {
        text_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", class_of(circle.pen),
                             mm_text(circle.center.x()), mm_text(height_ - circle.center.y()),
                             mm_text(circle.radius));
    }
    void text(const SheetText& text) override {
        const std::string x = mm_text(text.at.x()), y = mm_text(height_ - text.at.y());
        const char* const anchor = text.anchor == TextAnchor::start    ? "start"
                                   : text.anchor == TextAnchor::middle ? "middle"
                                                                       : "end";
        const std::string turn =
            std::abs(text.turn) < 1e-9
                ? std::string{}
                : fmt::format(" transform=\"rotate({:.3f} {} {})\"", -text.turn / degree, x, y);
        text_ += fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\"{}>{}</text>\n", x,
                             y, mm_text(text.height / capital_height), anchor, turn, xml_text(text.words));
    }
    [[nodiscard]] std::string finish() const { return text_ + "</svg>\n"; }

 private:
    [[nodiscard]] std::string place(const Vector2d& point) const {
        return mm_text(point.x()) + " " + mm_text(height_ - point.y());
    }
    [[nodiscard]] std::string step(const ArcVertex& from, const Vector2d& to) const {
        constexpr double straight =
            1e-9;  // of a bulge: the arc leaves its chord by no more than that part of it
        if (std::abs(from.bulge) < straight) return "L" + place(to);
        const BulgeArc arc = bulge_arc(from.position, to, from.bulge);
        return fmt::format("A{0} {0} 0 {1} {2} {3}", mm_text(arc.radius), std::abs(from.bulge) > 1.0 ? 1 : 0,
                           from.bulge > 0.0 ? 0 : 1, place(to));
    }

    double height_;
    std::string text_;
};

}  // namespace

std::string sheet_svg(const Sheet& sheet) {
    SvgSheet painter(sheet);
    paint(sheet, painter);
    return painter.finish();
}

}  // namespace camopt
