// SPDX-License-Identifier: MIT
#include "studies/sweep/sweep_row.hpp"

namespace camopt {

const char* name_of(SweepFigure value) {
    switch (value) {
        case SweepFigure::velocity:
            return "velocity";
        case SweepFigure::acceleration:
            return "acceleration";
        case SweepFigure::jerk:
            return "jerk";
        case SweepFigure::torque:
            return "torque";
        case SweepFigure::rms_acceleration:
            return "rms_acceleration";
        case SweepFigure::rms_jerk:
            return "rms_jerk";
    }
    return "unknown";
}

}  // namespace camopt
