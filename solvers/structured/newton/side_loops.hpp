// SPDX-License-Identifier: MIT
// Internal to solvers/structured/: the passes of one KernelSet, see side_passes.hpp. Included by one source
// per set, which names the set's namespace in CAMOPT_KERNELS. Nothing here may call a function outside it.
#pragma once

#include "solvers/structured/newton/side_passes.hpp"

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

inline void load(Pack& v, const double* from) {
    v = *reinterpret_cast<const UnalignedPack*>(from);
}
inline void load(double& v, const double* from) {
    v = *from;
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

/// What the widths d of a segment are multiplied by at x; 0: its ranges have none.
inline double factor_of(const SideSegment& segment, const double* x) {
    return segment.variable >= 0 ? x[segment.variable] : 0.0;
}

/// Collects what a product with [C; E]ᵀ needs.
struct Collector {
    const double* width = nullptr;
    double* joined = nullptr;
    Sum sum;
    template <typename V>
    void add(int r, const V& low, const V& high) {
        V d;
        load(d, width + r);
        store(joined + r, low - high);
        sum.add(d * (low + high));
    }
};

inline void residuals(const SideLayout& layout, SideResiduals& pass) {
    const int count = layout.ranges;
    Sum products, bound_total, dual_limit;
    Largest largest;
    for (int s = 0; s < layout.segment_count; ++s) {
        const SideSegment& segment = layout.segments[s];
        const double factor = factor_of(segment, pass.x);
        Collector collector{layout.width, pass.out.joined, {}};
        each_part(segment.first, segment.last, [&](auto kind, int r) {
            using V = decltype(kind);
            V image, width;
            load(image, pass.image + r);
            load(width, layout.width + r);
            const auto side = [&](int b, const V& slide) {
                V gap, dual, gap_change, dual_change, limit, present;
                load(gap, pass.gap + b);
                load(dual, pass.dual + b);
                load(gap_change, pass.gap_change + b);
                load(dual_change, pass.dual_change + b);
                load(limit, layout.limit + b);
                load(present, layout.present + b);
                gap += pass.primal_step * gap_change;
                dual += pass.dual_step * dual_change;
                store(pass.new_gap + b, gap);
                store(pass.new_dual + b, dual);
                const V bound = (slide - limit - gap) * present;
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
        pass.out.sums[s] = collector.sum.total();
    }
    pass.products = products.total();
    pass.bound_total = bound_total.total();
    pass.dual_limit = dual_limit.total();
    pass.largest = largest.value();
}

inline void point(const SideLayout& layout, const SidePoint& pass) {
    constexpr double tiniest = 1e-300;  // replaces 0 where nothing changes
    const int count = layout.ranges;
    for (int s = 0; s < layout.segment_count; ++s) {
        const SideSegment& segment = layout.segments[s];
        Sum squares;
        each_part(segment.first, segment.last, [&](auto kind, int r) {
            using V = decltype(kind);
            const auto side = [&](int b) {
                V gap, dual;
                load(gap, pass.gap + b);
                load(dual, pass.dual + b);
                const V least = V{} + tiniest;
                const V inverse_gap = 1.0 / gap, inverse_dual = 1.0 / (dual > least ? dual : least);
                const V curvature = dual * inverse_gap;
                store(pass.inverse_gap + b, inverse_gap);
                store(pass.inverse_dual + b, inverse_dual);
                store(pass.curvature + b, curvature);
                return curvature;
            };
            const V low = side(r), high = side(count + r);
            V width;
            load(width, layout.width + r);
            const V weight = low + high;
            store(pass.weight + r, weight);
            store(pass.weight + count + r, V((low - high) * width));
            squares.add(weight * width * width);
        });
        pass.squares[s] = squares.total();
    }
}

template <ChangeRule Rule, bool Bounded>
void forces_by(const SideLayout& layout, const SideForces& pass) {
    const int count = layout.ranges;
    for (int s = 0; s < layout.segment_count; ++s) {
        const SideSegment& segment = layout.segments[s];
        Collector collector{layout.width, pass.out.joined, {}};
        each_part(segment.first, segment.last, [&](auto kind, int r) {
            using V = decltype(kind);
            const auto side = [&](int b) {
                V gap, dual, present, inverse, change = {};
                load(dual, pass.dual + b);
                load(inverse, pass.inverse_gap + b);
                if constexpr (Rule != ChangeRule::none) {
                    load(gap, pass.gap + b);
                    load(present, layout.present + b);
                }
                if constexpr (Rule == ChangeRule::products || Rule == ChangeRule::corrected)
                    change = pass.target * present - gap * dual;
                if constexpr (Rule == ChangeRule::corrected || Rule == ChangeRule::centrality) {
                    V gap_change, dual_change;
                    load(gap_change, pass.gap_change + b);
                    load(dual_change, pass.dual_change + b);
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
                if constexpr (Bounded) {
                    V bound;
                    load(bound, pass.bound + b);
                    force -= dual * bound;
                }
                force *= inverse;
                store(pass.force + b, force);
                return force;
            };
            const V low = side(r), high = side(count + r);
            collector.add<V>(r, low, high);
        });
        pass.out.sums[s] = collector.sum.total();
    }
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
    for (int s = 0; s < layout.segment_count; ++s) {
        const SideSegment& segment = layout.segments[s];
        const double factor = factor_of(segment, pass.x);
        Collector collector{layout.width, pass.out.joined, {}};
        each_part(segment.first, segment.last, [&](auto kind, int r) {
            using V = decltype(kind);
            V image, width;
            load(image, pass.image + r);
            load(width, layout.width + r);
            const auto side = [&](int b, const V& slide) {
                V curvature, base;
                load(curvature, pass.curvature + b);
                load(base, pass.base + b);
                const V nu = curvature * slide + pass.sign * base;
                store(pass.nu + b, nu);
                return nu;
            };
            const V low = side(r, width * factor + image), high = side(count + r, width * factor - image);
            collector.add<V>(r, low, high);
        });
        pass.out.sums[s] = collector.sum.total();
    }
}

template <bool Bounded, bool Based>
void direction_by(const SideLayout& layout, SideDirection& pass) {
    const int count = layout.ranges;
    Sum total, gap_dual, dual_gap, change_change;
    Largest steepest_gap, steepest_dual;
    for (int s = 0; s < layout.segment_count; ++s) {
        const SideSegment& segment = layout.segments[s];
        const double factor = factor_of(segment, pass.x);
        each_part(segment.first, segment.last, [&](auto kind, int r) {
            using V = decltype(kind);
            V image, width;
            load(image, pass.image + r);
            load(width, layout.width + r);
            const auto side = [&](int b, const V& slide) {
                V nu, change, gap, dual, inverse_gap, inverse_dual, present;
                load(nu, pass.nu + b);
                load(change, pass.change + b);
                load(gap, pass.gap + b);
                load(dual, pass.dual + b);
                load(inverse_gap, pass.inverse_gap + b);
                load(inverse_dual, pass.inverse_dual + b);
                load(present, layout.present + b);
                V of_gap = slide * present;
                if constexpr (Bounded) {
                    V bound;
                    load(bound, pass.bound + b);
                    of_gap += bound;
                }
                const V of_dual = -nu;
                V gap_change = dual > gap ? (change - gap * of_dual) * inverse_dual : of_gap;
                V dual_change = dual > gap ? of_dual : (change - dual * of_gap) * inverse_gap;
                if constexpr (Based) {
                    V base_gap, base_dual;
                    load(base_gap, pass.base_gap + b);
                    load(base_dual, pass.base_dual + b);
                    gap_change += base_gap;
                    dual_change += base_dual;
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
    }
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
