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

/// Of one line, standing on its baseline. m, rad.
struct DxfText {
    Eigen::Vector2d at = {0.0, 0.0};
    double height = 2.5e-3;
    std::string words;  ///< UTF-8
    enum class Anchor { start, middle, end } anchor = Anchor::start;
    double turn = 0.0;  ///< counterclockwise
};

/// A dimension as CAD systems know it: they measure again what its points say. m, rad.
struct DxfDimension {
    enum class Kind { linear, diameter, radius, angle };
    Kind kind = Kind::linear;
    Eigen::Vector2d first = {0.0, 0.0}, second = {0.0, 0.0};  ///< linear: what is measured. diameter, radius:
                                                              ///< centre, and the point at the words' end.
                                                              ///< angle: a point on either ray
    Eigen::Vector2d vertex = {0.0, 0.0};                      ///< angle
    Eigen::Vector2d line = {0.0, 0.0};  ///< linear: a point of the dimension line. angle: one of its arc
    double direction = 0.0;             ///< linear: of the dimension line
    double measured = 0.0;              ///< m, rad: what a reader finds
    bool across = false;                ///< linear: of a diameter
    std::string tolerance = {};         ///< after the measure: "H7"
    DxfText text;                       ///< what stands there
};

class DxfDrawing {
 public:
    explicit DxfDrawing(std::vector<DxfLayer> layers) : layers_(std::move(layers)) {}

    /// A LWPOLYLINE: arcs by bulge. Closed: the last vertex's arc leads back to the first.
    void polyline(std::string_view layer, std::span<const ArcVertex> vertices, bool closed);
    void circle(std::string_view layer, const Eigen::Vector2d& center, double radius);
    void line(std::string_view layer, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void text(std::string_view layer, const DxfText& words);
    /// Filled.
    void triangle(std::string_view layer, const std::array<Eigen::Vector2d, 3>& corners);
    /// `draw_marks` draws with this drawing what the dimension looks like, its text too; that goes to its
    /// block.
    void dimension(std::string_view layer, const DxfDimension& dimension,
                   const std::function<void()>& draw_marks);
    /// Of all dimensions; scale: mm of the drawing in one of the paper.
    void set_dimension_scale(double scale) { dimension_scale_ = scale; }

    [[nodiscard]] std::string finish() const;

 private:
    /// Name, handle of the record and entities of a block.
    struct DxfPart {
        std::string name;
        int record = 0;
        std::string entities;
    };
    void begin_entity(const char* type, std::string_view layer, const char* subclass);
    void point(int code, const Eigen::Vector2d& place);
    void widen(const Eigen::Vector2d& place, double reach = 0.0);

    std::vector<DxfLayer> layers_;
    std::string entities_;
    int entity_count_ = 0;
    int owner_ = 0;  ///< block record of a dimension that is being drawn; 0: the model
    std::vector<DxfPart> blocks_;
    double dimension_scale_ = 1.0;
    Eigen::Vector2d least_ = {0.0, 0.0}, most_ = {0.0, 0.0};  ///< mm
};

// What a DXF file of version AC1015 holds around its entities, and the tags all of it is made of.
//
// A tag is a group code and a value, a line each. Every object has a handle, in hexadecimal, and names its
// owner (330). Only dxf_drawing.cpp uses this.

inline constexpr int dxf_model_space = 0x17;    ///< handle of the block record that owns the entities
inline constexpr int dxf_first_layer = 0x80;    ///< handles of the layers begin here
inline constexpr int dxf_first_entity = 0x100;  ///< handles of the entities begin here

void append_tag(std::string& text, int code, std::string_view value);
[[nodiscard]] std::string dxf_handle(int handle);
/// Reads back as the same double, and has a point or an exponent.
[[nodiscard]] std::string dxf_real(double value);

/// A block of entities that stands apart from the model: the picture of a dimension.
struct DxfBlock {
    std::string name;      ///< "*D1"
    int record = 0;        ///< handles: its block record, whose next two are the block's begin and end
    std::string entities;  ///< owned by the record
};

/// How dimensions look, mm of the drawing.
struct DxfDimensionStyle {
    double text_height = 2.5, arrow = 2.5, scale = 1.0;
};

/// What every line of text and every name is written in: other letters as \\U+XXXX.
[[nodiscard]] std::string dxf_text(std::string_view words);

inline constexpr const char* dxf_dimension_style = "CAMOPT";

struct DxfScaffold {
    std::span<const DxfLayer> layers;
    Eigen::Vector2d least, most;  ///< extent of the drawing, mm
    int next_handle = 0;          ///< none in use is as large
    std::span<const DxfBlock> blocks = {};
    const DxfDimensionStyle* dimensions = nullptr;  ///< none: the drawing has no dimensions
};

/// HEADER, CLASSES, TABLES, BLOCKS, and the head of ENTITIES.
[[nodiscard]] std::string dxf_before_entities(const DxfScaffold& scaffold);
/// The end of ENTITIES, OBJECTS, EOF.
[[nodiscard]] std::string dxf_after_entities();

}  // namespace camopt
