// SPDX-License-Identifier: MIT
// Assembly of a Lagrangian's Hessian: the pattern is claimed term by term before the first evaluation, then
// every evaluation adds its entries in the same order.
#pragma once

#include "core/nlp.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace camopt {

/// The slot of each claimed entry, in the order of the claims. Entries claimed twice share a slot.
class HessianSlots {
 public:
    /// The entry of a row and a column, in either order. A new one extends `pattern` (lower triangle).
    void claim(SparsityPattern& pattern, int row, int column) {
        const std::pair<int, int> place{std::max(row, column), std::min(row, column)};
        const auto [found, fresh] = known_.try_emplace(place, static_cast<int>(known_.size()));
        if (fresh) {
            pattern.rows.push_back(place.first);
            pattern.columns.push_back(place.second);
        }
        slots_.push_back(found->second);
    }

    /// No claims will follow: frees the look-up table.
    void finish() { known_ = {}; }

    /// Adds values to `out` (one entry per slot), the first to the first claim, and so on.
    class Adder {
     public:
        Adder(const std::vector<int>& slots, std::span<double> out) : slots_(slots), out_(out) {}
        void operator()(double value) { out_[static_cast<std::size_t>(slots_[next_++])] += value; }

     private:
        const std::vector<int>& slots_;
        std::span<double> out_;
        std::size_t next_ = 0;
    };

    [[nodiscard]] Adder into(std::span<double> out) const { return {slots_, out}; }

 private:
    std::map<std::pair<int, int>, int> known_;
    std::vector<int> slots_;
};

}  // namespace camopt
