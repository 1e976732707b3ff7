// SPDX-License-Identifier: MIT
#include "solvers/certificate/scale_cost.hpp"

#include "solvers/certificate/box_proof.hpp"

namespace camopt {

namespace {

void scale_proof(DualityProof& proof, double factor) {
    if (proof.statement != "objective") return;
    proof.cost *= factor;
    proof.constant *= factor;
    proof.multipliers *= factor;
    proof.bound *= factor;
}

/// Cases that share a proof share it still.
void scale_cases(std::vector<CaseProof>& cases, double factor) {
    std::map<const DualityProof*, std::shared_ptr<const DualityProof>> scaled;
    for (CaseProof& part : cases) {
        part.bound *= factor;
        if (!part.proof) continue;
        std::shared_ptr<const DualityProof>& known = scaled[part.proof.get()];
        if (!known) {
            auto proof = std::make_shared<DualityProof>(*part.proof);
            scale_proof(*proof, factor);
            known = std::move(proof);
        }
        part.proof = known;
    }
}

/// Of the parts' multipliers those of the row on the cost keep their value: it is scaled as the cost is.
std::shared_ptr<const BoxProof> scaled_box_proof(const BoxProof& given, double factor) {
    auto proof = std::make_shared<BoxProof>(given);
    proof->cost *= factor;
    proof->constant *= factor;
    proof->bound *= factor;
    const auto is_cost = [&](int step) {
        return given.steps[static_cast<std::size_t>(step)].kind == BoxStep::Kind::cost;
    };
    for (BoxStep& step : proof->steps) {
        if (step.kind == BoxStep::Kind::cost) {
            step.weights *= factor;
            step.side *= factor;
        }
        for (auto& [index, multiplier] : step.multipliers)
            if (is_cost(index)) multiplier /= factor;
    }
    for (BoxPart& part : proof->parts) {
        if (!part.infeasible) part.bound *= factor;
        for (auto& [index, multiplier] : part.multipliers) {
            if (is_cost(index)) multiplier /= factor;
            if (!part.infeasible) multiplier *= factor;
        }
    }
    return proof;
}

}  // namespace

void scale_cost(Certificate& certificate, double factor) {
    if (factor == 1.0) return;
    certificate.objective *= factor;
    if (certificate.stationarity) *certificate.stationarity *= factor;
    scale_cases(certificate.cases, factor);
    if (certificate.box_proof) certificate.box_proof = scaled_box_proof(*certificate.box_proof, factor);
    if (!certificate.lower_bound) return;
    *certificate.lower_bound *= factor;
    if (certificate.gap)
        certificate.gap =
            std::max(*certificate.gap, relative_gap(certificate.objective, *certificate.lower_bound));
    if (certificate.proof) scale_proof(*certificate.proof, factor);
}

}  // namespace camopt
