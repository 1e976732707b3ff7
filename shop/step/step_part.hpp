// SPDX-License-Identifier: MIT
// The part "step": what step_file.cpp asks of Open CASCADE. Text in, text out, so that the part needs nothing
// else of camopt. Internal.
#pragma once

#include "report/surface/bspline_surface.hpp"
#include "shop/step/step_solid.hpp"

namespace camopt {

/// Of FILE_NAME; ASCII.
struct StepHeader {
    std::string part, author = {}, organisation = {}, system = {};
};

struct StepSolid {
    std::string text;
    double volume = 0.0;  ///< m³
};

/// Each throws InputError where Open CASCADE refuses.
struct StepPart {
    std::string (*surfaces)(std::span<const BsplineSurface> surfaces, const StepHeader& header);
    StepSolid (*solid)(const Plate& plate, const StepHeader& header);
};

}  // namespace camopt
