// SPDX-License-Identifier: MIT
// Private to condensed_system.cpp: where the entries of the condensed matrix stand and what they are made of.
#pragma once

#include "linear/sparse_symmetric.hpp"
#include "solvers/structured/convex_model.hpp"
#include "solvers/structured/range_rows.hpp"

#include <vector>

namespace camopt::structured {

/// The lower triangle, with the equalities' entries in place and zeros elsewhere.
/// Entry terms[k].slot is Σ product · weight[source] over its terms, with weight = [K_l + K_u;
/// (K_l − K_u) d], plus what `hessian_slot` and `width_slot` add.
struct CondensedPattern {
    struct Term {
        int slot, source;
        double product;
    };
    CondensedPattern(const ConvexModel& model, const RangeRows& ranges);

    SymmetricFactor::Matrix lower;
    std::vector<Term> terms;
    std::vector<int> hessian_slot;  ///< of every entry of ∇²f
    std::vector<int> width_slot;    ///< the diagonal entry of every group's variable
};

}  // namespace camopt::structured
