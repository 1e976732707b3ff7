// SPDX-License-Identifier: MIT
// Internal to linear/: the inner loops of the chain factor, compiled for each usual width of band and border,
// so that they are unrolled and vectorized.
//
// A column of the chain is [ pivot | band entries below it | border entries ].
#pragma once

namespace camopt {

struct ChainWidths {
    int band = 0, border = 0;
    [[nodiscard]] int stride() const { return 1 + band + border; }
};

struct ChainKernels {
    /// K of the later columns −= factor · scaledᵀ for column `own`; border: rows of width `border_rows`.
    void (*subtract)(double* own, const double* factor, const double* scaled, double* border,
                     const ChainWidths& widths);
    /// x −= L y in place, column by column; bottom: the border's part of x.
    void (*forward)(const double* columns, int count, double* x, double* bottom, const ChainWidths& widths);
    /// x = y − Lᵀ x from the last column to the first.
    void (*backward)(const double* columns, int count, double* x, const double* bottom,
                     const ChainWidths& widths);
};

/// The smallest widths with fast kernels that are at least those given (missing entries are zeros), else
/// those given.
[[nodiscard]] ChainWidths padded(const ChainWidths& widths);

[[nodiscard]] ChainKernels chain_kernels(const ChainWidths& widths);

}  // namespace camopt
