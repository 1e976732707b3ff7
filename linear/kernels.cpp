// SPDX-License-Identifier: MIT
#include "linear/kernels.hpp"

#include "core/errors.hpp"
#include "linear/kernel_loops.hpp"

#include <atomic>

namespace camopt {

#ifdef CAMOPT_WIDE_KERNELS
namespace wide_kernels {
LinearKernels linear_kernels();  // of kernels_wide.cpp
}  // namespace wide_kernels

bool has_wide_kernels() {
    return static_cast<bool>(__builtin_cpu_supports("avx2")) &&
           static_cast<bool>(__builtin_cpu_supports("fma"));
}
#else
bool has_wide_kernels() {
    return false;
}
#endif

namespace {

std::atomic<KernelSet>& chosen() {
    static std::atomic<KernelSet> set = has_wide_kernels() ? KernelSet::wide : KernelSet::baseline;
    return set;
}

}  // namespace

KernelSet kernel_set() {
    return chosen();
}

void use_kernels(KernelSet set) {
    if (set == KernelSet::wide && !has_wide_kernels())
        throw UnavailableError("this machine or this build has no AVX2 kernels");
    chosen() = set;
}

const LinearKernels& linear_kernels() {
    static const LinearKernels baseline = baseline_kernels::kernels();
#ifdef CAMOPT_WIDE_KERNELS
    if (kernel_set() == KernelSet::wide) {  // nothing of the wide set may run elsewhere
        static const LinearKernels wide = wide_kernels::linear_kernels();
        return wide;
    }
#endif
    return baseline;
}

}  // namespace camopt
