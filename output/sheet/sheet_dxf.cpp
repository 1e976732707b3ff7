// SPDX-License-Identifier: MIT
#include "output/sheet/sheet_dxf.hpp"

#include "output/drawing/dxf_drawing.hpp"
#include "output/sheet/dimension_marks.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::string sheet_dxf(const Sheet& sheet) {
    return DxfSheet(sheet).finish();
}

}  // namespace camopt
