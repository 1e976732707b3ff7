// SPDX-License-Identifier: MIT
// The response of a chain in 113 bits (33 digits), for others to be measured by.
//
// On each piece the powers of x drive the chain and are states themselves, x^k' = k x^{k−1}, so that all of
// it is one matrix exponential, by scaling, a Taylor series and squaring. Nothing of camopt is used.
#pragma once

#include "benchmarks/trains/chain.hpp"

namespace trains {

/// y'' = Σ_k powers[k] x^k, x from the begin of the piece.
struct InputPiece {
    double width = 1.0;
    std::vector<double> powers;
    double kick = 0.0;  // by which y' jumps where it begins
};

struct ExactResponse {
    double output = 0.0, rate = 0.0;                  // u_n, v_n at the end, from rest
    double largest_output = 0.0, largest_rate = 0.0;  // over the pieces, at so many places
    double largest_pull = 0.0;  // of k_1 u_1 + c_1 frequency v_1: what the first spring and damper pull with
};

/// Looked at `places` places of each piece, evenly; one piece: the input of the chain.
ExactResponse exact_response(const Chain& chain, const std::vector<InputPiece>& pieces, int places);
ExactResponse exact_response(const Chain& chain);

}  // namespace trains
