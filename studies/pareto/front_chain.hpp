// SPDX-License-Identifier: MIT
// The points of a front in order, while it grows. Private to studies/.
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

// Where points lie along a front of two goals, and how evenly.
//
// Lengths are measured along the polyline through all known points, after both goals are divided by their
// ranges over the front: the front runs from (0, 1) to (1, 0) of the unit box, its length lies between √2
// and 2. A jump (no point of the front in between) counts as length 0. Nothing throws.

/// A known point of the front in the unit box.
struct FrontPlace {
    std::array<double, 2> box{};
    bool jump_follows = false;  ///< nothing of the front lies between it and the next
};

/// Arc length of every place, from the first: places ascend in box[0].
[[nodiscard]] std::vector<double> arc_lengths(std::span<const FrontPlace> places);

/// A length along the polyline, and between which places it lies.
struct FrontTarget {
    int after = 0;      ///< between places after and after + 1
    double part = 0.0;  ///< of the way, in [0, 1]
};
[[nodiscard]] FrontTarget target_at(std::span<const double> arc, double length);

/// The longest piece that is no jump; -1 where there is none.
[[nodiscard]] int longest_piece(std::span<const FrontPlace> places);

/// The place nearest to a length.
[[nodiscard]] int nearest_place(std::span<const double> arc, double length);

/// One point: which it is, and both goals.
struct FrontNode {
    int point = 0;
    std::array<double, 2> value{};
};

/// From the end of least first goal to that of least second goal.
class FrontChain {
 public:
    FrontChain(const FrontNode& first_end, const FrontNode& second_end);

    /// Both goals differ at the ends by more than rounding.
    [[nodiscard]] bool has_extent() const { return has_extent_; }
    [[nodiscard]] const std::vector<FrontNode>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<FrontPlace>& places() const { return places_; }
    /// How much a goal changes along a piece, in the unit box; >= 0.
    [[nodiscard]] double change(int piece, int goal) const;
    /// Value of a goal on the way along a piece.
    [[nodiscard]] double value_within(const FrontTarget& target, int goal) const;

    /// Puts in what was found for a target. A point that is (to rounding) an old one closes the piece: a
    /// jump. Points it dominates leave the chain. False where the chain did not grow.
    bool insert(const FrontNode& node, int piece);
    /// Nothing more is to be found on this piece.
    void close(int piece) { places_[static_cast<std::size_t>(piece)].jump_follows = true; }

 private:
    [[nodiscard]] FrontPlace place_of(const FrontNode& node) const;
    void drop_dominated(const FrontPlace& by);

    std::array<double, 2> least_{}, range_{};
    bool has_extent_ = false;
    std::vector<FrontNode> nodes_;
    std::vector<FrontPlace> places_;
};

}  // namespace camopt
