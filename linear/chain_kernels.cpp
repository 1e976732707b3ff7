// SPDX-License-Identifier: MIT
#include "linear/chain_factor.hpp"

#include <array>
#include <cstddef>

namespace camopt {
namespace {

/// Band or Border −1: widths known at run time only.
template <int Band, int Border>
struct Loops {
    static int band(const ChainWidths& widths) { return Band < 0 ? widths.band : Band; }
    static int border(const ChainWidths& widths) { return Border < 0 ? widths.border : Border; }

    static void subtract(double* own, const double* factor, const double* scaled, double* corner,
                         const ChainWidths& widths) {
        const int b = band(widths), u = border(widths), stride = 1 + b + u;
        const double* const scaled_border = scaled + 1 + b;
        double* column = own;
#pragma GCC unroll 16
        for (int s = 1; s <= b; ++s) {
            column += stride;
            const double f = factor[s];
            if (f == 0.0) continue;
#pragma GCC unroll 16
            for (int t = s; t <= b; ++t) column[t - s] -= f * scaled[t];
            double* const below = column + 1 + b;
#pragma GCC unroll 16
            for (int t = 0; t < u; ++t) below[t] -= f * scaled_border[t];
        }
        const double* const factor_border = factor + 1 + b;
        for (int s = 0; s < u; ++s) {
            const double f = factor_border[s];
#pragma GCC unroll 16
            for (int t = 0; t < u; ++t) corner[s * u + t] -= f * scaled_border[t];
        }
    }

    // The entries of x within the band are kept in registers: through memory every step would wait for the
    // previous store.
    static void forward(const double* columns, int count, double* x, double* bottom,
                        const ChainWidths& widths) {
        if constexpr (Band < 0 || Border < 0) {
            forward_of_any_width(columns, count, x, bottom, widths);
        } else {
            constexpr int b = Band, u = Border, stride = 1 + b + u;
            double window[b > 0 ? b : 1], low[u > 0 ? u : 1];
            for (int k = 0; k < b; ++k) window[k] = x[k];
            for (int k = 0; k < u; ++k) low[k] = bottom[k];
            const double* own = columns;
            for (int j = 0; j < count; ++j, own += stride) {
                const double y = window[0];
                x[j] = y;
#pragma GCC unroll 16
                for (int k = 0; k + 1 < b; ++k) window[k] = window[k + 1] - own[k + 1] * y;
                window[b - 1] = x[j + b] - own[b] * y;
                const double* const below = own + 1 + b;
#pragma GCC unroll 16
                for (int k = 0; k < u; ++k) low[k] -= below[k] * y;
            }
            for (int k = 0; k < u; ++k) bottom[k] = low[k];
        }
    }

    static void backward(const double* columns, int count, double* x, const double* bottom,
                         const ChainWidths& widths) {
        if constexpr (Band < 0 || Border < 0) {
            backward_of_any_width(columns, count, x, bottom, widths);
        } else {
            constexpr int b = Band, u = Border, stride = 1 + b + u;
            double window[b > 0 ? b : 1] = {}, low[u > 0 ? u : 1];
            for (int k = 0; k < u; ++k) low[k] = bottom[k];
            for (int j = count - 1; j >= 0; --j) {
                const double* const own = columns + static_cast<std::ptrdiff_t>(j) * stride;
                const double* const below = own + 1 + b;
                double far = 0.0;  // oldest first; the newest entry comes last
#pragma GCC unroll 16
                for (int k = b - 1; k >= 1; --k) far += own[k + 1] * window[k];
#pragma GCC unroll 16
                for (int k = 0; k < u; ++k) far += below[k] * low[k];
                const double value = (x[j] - far) - own[1] * window[0];
                x[j] = value;
#pragma GCC unroll 16
                for (int k = b - 1; k >= 1; --k) window[k] = window[k - 1];
                window[0] = value;
            }
        }
    }

    static void forward_of_any_width(const double* columns, int count, double* x, double* bottom,
                                     const ChainWidths& widths) {
        const int b = band(widths), u = border(widths), stride = 1 + b + u;
        const double* own = columns;
        for (int j = 0; j < count; ++j, own += stride, ++x) {
            const double y = x[0];
            if (y == 0.0) continue;
            for (int k = 1; k <= b; ++k) x[k] -= own[k] * y;
            const double* const below = own + 1 + b;
            for (int k = 0; k < u; ++k) bottom[k] -= below[k] * y;
        }
    }

    static void backward_of_any_width(const double* columns, int count, double* x, const double* bottom,
                                      const ChainWidths& widths) {
        const int b = band(widths), u = border(widths), stride = 1 + b + u;
        for (int j = count - 1; j >= 0; --j) {
            const double* const own = columns + static_cast<std::ptrdiff_t>(j) * stride;
            const double* const below = own + 1 + b;
            double sum = 0.0;
            for (int k = 1; k <= b; ++k) sum += own[k] * x[j + k];
            for (int k = 0; k < u; ++k) sum += below[k] * bottom[k];
            x[j] -= sum;
        }
    }

    static ChainKernels kernels() {
        return {&subtract, &forward, &backward};
    }
};

template <int Band>
ChainKernels with_border(int border) {
    switch (border) {
        case 0:
            return Loops<Band, 0>::kernels();
        case 4:
            return Loops<Band, 4>::kernels();
        default:
            return Loops<Band, -1>::kernels();
    }
}

}  // namespace

ChainWidths padded(const ChainWidths& widths) {
    ChainWidths wide = widths;
    constexpr std::array<int, 5> usual = {4, 6, 8, 10, 12};
    for (const int band : usual)
        if (widths.band <= band) {
            wide.band = band;
            break;
        }
    if (widths.border > 0 && widths.border <= 4) wide.border = 4;
    return wide;
}

ChainKernels chain_kernels(const ChainWidths& widths) {
    switch (widths.band) {
        case 4:
            return with_border<4>(widths.border);
        case 6:
            return with_border<6>(widths.border);
        case 8:
            return with_border<8>(widths.border);
        case 10:
            return with_border<10>(widths.border);
        case 12:
            return with_border<12>(widths.border);
        default:
            return with_border<-1>(widths.border);
    }
}

}  // namespace camopt
