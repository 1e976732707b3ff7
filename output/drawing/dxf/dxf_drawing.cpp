// SPDX-License-Identifier: MIT
#include "output/drawing/dxf/dxf_drawing.hpp"

#include "core/errors.hpp"
#include "output/drawing/dxf/dxf_scaffold.hpp"
#include "output/view/shown_units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

void DxfDrawing::begin_entity(const char* type, std::string_view layer, const char* subclass) {
    append_tag(entities_, 0, type);
    append_tag(entities_, 5, dxf_handle(dxf_first_entity + entity_count_++));
    append_tag(entities_, 330, dxf_handle(owner_ == 0 ? dxf_model_space : owner_));
    append_tag(entities_, 100, "AcDbEntity");
    append_tag(entities_, 8, layer);
    append_tag(entities_, 100, subclass);
}

void DxfDrawing::point(int code, const Eigen::Vector2d& place) {
    append_tag(entities_, code, dxf_real(millimetres_shown.of(place.x())));
    append_tag(entities_, code + 10, dxf_real(millimetres_shown.of(place.y())));
}

void DxfDrawing::widen(const Eigen::Vector2d& place, double reach) {
    if (!place.allFinite() || !std::isfinite(reach))
        throw InputError("a DXF drawing takes finite points only, and one is not");
    const Eigen::Vector2d middle = place / millimetres_shown.size;
    const Eigen::Vector2d size = Eigen::Vector2d::Constant(millimetres_shown.of(reach));
    const bool first = entity_count_ == 0;
    least_ = first ? Eigen::Vector2d(middle - size) : Eigen::Vector2d(least_.cwiseMin(middle - size));
    most_ = first ? Eigen::Vector2d(middle + size) : Eigen::Vector2d(most_.cwiseMax(middle + size));
}

void DxfDrawing::polyline(std::string_view layer, std::span<const ArcVertex> vertices, bool closed) {
    for (const ArcVertex& vertex : vertices) widen(vertex.position);
    begin_entity("LWPOLYLINE", layer, "AcDbPolyline");
    append_tag(entities_, 90, std::to_string(vertices.size()));
    append_tag(entities_, 70, closed ? "1" : "0");
    append_tag(entities_, 43, dxf_real(0.0));
    for (const ArcVertex& vertex : vertices) {
        point(10, vertex.position);
        append_tag(entities_, 42, dxf_real(vertex.bulge));
    }
}

void DxfDrawing::circle(std::string_view layer, const Eigen::Vector2d& center, double radius) {
    widen(center, radius);
    begin_entity("CIRCLE", layer, "AcDbCircle");
    point(10, center);
    append_tag(entities_, 30, dxf_real(0.0));
    append_tag(entities_, 40, dxf_real(millimetres_shown.of(radius)));
}

void DxfDrawing::line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    widen(from);
    widen(to);
    begin_entity("LINE", layer, "AcDbLine");
    point(10, from);
    append_tag(entities_, 30, dxf_real(0.0));
    point(11, to);
    append_tag(entities_, 31, dxf_real(0.0));
}

void DxfDrawing::text(std::string_view layer, const DxfText& words) {
    widen(words.at);
    begin_entity("TEXT", layer, "AcDbText");
    point(10, words.at);
    append_tag(entities_, 30, dxf_real(0.0));
    append_tag(entities_, 40, dxf_real(millimetres_shown.of(words.height)));
    append_tag(entities_, 1, dxf_text(words.words));
    append_tag(entities_, 50, dxf_real(degrees_shown.of(words.turn)));
    if (words.anchor != DxfText::Anchor::start) {
        append_tag(entities_, 72, words.anchor == DxfText::Anchor::middle ? "1" : "2");
        point(11, words.at);
        append_tag(entities_, 31, dxf_real(0.0));
    }
    append_tag(entities_, 100, "AcDbText");
}

void DxfDrawing::triangle(std::string_view layer, const std::array<Eigen::Vector2d, 3>& corners) {
    for (const Eigen::Vector2d& corner : corners) widen(corner);
    begin_entity("SOLID", layer, "AcDbTrace");
    for (int i = 0; i < 4; ++i) {
        point(10 + i, corners[static_cast<std::size_t>(std::min(i, 2))]);
        append_tag(entities_, 30 + i, dxf_real(0.0));
    }
}

void DxfDrawing::dimension(std::string_view layer, const DxfDimension& dimension,
                           const std::function<void()>& draw_marks) {
    using Kind = DxfDimension::Kind;
    DxfPart block;
    block.name = fmt::format("*D{}", blocks_.size() + 1);
    block.record = dxf_first_entity + entity_count_;
    entity_count_ += 3;
    std::swap(entities_, block.entities);
    owner_ = block.record;
    draw_marks();
    owner_ = 0;
    std::swap(entities_, block.entities);

    const auto place = [&](int code, const Eigen::Vector2d& at) {
        point(code, at);
        append_tag(entities_, code + 20, dxf_real(0.0));
    };
    begin_entity("DIMENSION", layer, "AcDbDimension");
    append_tag(entities_, 2, block.name);
    const Eigen::Vector2d opposite = 2.0 * dimension.first - dimension.second;
    place(10, dimension.kind == Kind::diameter ? opposite
              : dimension.kind == Kind::radius ? dimension.first
                                               : dimension.line);
    place(11, dimension.text.at);
    constexpr int own_block = 32,
                  own_place = 128;  // no other dimension has the block; words stand where we put them
    const int kind = dimension.kind == Kind::linear     ? 0
                     : dimension.kind == Kind::diameter ? 3
                     : dimension.kind == Kind::radius   ? 4
                                                        : 5;
    append_tag(entities_, 70, std::to_string(kind + own_block + own_place));
    append_tag(entities_, 71, "8");  // their foot's middle
    const bool angle = dimension.kind == Kind::angle;
    append_tag(entities_, 42,
               dxf_real(angle ? dimension.measured : millimetres_shown.of(dimension.measured)));
    const std::string tolerance = dimension.tolerance.empty() ? "" : " " + dxf_text(dimension.tolerance);
    append_tag(entities_, 1, (dimension.across ? "%%c<>" : "<>") + tolerance);
    append_tag(entities_, 3, dxf_dimension_style);
    switch (dimension.kind) {
        case Kind::linear:
            append_tag(entities_, 100, "AcDbAlignedDimension");
            place(13, dimension.first);
            place(14, dimension.second);
            append_tag(entities_, 50, dxf_real(degrees_shown.of(dimension.direction)));
            append_tag(entities_, 100, "AcDbRotatedDimension");
            break;
        case Kind::diameter:
        case Kind::radius:
            append_tag(entities_, 100,
                       dimension.kind == Kind::radius ? "AcDbRadialDimension" : "AcDbDiametricDimension");
            place(15, dimension.second);
            append_tag(entities_, 40, dxf_real(0.0));
            break;
        case Kind::angle:
            append_tag(entities_, 100, "AcDb3PointAngularDimension");
            place(13, dimension.first);
            place(14, dimension.second);
            place(15, dimension.vertex);
            break;
    }
    blocks_.push_back(std::move(block));
}

std::string DxfDrawing::finish() const {
    std::vector<DxfBlock> blocks;
    for (const DxfPart& part : blocks_) blocks.push_back({part.name, part.record, part.entities});
    DxfDimensionStyle style;
    style.scale = dimension_scale_;
    return dxf_before_entities({layers_, least_, most_, dxf_first_entity + entity_count_, blocks,
                                blocks.empty() ? nullptr : &style}) +
           entities_ + dxf_after_entities();
}

}  // namespace camopt
