// SPDX-License-Identifier: MIT
// A certificate without what is proved of it. Of the modules that judge.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt {

/// No bound, no gap, no proof: what was proved is not of the motion, or not of the problem, that is judged
/// now.
inline void forget_proof(Certificate& certificate) {
    certificate.lower_bound.reset();
    certificate.gap.reset();
    certificate.proof.reset();
    certificate.box_proof.reset();
    certificate.proof_kind = ProofKind::none;
}

}  // namespace camopt
