// SPDX-License-Identifier: MIT
// The cam study as a picture: one panel a backend, relative error against seconds, both logarithmic.
//
// Colour and shape tell the scene, size the number of segments; a filled mark is proved optimal, a hollow one
// is not. What was skipped or has no motion is counted under the panel's name.
#pragma once

#include "benchmarks/cam/cam_measurement.hpp"

#include <span>
#include <string>

namespace camopt::benchmarks {

[[nodiscard]] std::string cam_error_against_time_svg(std::span<const CamMeasurement> rows,
                                                     const std::string& machine);

}  // namespace camopt::benchmarks
