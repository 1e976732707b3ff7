// SPDX-License-Identifier: MIT
#include "shop/sheet/sheet_files.hpp"

#include "core/text/printable.hpp"
#include "core/word_of.hpp"
#include "report/chart/svg_canvas.hpp"
#include "report/view/shown_units.hpp"
#include "shop/dxf/dxf_drawing.hpp"
#include "shop/sheet/sheet_painter.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

const char* const dimension_layer_name = "DIMENSIONS";

DxfLine line_of(SheetPen pen) {
    if (pen == SheetPen::dashed) return DxfLine::dashed;
    return pen == SheetPen::chain ? DxfLine::center : DxfLine::continuous;
}

int color_of(const std::string& layer) {
    if (layer == "CAM" || layer == "BORE" || layer == "SECTION") return 7;
    if (layer == dimension_layer_name) return 3;
    if (layer == "PITCH") return 5;
    if (layer == "AXES" || layer == "DATUM" || layer == "OPEN") return 1;
    return 8;
}

std::vector<DxfLayer> layers_of(const Sheet& sheet) {
    std::vector<DxfLayer> layers;
    const auto add = [&](const std::string& name, SheetPen pen) {
        if (std::ranges::find(layers, name, &DxfLayer::name) == layers.end())
            layers.push_back({name, color_of(name), line_of(pen)});
    };
    for (const SheetPath& path : sheet.paths) add(path.layer, path.pen);
    for (const SheetCircle& circle : sheet.circles) add(circle.layer, circle.pen);
    for (const SheetText& text : sheet.texts) add(text.layer, SheetPen::thin);
    if (!sheet.dimensions.empty()) add(dimension_layer_name, SheetPen::thin);
    return layers;
}

class DxfSheet {
 public:
    explicit DxfSheet(const Sheet& sheet) : sheet_(sheet), drawing_(layers_of(sheet)) {
        drawing_.set_dimension_scale(1.0 / sheet.view.scale);
        for (const SheetPath& path : sheet.paths) draw(path);
        for (const SheetCircle& circle : sheet.circles)
            drawing_.circle(circle.layer, in_model(circle.center, circle.space),
                            circle.radius / (circle.space == SheetSpace::paper ? sheet.view.scale : 1.0));
        for (const SheetText& text : sheet.texts) drawing_.text(text.layer, text_of(text));
        for (const SheetDimension& dimension : sheet.dimensions) draw(dimension);
    }
    [[nodiscard]] std::string finish() const { return drawing_.finish(); }

 private:
    const Sheet& sheet_;
    DxfDrawing drawing_;

    [[nodiscard]] Vector2d in_model(const Vector2d& point, SheetSpace space) const {
        return space == SheetSpace::model ? point : sheet_.view.in_model(point);
    }
    [[nodiscard]] DxfText text_of(const SheetText& text) const {
        const auto anchor = text.anchor == TextAnchor::start    ? DxfText::Anchor::start
                            : text.anchor == TextAnchor::middle ? DxfText::Anchor::middle
                                                                : DxfText::Anchor::end;
        return {sheet_.view.in_model(text.at), text.height / sheet_.view.scale, text.words, anchor,
                text.turn};
    }
    void draw(const SheetPath& path) {
        std::vector<ArcVertex> vertices = path.vertices;
        for (ArcVertex& vertex : vertices) vertex.position = in_model(vertex.position, path.space);
        if (path.filled && vertices.size() == 3)
            return drawing_.triangle(path.layer,
                                     {vertices[0].position, vertices[1].position, vertices[2].position});
        if (vertices.size() == 2 && vertices[0].bulge == 0.0)
            return drawing_.line(path.layer, vertices[0].position, vertices[1].position);
        drawing_.polyline(path.layer, vertices, path.closed);
    }
    void draw(const SheetDimension& dimension) {
        using Kind = SheetDimension::Kind;
        const DimensionMarks marks = dimension_marks(dimension, sheet_.view);
        DxfDimension entity;
        entity.measured = dimension.measured();
        entity.text = text_of(marks.text);
        entity.across = dimension.across;
        entity.tolerance = printable(dimension.tolerance);
        entity.first = dimension.first;
        entity.second = dimension.second;
        entity.line = sheet_.view.in_model(dimension.place);
        switch (dimension.kind) {
            case Kind::linear: {
                entity.direction = dimension.direction;
                // The line passes at the second point's foot.
                const Vector2d along(std::cos(dimension.direction), std::sin(dimension.direction)),
                    across(-along.y(), along.x());
                entity.line = dimension.second + across * across.dot(entity.line - dimension.second);
                break;
            }
            case Kind::diameter:
                entity.kind = DxfDimension::Kind::diameter;
                break;
            case Kind::radius:
                entity.kind = DxfDimension::Kind::radius;
                break;
            case Kind::angle: {
                entity.kind = DxfDimension::Kind::angle;
                entity.vertex = dimension.first;
                const double radius = (entity.line - dimension.first).norm();
                const auto at = [&](double angle) -> Vector2d {
                    return dimension.first + radius * Vector2d(std::cos(angle), std::sin(angle));
                };
                // Counterclockwise from the first to the second.
                entity.first = at(dimension.direction + std::min(dimension.sweep, 0.0));
                entity.second = at(dimension.direction + std::max(dimension.sweep, 0.0));
                entity.line = at(dimension.direction + 0.5 * dimension.sweep);
                break;
            }
        }
        drawing_.dimension(dimension_layer_name, entity, [&] {
            for (const SheetPath& line : marks.lines) draw(line);
            for (const auto& arrow : marks.arrows)
                drawing_.triangle(dimension_layer_name,
                                  {sheet_.view.in_model(arrow[0]), sheet_.view.in_model(arrow[1]),
                                   sheet_.view.in_model(arrow[2])});
            drawing_.text(dimension_layer_name, text_of(marks.text));
        });
    }
};

using units::degree, units::millimetre;

constexpr double capital_height = 0.729;  // of the font's size

std::string mm_text(double metres) {
    std::string text = fmt::format("{:.4f}", millimetres_shown.of(metres));
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

const char* class_of(SheetPen pen) {
    return word_of<SheetPen::chain>(pen, {"thick", "thin", "dashed", "chain"});
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
                : fmt::format(" transform=\"rotate({:.3f} {} {})\"", degrees_shown.of(-text.turn), x, y);
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

std::string sheet_dxf(const Sheet& sheet) {
    return DxfSheet(sheet).finish();
}

std::string sheet_svg(const Sheet& sheet) {
    SvgSheet painter(sheet);
    paint(sheet, painter);
    return painter.finish();
}

}  // namespace camopt
