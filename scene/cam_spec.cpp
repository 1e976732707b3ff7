// SPDX-License-Identifier: MIT
#include "scene/cam_spec.hpp"

namespace camopt {

const char* name_of(Rotation value) {
    return value == Rotation::counterclockwise ? "counterclockwise" : "clockwise";
}

const char* name_of(CamForm value) {
    if (value == CamForm::open) return "open";
    return value == CamForm::grooved ? "grooved" : "conjugate";
}

}  // namespace camopt
