// SPDX-License-Identifier: MIT
// A drawing in DXF, ASCII, version AC1015 (AutoCAD 2000): the oldest with polylines whose arcs are exact.
//
// Takes m, writes mm ($INSUNITS 4). Coordinates carry every digit of a double. Points that are not finite
// throw InputError. What stands around the entities (tables, dictionaries, layouts) is what strict readers
// insist on, no more; see dxf_drawing.cpp. Source: Autodesk, DXF Reference for AutoCAD 2000.
#pragma once

#include "shop/dxf/arc_chain.hpp"

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

/// What a style of a drawing is in a DXF file.
struct DxfStyle {
    const char* style = "";
    const char* layer = "";
    int color = 7;
    DxfLine line = DxfLine::continuous;
    bool filled = false;  ///< of triangles
};
/// That the drawing's elements use.
[[nodiscard]] std::vector<DxfLayer> layers_of(const Drawing& drawing, std::span<const DxfStyle> styles);
/// The drawing's elements of these styles, in their order.
[[nodiscard]] std::string dxf_of(const Drawing& drawing, std::span<const DxfStyle> styles);

/// A block of entities that stands apart from the model: the picture of a dimension.
struct DxfBlock {
    std::string name;      ///< "*D1"
    int record = 0;        ///< handles: its block record, whose next two are the block's begin and end
    std::string entities;  ///< owned by the record
};

class DxfDrawing {
 public:
    explicit DxfDrawing(std::vector<DxfLayer> layers) : layers_(std::move(layers)) {}

    /// Its elements of these styles, in their order.
    void draw(const Drawing& drawing, std::span<const DxfStyle> styles);
    /// As CAD systems know it: they measure again what its points say; its place is in the drawing.
    /// `draw_marks` draws with this drawing what it looks like, its text too; that goes to its block.
    void dimension(std::string_view layer, const DrawnDimension& dimension, const Eigen::Vector2d& text,
                   const std::function<void()>& draw_marks);
    /// Of all dimensions; scale: mm of the drawing in one of the paper.
    void set_dimension_scale(double scale) { dimension_scale_ = scale; }

    [[nodiscard]] std::string finish() const;

 private:
    /// A LWPOLYLINE: arcs by bulge. Closed: the last vertex's arc leads back to the first.
    void polyline(std::string_view layer, std::span<const ArcVertex> vertices, bool closed);
    void circle(std::string_view layer, const Eigen::Vector2d& center, double radius);
    void line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void text(std::string_view layer, const DrawnText& words);
    /// Filled.
    void triangle(std::string_view layer, const std::array<Eigen::Vector2d, 3>& corners);
    void begin_entity(const char* type, std::string_view layer, const char* subclass);
    void point(int code, const Eigen::Vector2d& place);
    void widen(const Eigen::Vector2d& place, double reach = 0.0);

    std::vector<DxfLayer> layers_;
    std::string entities_;
    int entity_count_ = 0;
    int owner_ = 0;  ///< block record of a dimension that is being drawn; 0: the model
    std::vector<DxfBlock> blocks_;
    double dimension_scale_ = 1.0;
    Eigen::Vector2d least_ = {0.0, 0.0}, most_ = {0.0, 0.0};  ///< mm
};

/// What every line of text and every name is written in: other letters as \\U+XXXX.
[[nodiscard]] std::string dxf_text(std::string_view words);

}  // namespace camopt
