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

struct DxfScaffold {
    std::span<const DxfLayer> layers;
    Eigen::Vector2d least, most;  ///< extent of the drawing, mm
    int next_handle = 0;          ///< none in use is as large
};

/// HEADER, CLASSES, TABLES, BLOCKS, and the head of ENTITIES.
[[nodiscard]] std::string dxf_before_entities(const DxfScaffold& scaffold);
/// The end of ENTITIES, OBJECTS, EOF.
[[nodiscard]] std::string dxf_after_entities();

}  // namespace camopt
