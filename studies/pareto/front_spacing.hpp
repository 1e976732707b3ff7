// SPDX-License-Identifier: MIT
// Where points lie along a front of two goals, and how evenly.
//
// Lengths are measured along the polyline through all known points, after both goals are divided by their
// ranges over the front: the front runs from (0, 1) to (1, 0) of the unit box, its length lies between √2
// and 2. A jump (no point of the front in between) counts as length 0. Nothing throws.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace camopt {

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

}  // namespace camopt
