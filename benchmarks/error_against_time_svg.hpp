// SPDX-License-Identifier: MIT
// The study as a picture: one panel a backend, relative error against seconds, both logarithmic.
//
// Colour and shape tell the design vector, size the number of segments; a filled mark is proved optimal, a
// hollow one is not. What failed, was skipped or has no value is counted under the panel's name.
#pragma once

#include "benchmarks/measurement.hpp"

#include <span>
#include <string>

namespace camopt::benchmarks {

[[nodiscard]] std::string error_against_time_svg(std::span<const Measurement> rows,
                                                 const std::string& machine);

}  // namespace camopt::benchmarks
