// SPDX-License-Identifier: MIT
// LDLᵀ factorization of a banded matrix with a dense border:
//
//     K = [ B  Uᵀ ]     B: half-bandwidth b with its rows in the order of the chain,
//         [ U  S  ]     U, S: the border, rows that couple everything (peaks, dimensions of a cam).
//
// O(N (b + u)²) for a factor and O(N (b + u)) for a solve, no fill beyond band and border, no allocation.
// The order is found once: dense rows go to the border; the others keep their order, or are ordered by
// breadth-first search where that is narrower. A row of sign −1 whose diagonal is zero (an equality) is put
// next to a column with a large entry in it, and both are eliminated together by a 2 x 2 pivot
//
//     [ p   e ]     p, n >= 0: its determinant −p n − e² never vanishes, so a free variable (p = 0) and an
//     [ e  −n ]     equality (n = 0) need no shift of the diagonal and lose no digits.
//
// Sources: George and Liu, Computer Solution of Large Sparse Positive Definite Systems (1981);
// de Niet and Wubs, Numerically stable LDLᵀ-factorization of F-type saddle point matrices, IMA J. Numer.
// Anal. 29 (2009).
#pragma once

#include "linear/symmetric_factor.hpp"

namespace camopt {

/// Null if the matrix is not such a chain: its band would be wide and dense storage would cost more than it
/// saves. `lower` with the values of the constant rows (those of sign −1): pivots are chosen by magnitude.
[[nodiscard]] std::unique_ptr<SymmetricFactor> make_chain_factor(const SymmetricFactor::Matrix& lower,
                                                                 const std::vector<int>& signs);

// Internal to linear/: the order in which a chain with a border is eliminated.

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
