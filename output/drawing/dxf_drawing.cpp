// SPDX-License-Identifier: MIT
#include "output/drawing/dxf_drawing.hpp"

#include "core/errors.hpp"
#include "core/units.hpp"
#include "output/drawing/dxf_scaffold.hpp"

#include <cmath>

namespace camopt {

void DxfDrawing::begin_entity(const char* type, std::string_view layer, const char* subclass) {
    append_tag(entities_, 0, type);
    append_tag(entities_, 5, dxf_handle(dxf_first_entity + entity_count_++));
    append_tag(entities_, 330, dxf_handle(dxf_model_space));
    append_tag(entities_, 100, "AcDbEntity");
    append_tag(entities_, 8, layer);
    append_tag(entities_, 100, subclass);
}

void DxfDrawing::point(int code, const Eigen::Vector2d& place) {
    append_tag(entities_, code, dxf_real(place.x() / units::millimetre));
    append_tag(entities_, code + 10, dxf_real(place.y() / units::millimetre));
}

void DxfDrawing::widen(const Eigen::Vector2d& place, double reach) {
    if (!place.allFinite() || !std::isfinite(reach))
        throw InputError("a DXF drawing takes finite points only, and one is not");
    const Eigen::Vector2d middle = place / units::millimetre;
    const Eigen::Vector2d size = Eigen::Vector2d::Constant(reach / units::millimetre);
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
    append_tag(entities_, 40, dxf_real(radius / units::millimetre));
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

std::string DxfDrawing::finish() const {
    return dxf_before_entities({layers_, least_, most_, dxf_first_entity + entity_count_}) + entities_ +
           dxf_after_entities();
}

}  // namespace camopt
