// SPDX-License-Identifier: MIT
// Internal to the solvers: what the inner loops of linear/ (kernel_loops.hpp) work on, and the table of loops
// that one set of instructions provides (kernels.hpp chooses between the tables).
//
// Only plain structures and pointers: an inline function with external linkage that two sets contain (a
// member of std::vector, of Eigen, std::min) would be linked once, perhaps with instructions that the machine
// does not have.
#pragma once

namespace camopt {

/// A banded matrix with a dense border; column j is [ pivot | band entries below it | border entries ].
/// Columns past the last one receive updates outside the band, which are zeros.
struct ChainMatrix {
    int band = 0, border = 0, count = 0;  ///< widths; columns
    int border_rows = 0;                  ///< <= border
    double* columns = nullptr;            ///< 1 + band + border entries each
    double* corner = nullptr;             ///< border x border, row by row, lower triangle
    const char* opens_pair = nullptr;     ///< of every column: a 2 x 2 pivot with the next one
    const double* signs = nullptr;        ///< of every pivot, those of the border last
    const double* diagonal = nullptr;     ///< magnitudes of the original diagonal entries
    /// D⁻¹ is tridiagonal: x_j = inverse[0] y_j + inverse[1] y_{j+1} + inverse[2] y_{j−1}, three per column.
    double* inverse = nullptr;
};

/// Wider chains are not worth it: see chain_order.
inline constexpr int most_chain_stride = 80;

enum class ChainOutcome { ok, zero_pivot, wrong_sign, not_finite };

/// A pivot of the wrong sign is round-off: it is recorded, and replaced by the smallest value admissible for
/// its diagonal entry.
struct ChainLoops {
    ChainOutcome (*eliminate)(const ChainMatrix& matrix);
    /// x −= L y in place, column by column; bottom: the border's part of x.
    void (*forward)(const ChainMatrix& matrix, double* x, double* bottom);
    /// x = D⁻¹ y − Lᵀ x from the last column to the first. x has `band` zeros after the last column.
    void (*backward)(const ChainMatrix& matrix, double* x, const double* bottom);
};

/// Rows of a sparse matrix, grouped by length.
struct RowGroups {
    struct Group {
        int length = 0, first = 0, last = 0;  ///< entries a row; rows [first, last) of the new order
        int entry = 0;                        ///< of the first row
    };
    const Group* groups = nullptr;
    int count = 0;
    const int* row = nullptr;  ///< of the matrix, in the new order
    const int* column = nullptr;
    const double* value = nullptr;
};

struct LinearKernels {
    ChainLoops (*chain)(int band, int border);
    /// out = A x
    void (*multiply)(const RowGroups& rows, const double* x, double* out);
    /// out = base + factor · A x; `base` may be `out`.
    void (*add_product)(const RowGroups& rows, double factor, const double* x, const double* base,
                        double* out);
};

}  // namespace camopt
