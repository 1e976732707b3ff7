// SPDX-License-Identifier: MIT
// A drawing in DXF, ASCII, version AC1015 (AutoCAD 2000): the oldest with polylines whose arcs are exact.
//
// Takes m, writes mm ($INSUNITS 4). Coordinates carry every digit of a double. Points that are not finite
// throw InputError. What stands around the entities (tables, dictionaries, layouts) is what strict readers
// insist on, no more; see dxf_scaffold.cpp. Source: Autodesk, DXF Reference for AutoCAD 2000.
#pragma once

#include "output/drawing/arc_chain.hpp"

#include <Eigen/Core>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camopt {

/// How far axes are drawn beyond the largest radius: this times it.
inline constexpr double axis_overhang = 1.15;

enum class DxfLine { continuous, dashed, center };

/// color: AutoCAD colour index, 1 red, 3 green, 5 blue, 7 black or white, 8 grey.
struct DxfLayer {
    std::string name;
    int color = 7;
    DxfLine line = DxfLine::continuous;
};

class DxfDrawing {
 public:
    explicit DxfDrawing(std::vector<DxfLayer> layers) : layers_(std::move(layers)) {}

    /// A LWPOLYLINE: arcs by bulge. Closed: the last vertex's arc leads back to the first.
    void polyline(std::string_view layer, std::span<const ArcVertex> vertices, bool closed);
    void circle(std::string_view layer, const Eigen::Vector2d& center, double radius);
    void line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);

    [[nodiscard]] std::string finish() const;

 private:
    void begin_entity(const char* type, std::string_view layer, const char* subclass);
    void point(int code, const Eigen::Vector2d& place);
    void widen(const Eigen::Vector2d& place, double reach = 0.0);

    std::vector<DxfLayer> layers_;
    std::string entities_;
    int entity_count_ = 0;
    Eigen::Vector2d least_ = {0.0, 0.0}, most_ = {0.0, 0.0};  ///< mm
};

}  // namespace camopt
