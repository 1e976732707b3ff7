// SPDX-License-Identifier: MIT
#include "output/sheet/sheet_painter.hpp"

#include "output/sheet/dimension_marks.hpp"

#include <array>
#include <cmath>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr double thick_line = 0.5e-3, thin_line = 0.25e-3;
constexpr std::array<double, 2> dashed_line = {3.0e-3, 1.0e-3};
constexpr std::array<double, 4> chain_line = {6.0e-3, 1.0e-3, 1.0e-3, 1.0e-3};

}  // namespace

PenLook look_of(SheetPen pen) {
    switch (pen) {
        case SheetPen::thick:
            return {thick_line, {}};
        case SheetPen::thin:
            return {thin_line, {}};
        case SheetPen::dashed:
            return {thin_line, dashed_line};
        case SheetPen::chain:
            break;
    }
    return {thin_line, chain_line};
}

void paint(const Sheet& sheet, SheetPainter& painter) {
    for (SheetPath path : sheet.paths) {
        if (path.space == SheetSpace::model)
            for (ArcVertex& vertex : path.vertices) vertex.position = sheet.view.on_paper(vertex.position);
        path.space = SheetSpace::paper;
        painter.path(path);
    }
    for (SheetCircle circle : sheet.circles) {
        if (circle.space == SheetSpace::model) {
            circle.center = sheet.view.on_paper(circle.center);
            circle.radius *= sheet.view.scale;
        }
        circle.space = SheetSpace::paper;
        painter.circle(circle);
    }
    std::vector<SheetText> words;
    for (const SheetDimension& dimension : sheet.dimensions) {
        const DimensionMarks marks = dimension_marks(dimension, sheet.view);
        for (const SheetPath& line : marks.lines) painter.path(line);
        for (const std::array<Vector2d, 3>& arrow : marks.arrows)
            painter.path({marks.text.layer,
                          SheetPen::thin,
                          {{arrow[0], 0.0}, {arrow[1], 0.0}, {arrow[2], 0.0}},
                          true,
                          SheetSpace::paper,
                          true});
        words.push_back(marks.text);
    }
    for (const SheetText& text : words) painter.text(text);
    for (const SheetText& text : sheet.texts) painter.text(text);
}

BulgeArc bulge_arc(const Vector2d& from, const Vector2d& to, double bulge) {
    const Vector2d chord = to - from, left(-chord.y(), chord.x());
    const Vector2d center = 0.5 * (from + to) + (1.0 - bulge * bulge) / (4.0 * bulge) * left;
    const Vector2d out = from - center;
    const double begin = std::atan2(out.y(), out.x());
    return {center, out.norm(), begin, begin + 4.0 * std::atan(bulge)};
}

}  // namespace camopt
