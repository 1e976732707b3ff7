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
    for (const DrawnText& text : sheet.texts) add(text.style, SheetPen::thin);
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
        for (const DrawnText& text : sheet.texts) drawing_.text(text.style, text_of(text));
        for (const DrawnDimension& dimension : sheet.dimensions) draw(dimension);
    }
    [[nodiscard]] std::string finish() const { return drawing_.finish(); }

 private:
    const Sheet& sheet_;
    DxfDrawing drawing_;

    [[nodiscard]] Vector2d in_model(const Vector2d& point, SheetSpace space) const {
        return space == SheetSpace::model ? point : sheet_.view.in_model(point);
    }
    [[nodiscard]] DrawnText text_of(const DrawnText& text) const {
        return {text.style,
                sheet_.view.in_model(text.at),
                text.height / sheet_.view.scale,
                text.words,
                text.anchor,
                text.turn};
    }
    void draw(const SheetPath& path) {
        std::vector<ArcVertex> vertices = path.vertices;
        for (ArcVertex& vertex : vertices) vertex.position = in_model(vertex.position, path.space);
        if (path.filled && vertices.size() == 3)
            return drawing_.triangle(path.layer,
                                     {vertices[0].position, vertices[1].position, vertices[2].position});
        drawing_.path(path.layer, vertices, path.closed);
    }
    void draw(DrawnDimension dimension) {
        const DimensionMarks marks = dimension_marks(dimension, sheet_.view);
        const DrawnText words = text_of(marks.text);
        dimension.place = sheet_.view.in_model(dimension.place);
        drawing_.dimension(dimension_layer_name, dimension, words.at, [&] {
            for (const SheetPath& line : marks.lines) draw(line);
            for (const auto& arrow : marks.arrows)
                drawing_.triangle(dimension_layer_name,
                                  {sheet_.view.in_model(arrow[0]), sheet_.view.in_model(arrow[1]),
                                   sheet_.view.in_model(arrow[2])});
            drawing_.text(dimension_layer_name, words);
        });
    }
};

using units::degree, units::millimetre;

constexpr double capital_height = 0.729;  // of the font's size

std::string mm_text(double metres) {
    return svg_number(millimetres_shown.of(metres), 4);
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
        const PicturePlace place = {
            {0.0, millimetres_shown.of(height_)}, Vector2d::Constant(millimetres_shown.of(1.0)), 4};
        text_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", path.filled ? "filled" : class_of(path.pen),
                             svg_path(path.vertices, path.closed, place));
    }
    void circle(const SheetCircle& circle) override {
        text_ += fmt::format("<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", class_of(circle.pen),
                             mm_text(circle.center.x()), mm_text(height_ - circle.center.y()),
                             mm_text(circle.radius));
    }
    void text(const DrawnText& text) override {
        const std::string x = mm_text(text.at.x()), y = mm_text(height_ - text.at.y());
        const char* const anchor = text.anchor == TextSide::start    ? "start"
                                   : text.anchor == TextSide::middle ? "middle"
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
