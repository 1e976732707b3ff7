// SPDX-License-Identifier: MIT
#include "core/scene.hpp"

namespace camopt {

const char* name_of(MotionType value) {
    return value == MotionType::drd ? "DRD" : "RR";
}

const char* name_of(EndJerk value) {
    return value == EndJerk::free ? "free" : "zero";
}

const char* name_of(TieBreak value) {
    return value == TieBreak::none ? "none" : "rms_jerk";
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
