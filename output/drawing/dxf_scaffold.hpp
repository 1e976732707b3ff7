// SPDX-License-Identifier: MIT
// What a DXF file of version AC1015 holds around its entities, and the tags all of it is made of.
//
// A tag is a group code and a value, a line each. Every object has a handle, in hexadecimal, and names its
// owner (330). Only dxf_drawing.cpp uses this.
#pragma once

#include "output/drawing/dxf_drawing.hpp"

#include <Eigen/Core>

#include <span>
#include <string>
#include <string_view>

namespace camopt {

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
