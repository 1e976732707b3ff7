// SPDX-License-Identifier: MIT
#include "studies/bound/branch_and_bound.hpp"

namespace camopt {

void take_bound(CaseProof& part, const Certificate& relaxation) {
    part.infeasible = relaxation.verdict == Verdict::infeasible;
    const bool better = relaxation.lower_bound && *relaxation.lower_bound >= part.bound;
    if (better) part.bound = *relaxation.lower_bound;
    if (relaxation.proof && (better || part.infeasible))
        part.proof = std::make_shared<DualityProof>(*relaxation.proof);
}

bool take_cases(Certificate& certificate, std::vector<CaseProof> cases) {
    forget_proof(certificate);
    certificate.proof_kind = ProofKind::boxes;
    double bound = infinity;
    for (const CaseProof& part : cases)
        if (!part.infeasible) bound = std::min(bound, part.bound);
    if (std::isfinite(bound) && std::isfinite(certificate.objective)) {
        certificate.lower_bound = std::min(bound, certificate.objective);
        certificate.gap = relative_gap(certificate.objective, *certificate.lower_bound);
    }
    certificate.cases = std::move(cases);
    return bound == infinity;
}

}  // namespace camopt
