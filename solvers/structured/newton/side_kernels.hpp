// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the passes over the sides of the ranges (side_passes.hpp) in the KernelSet
// that linear/kernels.hpp chose.
#pragma once

#include "solvers/structured/newton/side_passes.hpp"

namespace camopt::structured {

/// Of the set in use.
[[nodiscard]] const SideKernels& side_kernels();

}  // namespace camopt::structured
