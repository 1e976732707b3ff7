// SPDX-License-Identifier: MIT
// The rows of the cam study as CSV: one line a scene and backend, failures and skipped ones included. Empty
// cells: no value.
#pragma once

#include "benchmarks/cam/cam_measurement.hpp"

#include <span>
#include <string>

namespace camopt::benchmarks {

[[nodiscard]] std::string cam_measurements_csv(std::span<const CamMeasurement> rows);

}  // namespace camopt::benchmarks
