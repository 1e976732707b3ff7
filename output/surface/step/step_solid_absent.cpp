// SPDX-License-Identifier: MIT
// Stands in for step_solid_opencascade.cpp in a build without Open CASCADE.
#include "core/errors.hpp"
#include "output/surface/step/step_solid.hpp"

namespace camopt {

double write_step_solid(const std::filesystem::path& /*path*/, const Plate& /*plate*/) {
    throw UnavailableError(
        "STEP files need Open CASCADE, which this build of camopt does not have: install "
        "libocct-data-exchange-dev and configure again");
}

}  // namespace camopt
