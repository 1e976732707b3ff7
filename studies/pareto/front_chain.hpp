// SPDX-License-Identifier: MIT
// The points of a front in order, while it grows. Private to studies/.
#pragma once

#include "studies/pareto/front_spacing.hpp"

#include <array>
#include <vector>

namespace camopt {

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
