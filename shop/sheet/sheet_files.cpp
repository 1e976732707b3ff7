// SPDX-License-Identifier: MIT
#include "shop/sheet/sheet_files.hpp"

#include "report/view/shown_units.hpp"
#include "shop/dxf/dxf_drawing.hpp"
#include "shop/sheet/dimension_marks.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

std::string mm_text(double metres) {
    return svg_number(millimetres_shown.of(metres), 4);
}

/// As CSS.
std::string rules_of(SheetPen pen) {
    if (pen == SheetPen::filled) return "fill:#000";
    if (pen == SheetPen::words)
        return "fill:#000;paint-order:stroke;stroke:#fff;stroke-width:" + mm_text(words_halo);
    const PenLook look = look_of(pen);
    std::string dashes;
    for (const double length : look.dashes)
        dashes += (dashes.empty() ? ";stroke-dasharray:" : " ") + mm_text(length);
    return fmt::format("fill:none;stroke:#000;stroke-linejoin:round;stroke-width:{}{}", mm_text(look.width),
                       dashes);
}

DxfLine line_of(SheetPen pen) {
    if (pen == SheetPen::dashed) return DxfLine::dashed;
    return pen == SheetPen::chain ? DxfLine::center : DxfLine::continuous;
}

std::vector<DxfStyle> dxf_styles(const Drawing& drawing) {
    std::vector<DxfStyle> styles;
    styles.reserve(sheet_styles.size());
    for (const SheetStyle& style : sheet_styles)
        styles.push_back(
            {style.name, style.layer, style.color, line_of(style.pen), style.pen == SheetPen::filled});
    if (drawing.has("rim")) {  // the disk; what a roller touches is the groove's inner flank
        styles.front().layer = "INNER_FLANK";
        styles.front().color = SheetStyle{}.color;
    }
    return styles;
}

}  // namespace

std::string sheet_dxf(const Sheet& sheet) {
    const Drawing all = drawing_with_marks(sheet);
    const std::vector<DxfStyle> styles = dxf_styles(all);
    DxfDrawing dxf(layers_of(all, styles));
    dxf.set_dimension_scale(sheet.paper(1.0));
    dxf.draw(sheet.drawing, styles);
    for (const DrawnDimension& dimension : sheet.dimensions) {
        const Drawing marks = dimension_marks(dimension, sheet.paper(1.0));
        dxf.dimension("DIMENSIONS", dimension, std::get<DrawnText>(marks.elements.back()).at,
                      [&] { dxf.draw(marks, styles); });
    }
    return dxf.finish();
}

std::string sheet_svg(const Sheet& sheet) {
    std::array<std::string, sheet_styles.size()> rules;
    std::vector<PictureStyle> styles;
    for (const SheetStyle& style : sheet_styles) {
        std::string& css = rules[styles.size()] = rules_of(style.pen);
        styles.push_back({style.name, css.c_str()});
    }
    const double width = millimetres_shown.of(sheet.width), height = millimetres_shown.of(sheet.height);
    SvgCanvas canvas = SvgCanvas::on_paper(
        width, height,
        css_of(styles) + fmt::format(".page{{fill:#fff}}text{{font-family:{}}}.middle{{text-anchor:middle}}."
                                     "end{{text-anchor:end}}",
                                     picture_fonts),
        sheet.title);
    canvas.rectangle(0.0, 0.0, width, height, "page");
    draw(canvas, drawing_with_marks(sheet), sheet.place(millimetres_shown.of(1.0)), styles);
    return canvas.finish();
}

}  // namespace camopt
