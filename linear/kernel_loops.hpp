// SPDX-License-Identifier: MIT
// Internal to linear/: the loops of one KernelSet, see kernel_types.hpp. Included by one source per set,
// which names the set's namespace in CAMOPT_KERNELS. Nothing here may call a function outside this namespace.
#pragma once

#include "linear/kernel_types.hpp"

#ifndef CAMOPT_KERNELS
#define CAMOPT_KERNELS baseline_kernels
#endif

namespace camopt::CAMOPT_KERNELS {

// A pivot smaller than this part of its diagonal entry is round-off.
constexpr double rounding = 1e-14;

/// False: not usable.
inline bool right_pivot(double& pivot, double original, double sign, ChainOutcome& outcome) {
    if (!__builtin_isfinite(pivot)) {
        outcome = ChainOutcome::not_finite;
        return false;
    }
    const double least = rounding * original;
    if (pivot * sign > least) return true;
    if (pivot * sign < 0.0) outcome = ChainOutcome::wrong_sign;
    const double size = __builtin_fabs(pivot);
    pivot = sign * (size > least ? size : least);
    if (pivot != 0.0) return true;
    outcome = ChainOutcome::zero_pivot;
    return false;
}

/// Loops over a chain of these widths; −1: known at run time only.
template <int Band, int Border>
struct Chain {
    static constexpr bool fixed = Band >= 0 && Border >= 0;
    static constexpr int most = fixed ? 1 + Band + Border : most_chain_stride;
    static constexpr int most_corner = fixed ? Border * Border + 1 : most_chain_stride * most_chain_stride;
    static int band(const ChainMatrix& matrix) { return Band < 0 ? matrix.band : Band; }
    static int border(const ChainMatrix& matrix) { return Border < 0 ? matrix.border : Border; }

    static ChainOutcome eliminate(const ChainMatrix& matrix) {
        const int b = band(matrix), u = border(matrix), stride = 1 + b + u;
        double corner[most_corner];  // a local copy stays in registers
        for (int k = 0; k < u * u; ++k) corner[k] = matrix.corner[k];
        ChainOutcome outcome = ChainOutcome::ok;
        double* own = matrix.columns;
        for (int j = 0; j < matrix.count; ++j, own += stride) {
            if (matrix.opens_pair[j] == 0) {
                if (!single(matrix, j, own, corner, outcome)) return outcome;
                continue;
            }
            if (!pair(matrix, j++, own, corner, outcome)) return outcome;
            own += stride;
        }
        for (int k = 0; k < u * u; ++k) matrix.corner[k] = corner[k];
        eliminate_border(matrix, outcome);
        return outcome;
    }

    static void eliminate_border(const ChainMatrix& matrix, ChainOutcome& outcome) {
        const int u = border(matrix), rows = matrix.border_rows;
        double* const corner = matrix.corner;
        for (int k = 0; k < rows; ++k) {
            double& pivot = corner[k * u + k];
            const int at = matrix.count + k;
            if (!right_pivot(pivot, matrix.diagonal[at], matrix.signs[at], outcome)) return;
            for (int i = k + 1; i < rows; ++i) {
                const double factor = corner[i * u + k] / pivot;
                for (int t = i; t < rows; ++t) corner[t * u + i] -= factor * corner[t * u + k];
            }
            for (int i = k + 1; i < rows; ++i) corner[i * u + k] /= pivot;
        }
    }

    static bool single(const ChainMatrix& matrix, int j, double* own, double* corner, ChainOutcome& outcome) {
        const int b = band(matrix), u = border(matrix), stride = 1 + b + u;
        double pivot = own[0];
        if (!right_pivot(pivot, matrix.diagonal[j], matrix.signs[j], outcome)) return false;
        const double inverse = 1.0 / pivot;
        double* const kept = matrix.inverse + 3L * j;
        kept[0] = inverse;
        kept[1] = kept[2] = 0.0;
        own[0] = pivot;
        double scaled[most], factor[most];
#pragma GCC unroll 24
        for (int k = 1; k < stride; ++k) {
            scaled[k] = own[k];
            factor[k] = scaled[k] * inverse;
            own[k] = factor[k];
        }
        double* column = own;
#pragma GCC unroll 16
        for (int s = 1; s <= b; ++s) {
            column += stride;
            const double f = factor[s];
#pragma GCC unroll 16
            for (int t = s; t <= b; ++t) column[t - s] -= f * scaled[t];
#pragma GCC unroll 16
            for (int t = 1 + b; t < stride; ++t) column[t] -= f * scaled[t];
        }
#pragma GCC unroll 4
        for (int s = 0; s < u; ++s) {
            const double f = factor[1 + b + s];
#pragma GCC unroll 4
            for (int t = 0; t < u; ++t) corner[s * u + t] -= f * scaled[1 + b + t];
        }
        return true;
    }

    /// Columns j and j + 1 together: [ p e; e −n ] with inverse [ n e; e −p ] / (p n + e²).
    static bool pair(const ChainMatrix& matrix, int j, double* first, double* corner, ChainOutcome& outcome) {
        const int b = band(matrix), u = border(matrix), stride = 1 + b + u;
        double* const second = first + stride;
        const double p = first[0] > 0.0 ? first[0] : 0.0, n = second[0] < 0.0 ? -second[0] : 0.0;
        const double e = first[1], determinant = p * n + e * e;
        const double inverse = 1.0 / determinant;
        if (!__builtin_isfinite(inverse) || inverse == 0.0 || first[0] != first[0] ||
            second[0] != second[0]) {
            outcome = determinant == 0.0 ? ChainOutcome::zero_pivot : ChainOutcome::not_finite;
            return false;
        }
        const double x = n * inverse, y = e * inverse, z = -p * inverse;
        double* const kept = matrix.inverse + 3L * j;
        kept[0] = x;
        kept[1] = kept[5] = y;
        kept[2] = kept[4] = 0.0;
        kept[3] = z;
        first[1] = 0.0;
        // Row j + k is at k in column j and at k − 1 in column j + 1: kept at k here.
        double a[most], c[most], of_first[most], of_second[most];
#pragma GCC unroll 24
        for (int k = 2; k < stride; ++k) {
            double* const other = second + (k <= b ? k - 1 : k);
            a[k] = first[k];
            c[k] = *other;
            of_first[k] = x * a[k] + y * c[k];
            of_second[k] = y * a[k] + z * c[k];
            first[k] = of_first[k];
            *other = of_second[k];
        }
        second[b] = 0.0;
        double* column = second;
#pragma GCC unroll 16
        for (int s = 2; s <= b; ++s) {
            column += stride;
            const double f = of_first[s], g = of_second[s];
#pragma GCC unroll 16
            for (int t = s; t <= b; ++t) column[t - s] -= f * a[t] + g * c[t];
#pragma GCC unroll 16
            for (int t = 1 + b; t < stride; ++t) column[t] -= f * a[t] + g * c[t];
        }
#pragma GCC unroll 4
        for (int s = 0; s < u; ++s) {
            const double f = of_first[1 + b + s], g = of_second[1 + b + s];
#pragma GCC unroll 4
            for (int t = 0; t < u; ++t) corner[s * u + t] -= f * a[1 + b + t] + g * c[1 + b + t];
        }
        return true;
    }

    // The entries of x within the band are kept in registers: through memory every step would wait for the
    // previous store.
    static void forward(const ChainMatrix& matrix, double* x, double* bottom) {
        const int b = band(matrix), u = border(matrix), stride = 1 + b + u;
        const double* own = matrix.columns;
        if constexpr (!fixed) {
            for (int j = 0; j < matrix.count; ++j, own += stride, ++x) {
                const double y = x[0];
                for (int k = 1; k <= b; ++k) x[k] -= own[k] * y;
                for (int k = 0; k < u; ++k) bottom[k] -= own[1 + b + k] * y;
            }
        } else {
            double window[Band], low[Border + 1];
            for (int k = 0; k < b; ++k) window[k] = x[k];
            for (int k = 0; k < u; ++k) low[k] = bottom[k];
            for (int j = 0; j < matrix.count; ++j, own += stride) {
                const double y = window[0];
                x[j] = y;
#pragma GCC unroll 16
                for (int k = 0; k + 1 < b; ++k) window[k] = window[k + 1] - own[k + 1] * y;
                window[b - 1] = x[j + b] - own[b] * y;
#pragma GCC unroll 16
                for (int k = 0; k < u; ++k) low[k] -= own[1 + b + k] * y;
            }
            for (int k = 0; k < u; ++k) bottom[k] = low[k];
        }
    }

    static void backward(const ChainMatrix& matrix, double* x, const double* bottom) {
        const int b = band(matrix), u = border(matrix), stride = 1 + b + u;
        const double* own = matrix.columns + static_cast<long>(matrix.count) * stride;
        const double* inverse = matrix.inverse + 3L * matrix.count;
        double window[fixed ? Band : 1] = {}, low[fixed ? Border + 1 : 1];
        for (int k = 0; fixed && k < u; ++k) low[k] = bottom[k];
        double next = 0.0;
        for (int j = matrix.count - 1; j >= 0; --j) {
            own -= stride;
            inverse -= 3;
            const double y = x[j];
            double value = inverse[0] * y + inverse[1] * next + inverse[2] * x[j - 1];
            next = y;
            if constexpr (fixed) {
#pragma GCC unroll 16
                for (int k = 0; k < u; ++k) value -= own[1 + b + k] * low[k];
#pragma GCC unroll 16
                for (int k = b - 1; k >= 0; --k) value -= own[k + 1] * window[k];  // the newest entry last
#pragma GCC unroll 16
                for (int k = b - 1; k >= 1; --k) window[k] = window[k - 1];
                window[0] = value;
            } else {
                for (int k = 0; k < u; ++k) value -= own[1 + b + k] * bottom[k];
                for (int k = b; k >= 1; --k) value -= own[k] * x[j + k];
            }
            x[j] = value;
        }
    }

    static ChainLoops loops() {
        return {&eliminate, &forward, &backward};
    }
};

template <int Band>
ChainLoops with_border(int border) {
    switch (border) {
        case 0:
            return Chain<Band, 0>::loops();
        case 4:
            return Chain<Band, 4>::loops();
        default:
            return Chain<-1, -1>::loops();
    }
}

inline ChainLoops chain(int band, int border) {
    switch (band) {
        case 4:
            return with_border<4>(border);
        case 6:
            return with_border<6>(border);
        case 8:
            return with_border<8>(border);
        case 10:
            return with_border<10>(border);
        case 12:
            return with_border<12>(border);
        default:
            return Chain<-1, -1>::loops();
    }
}

inline double long_sum(int count, const int* column, const double* value, const double* x) {
    double a = 0.0, b = 0.0, c = 0.0, d = 0.0;  // four independent sums
    int k = 0;
    for (; k + 4 <= count; k += 4) {
        a += value[k] * x[column[k]];
        b += value[k + 1] * x[column[k + 1]];
        c += value[k + 2] * x[column[k + 2]];
        d += value[k + 3] * x[column[k + 3]];
    }
    for (; k < count; ++k) a += value[k] * x[column[k]];
    return (a + b) + (c + d);
}

/// Rows of Length entries each; 0: length known at run time only.
template <int Length, typename Keep>
void each_row(const RowGroups& rows, const RowGroups::Group& group, const double* x, const Keep& keep) {
    const int* column = rows.column + group.entry;
    const double* value = rows.value + group.entry;
    for (int k = group.first; k < group.last; ++k, column += group.length, value += group.length) {
        if constexpr (Length == 0) {
            keep(rows.row[k], long_sum(group.length, column, value, x));
        } else {
            double sum = value[0] * x[column[0]];
#pragma GCC unroll 12
            for (int e = 1; e < Length; ++e) sum += value[e] * x[column[e]];
            keep(rows.row[k], sum);
        }
    }
}

/// keep(row, sum) for every row.
template <typename Keep>
void each_product(const RowGroups& rows, const double* x, const Keep& keep) {
    for (int g = 0; g < rows.count; ++g) {
        const RowGroups::Group& group = rows.groups[g];
        switch (group.length) {
            case 1:
                each_row<1>(rows, group, x, keep);
                break;
            case 2:
                each_row<2>(rows, group, x, keep);
                break;
            case 3:
                each_row<3>(rows, group, x, keep);
                break;
            case 4:
                each_row<4>(rows, group, x, keep);
                break;
            case 5:
                each_row<5>(rows, group, x, keep);
                break;
            case 6:
                each_row<6>(rows, group, x, keep);
                break;
            case 8:
                each_row<8>(rows, group, x, keep);
                break;
            case 10:
                each_row<10>(rows, group, x, keep);
                break;
            default:
                each_row<0>(rows, group, x, keep);
        }
    }
}

inline void multiply(const RowGroups& rows, const double* x, double* out) {
    each_product(rows, x, [out](int row, double sum) { out[row] = sum; });
}

inline void add_product(const RowGroups& rows, double factor, const double* x, const double* base,
                        double* out) {
    each_product(rows, x, [out, base, factor](int row, double sum) { out[row] = base[row] + factor * sum; });
}

inline LinearKernels kernels() {
    return {&chain, &multiply, &add_product};
}

}  // namespace camopt::CAMOPT_KERNELS
