// SPDX-License-Identifier: MIT
// Internal to the solvers: the inner loops of linear/, compiled for every machine and, on x86-64, once more
// for those with AVX2 and FMA. The set is chosen once, when the first loop is requested. The loops themselves
// are in linear/kernel_loops.hpp, in a namespace per set; their tables and data in linear/kernel_types.hpp.
#pragma once

#include "linear/kernel_types.hpp"

namespace camopt {

enum class KernelSet {
    baseline,  ///< of the architecture
    wide       ///< AVX2 and FMA
};

/// Whether this build has the wide set and the machine can execute it.
[[nodiscard]] bool has_wide_kernels();
/// The best one that there is, until use_kernels.
[[nodiscard]] KernelSet kernel_set();
/// For comparisons of the two: affects what is constructed afterwards. The wide set only where there is one.
void use_kernels(KernelSet set);

[[nodiscard]] const LinearKernels& linear_kernels();

}  // namespace camopt
