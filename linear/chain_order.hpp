// SPDX-License-Identifier: MIT
// Internal to linear/: the order in which a chain with a border is eliminated (chain_factor.hpp).
#pragma once

#include "linear/sparse_symmetric.hpp"

#include <optional>
#include <vector>

namespace camopt {

struct ChainOrder {
    std::vector<int> sequence;     ///< rows of the chain, in the order of elimination
    std::vector<int> position;     ///< of every row: in `sequence`, or sequence.size() + place in `border`
    std::vector<char> opens_pair;  ///< for each place of `sequence`: a 2 x 2 pivot with the next one
    std::vector<int> border;       ///< dense rows, eliminated last
    int half_bandwidth = 0;
};

/// Nullopt if the band would be wide.
[[nodiscard]] std::optional<ChainOrder> chain_order(const SymmetricFactor::Matrix& lower,
                                                    const std::vector<int>& signs);

}  // namespace camopt
