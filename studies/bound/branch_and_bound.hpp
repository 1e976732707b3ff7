// SPDX-License-Identifier: MIT
// Branch and bound over parts that together hold everything, and what they prove as cases.
//
// A part has a `bound`: nothing in it costs less. The open part of the least bound is branched first, until
// every part is closed, one cannot be branched, or the search is to end. What the parts are (angles within
// boxes, strokes that rise or fall, boxes of motions), how one is bounded and how it is branched is the
// caller's.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt {

template <class Part>
struct Branching {
    /// Nothing in the part is worth a search. Parts may close as better motions are found.
    std::function<bool(const Part&)> is_closed;
    /// Asked of the open part of the least bound before it is branched; false: the search ends.
    std::function<bool(const Part&)> goes_on;
    /// Bounded parts that hold all of the part, or those of them that are still to be branched; none: it
    /// cannot be branched.
    std::function<std::optional<std::vector<Part>>(const Part&)> branch;
};

/// Puts the branches of a part in the place of it.
template <class Part>
void branch_and_bound(std::vector<Part>& parts, const Branching<Part>& by) {
    while (!parts.empty()) {
        const auto next = std::ranges::min_element(parts, [&](const Part& one, const Part& other) {
            const bool closed = by.is_closed(one);
            return closed == by.is_closed(other) ? one.bound < other.bound : !closed;
        });
        if (by.is_closed(*next) || !by.goes_on(*next)) return;
        std::optional<std::vector<Part>> branches = by.branch(*next);
        if (!branches) return;
        parts.erase(next);
        std::ranges::move(*branches, std::back_inserter(parts));
    }
}

/// The bound and the proof of a relaxation of a case, where it says more than what is known of the case.
void take_bound(CaseProof& part, const Certificate& relaxation);

/// What cases that cover everything prove of the objective of a certificate, in place of its own proof.
/// Whether all of them are infeasible.
bool take_cases(Certificate& certificate, std::vector<CaseProof> cases);

}  // namespace camopt
