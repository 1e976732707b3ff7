// SPDX-License-Identifier: MIT
#include "studies/search/cost_scale.hpp"

#include "scene/cost_table.hpp"
#include "solvers/certificate/box_proof.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace camopt {

namespace {

// References this far from those of good motions, and objectives this far from one, are scaled.
constexpr int idle_reference_exponent = 7;
constexpr double least_idle_cost = 0.25, most_idle_cost = 64.0;
// Scaled costs lie below 1 where they were small (the gap is then no looser) and above it where they were
// large.
constexpr double large_cost = 8.0;

double power_of_two(double exponent) {
    return std::ldexp(1.0, static_cast<int>(exponent));
}

/// The objective of a good motion, to a factor of ten.
double typical_cost(const Scene& scene, const Peaks& reference) {
    double cost = 0.0;
    for (const CostTerm& term : cost_terms()) {
        const double weight = term.weight_in(scene.objective);
        if (weight > 0.0)
            cost += weight * term.typical /
                    (scene.objective.reference.*term.reference).value_or(term.measured.of(reference));
    }
    for (const ResponseTerm& term : response_terms()) cost += term.weight_in(scene.objective);
    for (const double weight : scene.objective.dimensions) cost += weight;
    for (const OwnTerm& term : scene.own_terms) cost += term.weight;
    return cost;
}

}  // namespace

CostScale::CostScale(const Scene& scene, const Peaks& reference) : scaled_(scene) {
    if (scene.objective.reference.numeric) scale_references();
    scale_weights(reference);
}

void CostScale::scale_references() {
    for (const CostTerm& term : cost_terms()) {
        std::optional<double>& number = scaled_.objective.reference.*term.reference;
        if (!number) continue;
        const double exponent = std::round(std::log2(*number / term.typical));
        if (std::abs(exponent) <= idle_reference_exponent) continue;
        *number /= power_of_two(exponent);
        scaled_.objective.*term.weight /= power_of_two(exponent);
        idle_ = false;
    }
}

bool CostScale::are_near_one(const Scene& scene, const Peaks& reference) {
    const double cost = typical_cost(scene, reference);
    return cost == 0.0 || (cost >= least_idle_cost && cost <= most_idle_cost);  // 0: nothing is weighed
}

void CostScale::scale_weights(const Peaks& reference) {
    if (are_near_one(scaled_, reference)) return;
    const double cost = typical_cost(scaled_, reference);
    idle_ = false;
    factor_ =
        power_of_two(cost < 1.0 ? std::ceil(std::log2(cost)) : std::floor(std::log2(cost / large_cost)));
    for (const CostTerm& term : cost_terms()) scaled_.objective.*term.weight /= factor_;
    for (const ResponseTerm& term : response_terms()) scaled_.objective.*term.weight /= factor_;
    for (double& weight : scaled_.objective.dimensions) weight /= factor_;
    for (OwnTerm& term : scaled_.own_terms) term.weight /= factor_;
}

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

void CostScale::restore(Solution& solution, const Scene& scene, const Peaks& reference) const {
    solution.scene = scene;
    solution.reference_peaks = reference;
    for (std::size_t i = 0; i < solution.own_terms.size(); ++i) {
        OwnTermReport& term = solution.own_terms[i];
        term.weight = term.of_whole_motion ? scene.objective.area : scene.own_terms[i].weight;
    }
    if (solution.train)
        for (ResponseTermReport& term : solution.train->terms) term.weight *= factor_;
    if (solution.any_curve_limit) solution.any_curve_limit->objective *= factor_;
    Certificate& certificate = solution.certificate;
    certificate.objective *= factor_;
    if (certificate.stationarity) *certificate.stationarity *= factor_;
    scale_cases(certificate.cases, factor_);
    if (certificate.box_proof) certificate.box_proof = scaled_box_proof(*certificate.box_proof, factor_);
    if (!certificate.lower_bound) return;
    *certificate.lower_bound *= factor_;
    if (certificate.gap)
        certificate.gap =
            std::max(*certificate.gap, relative_gap(certificate.objective, *certificate.lower_bound));
    if (certificate.proof) scale_proof(*certificate.proof, factor_);
}

}  // namespace camopt
