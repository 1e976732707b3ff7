// SPDX-License-Identifier: MIT
// The study's rows as CSV: one line a combination, those that failed or were skipped included. Empty cells:
// no value.
#pragma once

#include "benchmarks/parts/measurement.hpp"

#include <span>
#include <string>

namespace camopt::benchmarks {

[[nodiscard]] std::string measurements_csv(std::span<const Measurement> rows);

}  // namespace camopt::benchmarks
