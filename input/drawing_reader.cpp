// SPDX-License-Identifier: MIT
#include "input/drawing_reader.hpp"

namespace camopt::input {
namespace {

std::optional<Keyway> read_keyway(const SceneSource& source) {
    constexpr std::string_view table = "drawing.keyway";
    if (!source.table(table)) return std::nullopt;
    Keyway keyway;
    source.read_number(table, "width", keyway.width);
    source.read_number(table, "depth", keyway.depth);
    source.read_number(table, "at", keyway.at);
    return keyway;
}

}  // namespace

std::optional<DrawingSpec> read_drawing(const SceneSource& source) {
    if (!source.table("drawing")) return std::nullopt;
    DrawingSpec drawing;
    drawing.bore = source.number("drawing", "bore");
    drawing.keyway = read_keyway(source);
    drawing.thickness = source.number("drawing", "thickness");
    drawing.groove_depth = source.number("drawing", "groove_depth");
    source.read_number("drawing", "datum", drawing.datum);
    const auto words = [&](std::string_view name, std::string& target) {
        if (const auto given = source.find("drawing.title_block", name)) target = given->value().text;
    };
    words("part", drawing.title_block.part);
    words("material", drawing.title_block.material);
    words("tolerance", drawing.title_block.tolerance);
    words("drawn_by", drawing.title_block.drawn_by);
    return drawing;
}

}  // namespace camopt::input
