// SPDX-License-Identifier: MIT
// The loops once more, compiled with AVX2 and FMA; see kernel_types.hpp for what may not be included here.
#define CAMOPT_KERNELS wide_kernels
#include "linear/kernel_loops.hpp"

namespace camopt::wide_kernels {

LinearKernels linear_kernels();
LinearKernels linear_kernels() {
    return kernels();
}

}  // namespace camopt::wide_kernels
