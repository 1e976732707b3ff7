// SPDX-License-Identifier: MIT
// Private to objectives/: shared by the problem on a grid and its points.
#pragma once

#include "core/nlp.hpp"

#include <map>

namespace camopt {

// Assembly of a Lagrangian's Hessian: the pattern is claimed term by term before the first evaluation, then
// every evaluation adds its entries in the same order.

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
        /// Adds nothing to the next `claims`.
        void skip(std::ptrdiff_t claims) { next_ += static_cast<std::size_t>(claims); }

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

// Private to objectives/: where the exchange adds rows.

/// Samples of one rule closer than this part of their segment coincide.
inline constexpr double same_sample = 1e-9;
/// A maximum is bracketed by rows at this part of the distance to the nearest sample on either side.
inline constexpr double bracket = 0.25;
/// A row whose multiplier is below this part of the largest is inactive.
inline constexpr double idle_row = 1e-6;
/// Rows next to a predicted maximum: between active rows on both sides, at this part of the square of their
/// distance (all in parts of the segment; of 1/4, 0.35, 1/2 and 1 it takes the fewest rounds on scenes with
/// and without a cam), and never closer than the second constant: at that distance a free slope exceeds its
/// peak by at most 1e-8 of it, which the next round corrects.
inline constexpr double pair_reach = 0.35;
inline constexpr double closest_pair = 1e-3;
/// Rows closer to others than this part of their segment are nearly parallel: an interior point method loses
/// digits over them (measured: at 1e-4 one solve reached only "acceptable").
inline constexpr double too_close = 3e-4;

}  // namespace camopt
