// SPDX-License-Identifier: MIT
// The passes once more, compiled with AVX2 and FMA; linear/kernel_types.hpp says what may be included here.
#define CAMOPT_KERNELS wide_kernels
#include "solvers/structured/newton/side_loops.hpp"

namespace camopt::structured::wide_kernels {

SideKernels side_kernels();
SideKernels side_kernels() {
    return kernels();
}

}  // namespace camopt::structured::wide_kernels
