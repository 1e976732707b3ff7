// SPDX-License-Identifier: MIT
// The rows of the [drawing] table.
#include "input/keys/key_spellings.hpp"

namespace camopt::input {
namespace {

using enum KeyType;
using namespace spellings;

}  // namespace

// A row is read as a row.
// clang-format off
std::vector<KeyRow> drawing_rows() {
    return {
        {"drawing", "bore", number, length, positive, {}, "no hole",
         "Diameter of the bore; with its keyway inside the cam's least radius."},
        {"drawing", "keyway", table, plain, any, {}, "none", "A parallel keyway in the bore."},
        {"drawing", "thickness", number, length, positive, {}, "20 mm",
         "Thickness of the cam; `--thickness-mm` replaces it."},
        {"drawing", "groove_depth", number, length, positive, {}, "half the thickness",
         "How deep the groove of a `grooved` cam is, below the thickness."},
        {"drawing", "datum", number, angle, any, {}, "0",
         "Where the cam is marked: the ray that points along +y when the cam has turned by this cam angle. The "
         "drawing's table of radii counts from it, as the cam angle grows."},
        {"drawing", "title_block", table, plain, any, {}, "empty", "What the title block says beside the scene's title."},
        {"drawing.keyway", "width", number, length, positive, {}, "required", "Width of the keyway, below the bore's diameter."},
        {"drawing.keyway", "depth", number, length, positive, {}, "required",
         "How far its floor lies outside the bore's circle: the hub's depth t2 of a parallel key."},
        {"drawing.keyway", "at", number, angle, any, {}, "0",
         "Where its middle is: a cam angle, like `datum`."},
        {"drawing.title_block", "part", text, plain, any, {}, "the title", "Name of the part."},
        {"drawing.title_block", "material", text, plain, any, {}, "empty", "Material and treatment."},
        {"drawing.title_block", "tolerance", text, plain, any, {}, "empty", "General tolerances."},
        {"drawing.title_block", "drawn_by", text, plain, any, {}, "empty", "Who drew it."},
    };
}
// clang-format on

}  // namespace camopt::input
