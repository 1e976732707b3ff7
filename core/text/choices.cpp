// SPDX-License-Identifier: MIT
#include "core/text/choices.hpp"

namespace camopt {

const char* name_of(MotionType value) {
    switch (value) {
        case MotionType::drd:
            return "DRD";
        case MotionType::rr:
            return "RR";
        case MotionType::program:
            break;
    }
    return "program";
}

const char* name_of(DesignKind value) {
    switch (value) {
        case DesignKind::ordinates:
            return "ordinates";
        case DesignKind::coefficients:
            return "coefficients";
        case DesignKind::states:
            return "states";
        case DesignKind::automatic:
            break;
    }
    return "auto";
}

}  // namespace camopt
