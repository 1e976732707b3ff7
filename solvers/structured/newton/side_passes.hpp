// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the passes of one Newton step over the sides of the ranges
// (range_rows.hpp), each over memory once. They exist per KernelSet, see linear/kernel_types.hpp: plain
// structures and pointers only.
//
// An array over sides has the lower sides of all ranges, then their upper ones. A pass that makes multipliers
// ν also makes what a product with [C; E]ᵀ needs: `joined` = ν_l − ν_u per range, and `sums` = Σ d (ν_l +
// ν_u) per segment.
#pragma once

namespace camopt::structured {

/// Ranges [first, last) with the width d_r x[variable]; variable −1: without width.
struct SideSegment {
    int variable = -1, first = 0, last = 0;
};

struct SideLayout {
    const SideSegment* segments = nullptr;  ///< all ranges in their order
    int segment_count = 0;
    int ranges = 0;
    const double *width = nullptr, *limit = nullptr, *present = nullptr;  ///< as in RangeRows
};

struct SideProducts {
    double *joined = nullptr, *sums = nullptr;
};

/// Gaps and multipliers after a step (the same arrays, or others), and their residuals.
struct SideResiduals {
    const double *x = nullptr, *image = nullptr;  ///< after the step
    const double *gap = nullptr, *dual = nullptr, *gap_change = nullptr, *dual_change = nullptr;
    double primal_step = 0.0, dual_step = 0.0;
    double *new_gap = nullptr, *new_dual = nullptr;
    double* bound = nullptr;  ///< t + w − l − g
    SideProducts out;         ///< of −z
    // Results.
    double products = 0.0;     ///< Σ g z
    double largest = 0.0;      ///< of |bound|
    double bound_total = 0.0;  ///< not finite where an entry of `bound` is not
    double dual_limit = 0.0;   ///< Σ z l
};

/// What depends on the point alone.
struct SidePoint {
    const double *gap = nullptr, *dual = nullptr;
    double *inverse_gap = nullptr, *inverse_dual = nullptr;
    double* curvature = nullptr;  ///< z / g
    double* weight = nullptr;     ///< [K_l + K_u; (K_l − K_u) d]
    double* squares = nullptr;    ///< Σ (K_l + K_u) d² per segment
};

enum class ChangeRule {
    none,       ///< 0
    products,   ///< target − g z
    corrected,  ///< target − g z − δg δz, of the direction given
    centrality  ///< of the products after the steps given, towards [least, most]
};

/// The change of the products g z and the forces f = (change − z bound) / g.
struct SideForces {
    ChangeRule rule = ChangeRule::none;
    double target = 0.0;
    double least = 0.0, most = 0.0, primal_step = 0.0, dual_step = 0.0;
    const double *gap_change = nullptr, *dual_change = nullptr;
    const double *gap = nullptr, *dual = nullptr, *inverse_gap = nullptr;
    const double* bound = nullptr;  ///< null: 0
    double *change = nullptr, *force = nullptr;
    SideProducts out;  ///< of the forces
};

/// ν = K (slide of x) + sign · base
struct SideMultipliers {
    const double *x = nullptr, *image = nullptr, *curvature = nullptr, *base = nullptr;
    double sign = 1.0;
    double* nu = nullptr;
    SideProducts out;
};

/// The direction of gaps and multipliers. Each side from the more accurate of its two unknowns: the
/// multiplier where the gap is smaller, the gap elsewhere; the other follows from the product g z. The
/// opposite choice would amplify round-off.
struct SideDirection {
    const double *x = nullptr, *image = nullptr, *nu = nullptr, *change = nullptr;
    const double *gap = nullptr, *dual = nullptr, *inverse_gap = nullptr, *inverse_dual = nullptr;
    const double* bound = nullptr;                           ///< null: 0
    const double *base_gap = nullptr, *base_dual = nullptr;  ///< added; null: 0
    double *gap_change = nullptr, *dual_change = nullptr;
    // Results.
    double steepest_gap = 0.0, steepest_dual = 0.0;              ///< largest −δg / g and −δz / z, >= 0
    double total = 0.0;                                          ///< not finite where an entry is not
    double gap_dual = 0.0, dual_gap = 0.0, change_change = 0.0;  ///< Σ g δz, Σ z δg, Σ δg δz
};

struct SideKernels {
    void (*residuals)(const SideLayout& layout, SideResiduals& pass);
    void (*point)(const SideLayout& layout, const SidePoint& pass);
    void (*forces)(const SideLayout& layout, const SideForces& pass);
    void (*multipliers)(const SideLayout& layout, const SideMultipliers& pass);
    void (*direction)(const SideLayout& layout, SideDirection& pass);
};

}  // namespace camopt::structured
