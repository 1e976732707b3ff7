// SPDX-License-Identifier: MIT
// Removes the proof from a certificate. For the modules that verify results.
#pragma once

#include "solvers/certificate/certificate.hpp"

namespace camopt {

/// No bound, no gap, no proof: the proof belongs to another motion or problem.
inline void forget_proof(Certificate& certificate) {
    certificate.lower_bound.reset();
    certificate.gap.reset();
    certificate.proof.reset();
    certificate.box_proof.reset();
    certificate.proof_kind = ProofKind::none;
}

}  // namespace camopt
