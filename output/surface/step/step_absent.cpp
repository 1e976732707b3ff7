// SPDX-License-Identifier: MIT
// Stands in for step_opencascade.cpp in a build without Open CASCADE.
#include "core/errors.hpp"
#include "output/surface/step/step_file.hpp"
#include "output/surface/step/step_solid.hpp"

namespace camopt {

namespace {

[[noreturn]] void refuse() {
    throw UnavailableError(
        "STEP files need Open CASCADE, which this build of camopt does not have: install "
        "libocct-data-exchange-dev and configure again");
}

}  // namespace

bool step_available() {
    return false;
}

void write_step_file(const std::filesystem::path& /*path*/, std::span<const BsplineSurface> /*surfaces*/,
                     const std::string& /*part*/) {
    refuse();
}

double write_step_solid(const std::filesystem::path& /*path*/, const Plate& /*plate*/) {
    refuse();
}

}  // namespace camopt
