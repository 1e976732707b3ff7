// SPDX-License-Identifier: MIT
// What the figures were measured on.
#pragma once

#include <string>

namespace camopt::benchmarks {

/// "Intel …, 2 cores"
[[nodiscard]] std::string machine_line();

/// Processor, cores, load, compiler, libraries, date: one line each.
[[nodiscard]] std::string machine_text();

}  // namespace camopt::benchmarks
