// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the passes of one KernelSet, see side_kernels.hpp. Included by one source
// per set, which names the set's namespace in CAMOPT_KERNELS. Nothing here may call a function outside it.
#pragma once

#include "solvers/structured/newton/side_kernels.hpp"

#ifndef CAMOPT_KERNELS
#define CAMOPT_KERNELS baseline_kernels
#endif

namespace camopt::structured::CAMOPT_KERNELS {

// Vectors of what one register of the set holds (an extension that g++ and clang have on every architecture).
#ifdef __AVX2__
constexpr int lanes = 4;
#else
constexpr int lanes = 2;
#endif
using Pack = double __attribute__((vector_size(8 * lanes)));
using UnalignedPack = double __attribute__((vector_size(8 * lanes), aligned(8), may_alias));

template <typename V>
V at(const double* from) {
    if constexpr (sizeof(V) == sizeof(double))
        return *from;
    else
        return *reinterpret_cast<const UnalignedPack*>(from);
}
inline void store(double* to, const Pack& v) {
    *reinterpret_cast<UnalignedPack*>(to) = v;
}
inline void store(double* to, const double& v) {
    *to = v;
}

/// A sum in `lanes` parts.
struct Sum {
    Pack wide = {};
    double rest = 0.0;
    void add(const Pack& v) { wide += v; }
    void add(const double& v) { rest += v; }
    [[nodiscard]] double total() const {
        double sum = rest;
        for (int k = 0; k < lanes; ++k) sum += wide[k];
        return sum;
    }
};

/// The largest of 0 and what was added.
struct Largest {
    Pack wide = {};
    double rest = 0.0;
    void add(const Pack& v) { wide = v > wide ? v : wide; }
    void add(const double& v) { rest = v > rest ? v : rest; }
    [[nodiscard]] double value() const {
        double most = rest;
        for (int k = 0; k < lanes; ++k) most = wide[k] > most ? wide[k] : most;
        return most;
    }
};

/// body(V{}, r) for all ranges, V a Pack or a number.
template <typename Body>
void each_part(int first, int last, const Body& body) {
    int r = first;
    for (; r + lanes <= last; r += lanes) body(Pack{}, r);
    for (; r < last; ++r) body(0.0, r);
}

/// Collects what a product with [C; E]ᵀ needs.
struct Collector {
    const double* width;
    double* joined;
    Sum sum;
    template <typename V>
    void add(int r, const V& low, const V& high) {
        store(joined + r, low - high);
        sum.add(at<V>(width + r) * (low + high));
    }
};

/// body(V{}, r, factor, collector) for all ranges, segment by segment: `factor` is what the widths d of the
/// segment are multiplied by at x (0: its ranges have none); the sums of the collector go to `out`, where it
/// has any.
template <typename Body>
void each_range(const SideLayout& layout, const double* x, const SideProducts& out, const Body& body) {
    for (int s = 0; s < layout.segment_count; ++s) {
        const SideSegment& segment = layout.segments[s];
        const double factor = x != nullptr && segment.variable >= 0 ? x[segment.variable] : 0.0;
        Collector collector{layout.width, out.joined, {}};
        each_part(segment.first, segment.last, [&](auto kind, int r) { body(kind, r, factor, collector); });
        if (out.sums != nullptr) out.sums[s] = collector.sum.total();
    }
}

inline void residuals(const SideLayout& layout, SideResiduals& pass) {
    const int count = layout.ranges;
    Sum products, bound_total, dual_limit;
    Largest largest;
    each_range(layout, pass.x, pass.out, [&](auto kind, int r, double factor, Collector& collector) {
        using V = decltype(kind);
        const V image = at<V>(pass.image + r), width = at<V>(layout.width + r);
        const auto side = [&](int b, const V& slide) {
            const V gap = at<V>(pass.gap + b) + pass.primal_step * at<V>(pass.gap_change + b);
            const V dual = at<V>(pass.dual + b) + pass.dual_step * at<V>(pass.dual_change + b);
            const V limit = at<V>(layout.limit + b);
            store(pass.new_gap + b, gap);
            store(pass.new_dual + b, dual);
            const V bound = (slide - limit - gap) * at<V>(layout.present + b);
            store(pass.bound + b, bound);
            products.add(gap * dual);
            bound_total.add(bound);
            dual_limit.add(dual * limit);
            largest.add(bound);
            largest.add(-bound);
            return dual;
        };
        const V low = side(r, width * factor + image), high = side(count + r, width * factor - image);
        collector.add<V>(r, -low, -high);
    });
    pass.products = products.total();
    pass.bound_total = bound_total.total();
    pass.dual_limit = dual_limit.total();
    pass.largest = largest.value();
}

inline void point(const SideLayout& layout, const SidePoint& pass) {
    constexpr double tiniest = 1e-300;  // replaces 0 where nothing changes
    const int count = layout.ranges;
    each_range(layout, nullptr, {nullptr, pass.squares}, [&](auto kind, int r, double, Collector& squares) {
        using V = decltype(kind);
        const auto side = [&](int b) {
            const V gap = at<V>(pass.gap + b), dual = at<V>(pass.dual + b);
            const V least = V{} + tiniest;
            const V inverse_gap = 1.0 / gap, inverse_dual = 1.0 / (dual > least ? dual : least);
            const V curvature = dual * inverse_gap;
            store(pass.inverse_gap + b, inverse_gap);
            store(pass.inverse_dual + b, inverse_dual);
            store(pass.curvature + b, curvature);
            return curvature;
        };
        const V low = side(r), high = side(count + r);
        const V width = at<V>(layout.width + r), weight = low + high;
        store(pass.weight + r, weight);
        store(pass.weight + count + r, V((low - high) * width));
        squares.sum.add(weight * width * width);
    });
}

template <ChangeRule Rule, bool Bounded>
void forces_by(const SideLayout& layout, const SideForces& pass) {
    const int count = layout.ranges;
    each_range(layout, nullptr, pass.out, [&](auto kind, int r, double, Collector& collector) {
        using V = decltype(kind);
        const auto side = [&](int b) {
            const V dual = at<V>(pass.dual + b);
            V gap, present, change = {};
            if constexpr (Rule != ChangeRule::none) {
                gap = at<V>(pass.gap + b);
                present = at<V>(layout.present + b);
            }
            if constexpr (Rule == ChangeRule::products || Rule == ChangeRule::corrected)
                change = pass.target * present - gap * dual;
            if constexpr (Rule == ChangeRule::corrected || Rule == ChangeRule::centrality) {
                const V gap_change = at<V>(pass.gap_change + b), dual_change = at<V>(pass.dual_change + b);
                if constexpr (Rule == ChangeRule::corrected) {
                    change -= gap_change * dual_change;
                } else {
                    const V product =
                        (gap + pass.primal_step * gap_change) * (dual + pass.dual_step * dual_change);
                    const V least = V{} + pass.least, most = V{} + pass.most;
                    const V raised = product > least ? product : least;
                    const V wanted = raised < most ? raised : most;
                    const V difference = wanted - product;
                    change = present * (difference > -most ? difference : -most);
                }
            }
            store(pass.change + b, change);
            V force = change;
            if constexpr (Bounded) force -= dual * at<V>(pass.bound + b);
            force *= at<V>(pass.inverse_gap + b);
            store(pass.force + b, force);
            return force;
        };
        const V low = side(r), high = side(count + r);
        collector.add<V>(r, low, high);
    });
}

inline void forces(const SideLayout& layout, const SideForces& pass) {
    const bool bounded = pass.bound != nullptr;
    switch (pass.rule) {
        case ChangeRule::none:
            return bounded ? forces_by<ChangeRule::none, true>(layout, pass)
                           : forces_by<ChangeRule::none, false>(layout, pass);
        case ChangeRule::products:
            return forces_by<ChangeRule::products, true>(layout, pass);
        case ChangeRule::corrected:
            return forces_by<ChangeRule::corrected, true>(layout, pass);
        case ChangeRule::centrality:
            return forces_by<ChangeRule::centrality, false>(layout, pass);
    }
}

inline void multipliers(const SideLayout& layout, const SideMultipliers& pass) {
    const int count = layout.ranges;
    each_range(layout, pass.x, pass.out, [&](auto kind, int r, double factor, Collector& collector) {
        using V = decltype(kind);
        const V image = at<V>(pass.image + r), width = at<V>(layout.width + r);
        const auto side = [&](int b, const V& slide) {
            const V nu = at<V>(pass.curvature + b) * slide + pass.sign * at<V>(pass.base + b);
            store(pass.nu + b, nu);
            return nu;
        };
        const V low = side(r, width * factor + image), high = side(count + r, width * factor - image);
        collector.add<V>(r, low, high);
    });
}

template <bool Bounded, bool Based>
void direction_by(const SideLayout& layout, SideDirection& pass) {
    const int count = layout.ranges;
    Sum total, gap_dual, dual_gap, change_change;
    Largest steepest_gap, steepest_dual;
    each_range(layout, pass.x, {}, [&](auto kind, int r, double factor, Collector&) {
        using V = decltype(kind);
        const V image = at<V>(pass.image + r), width = at<V>(layout.width + r);
        const auto side = [&](int b, const V& slide) {
            const V change = at<V>(pass.change + b), gap = at<V>(pass.gap + b), dual = at<V>(pass.dual + b);
            const V inverse_gap = at<V>(pass.inverse_gap + b), inverse_dual = at<V>(pass.inverse_dual + b);
            V of_gap = slide * at<V>(layout.present + b);
            if constexpr (Bounded) of_gap += at<V>(pass.bound + b);
            const V of_dual = -at<V>(pass.nu + b);
            V gap_change = dual > gap ? (change - gap * of_dual) * inverse_dual : of_gap;
            V dual_change = dual > gap ? of_dual : (change - dual * of_gap) * inverse_gap;
            if constexpr (Based) {
                gap_change += at<V>(pass.base_gap + b);
                dual_change += at<V>(pass.base_dual + b);
            }
            store(pass.gap_change + b, gap_change);
            store(pass.dual_change + b, dual_change);
            steepest_gap.add(-gap_change * inverse_gap);
            steepest_dual.add(-dual_change * inverse_dual);
            total.add(gap_change + dual_change);
            gap_dual.add(gap * dual_change);
            dual_gap.add(dual * gap_change);
            change_change.add(gap_change * dual_change);
        };
        side(r, width * factor + image);
        side(count + r, width * factor - image);
    });
    pass.steepest_gap = steepest_gap.value();
    pass.steepest_dual = steepest_dual.value();
    pass.total = total.total();
    pass.gap_dual = gap_dual.total();
    pass.dual_gap = dual_gap.total();
    pass.change_change = change_change.total();
}

inline void direction(const SideLayout& layout, SideDirection& pass) {
    if (pass.base_gap != nullptr) return direction_by<false, true>(layout, pass);
    if (pass.bound != nullptr) return direction_by<true, false>(layout, pass);
    return direction_by<false, false>(layout, pass);
}

inline SideKernels kernels() {
    return {&residuals, &point, &forces, &multipliers, &direction};
}

}  // namespace camopt::structured::CAMOPT_KERNELS
