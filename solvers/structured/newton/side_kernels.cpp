// SPDX-License-Identifier: MIT
#include "solvers/structured/newton/side_kernels.hpp"

#include "linear/kernels.hpp"
#include "solvers/structured/newton/side_loops.hpp"

namespace camopt::structured {

#ifdef CAMOPT_WIDE_KERNELS
namespace wide_kernels {
SideKernels side_kernels();  // of side_kernels_wide.cpp
}  // namespace wide_kernels
#endif

const SideKernels& side_kernels() {
    static const SideKernels baseline = baseline_kernels::kernels();
#ifdef CAMOPT_WIDE_KERNELS
    if (kernel_set() == KernelSet::wide) {  // nothing of the wide set may run elsewhere
        static const SideKernels wide = wide_kernels::side_kernels();
        return wide;
    }
#endif
    return baseline;
}

}  // namespace camopt::structured
