// SPDX-License-Identifier: MIT
#include "scene/cam_spec.hpp"

namespace camopt {

const char* name_of(Rotation value) {
    return value == Rotation::counterclockwise ? "counterclockwise" : "clockwise";
}

}  // namespace camopt
