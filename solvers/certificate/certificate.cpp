// SPDX-License-Identifier: MIT
#include "solvers/certificate/certificate.hpp"

#include "core/errors.hpp"
#include "core/text/list_text.hpp"
#include "core/word_of.hpp"

#include <fmt/format.h>

#include <ostream>

namespace camopt {

namespace {

struct Named {
    Reason reason;
    const char* name;
};

constexpr std::array named_reasons = {
    Named{Reason::none, ""},
    Named{Reason::not_run, "not_run"},
    Named{Reason::converged, "converged"},
    Named{Reason::acceptable, "acceptable"},
    Named{Reason::infeasible, "infeasible"},
    Named{Reason::unbounded, "unbounded"},
    Named{Reason::iteration_limit, "iteration_limit"},
    Named{Reason::time_limit, "time_limit"},
    Named{Reason::interrupted, "interrupted"},
    Named{Reason::numerical_failure, "numerical_failure"},
    Named{Reason::evaluation_error, "evaluation_error"},
    Named{Reason::unsupported, "unsupported"},
    Named{Reason::no_feasible_point, "no_feasible_point"},
    Named{Reason::limits_contradict, "limits_contradict"},
    Named{Reason::conditions_contradict, "conditions_contradict"},
    Named{Reason::limit_broken_at_rest, "limit_broken_at_rest"},
    Named{Reason::given_cam, "given_cam"},
    Named{Reason::limits_within_rounding, "limits_within_rounding_of_infeasible"},
    Named{Reason::stationary, "stationary, not proved optimal"},
    Named{Reason::free_displacements, "free_displacements"},
    Named{Reason::free_angles, "free_angles"},
    Named{Reason::breakpoints_too_close, "breakpoints_too_close"},
    Named{Reason::coefficients_too_coarse, "coefficients_too_coarse"},
    Named{Reason::condition_not_met, "condition_not_met"},
    Named{Reason::cam_cannot_be_built, "cam_cannot_be_built"},
    Named{Reason::limit_not_kept, "limit_not_kept"},
    Named{Reason::objective_not_of_the_curve, "objective_not_of_the_curve"},
};

}  // namespace

Certificate::Certificate() = default;
Certificate::Certificate(const Certificate& other) = default;
Certificate::Certificate(Certificate&& other) = default;  // NOLINT(performance-noexcept-move-constructor)
Certificate& Certificate::operator=(const Certificate& other) = default;
// NOLINTNEXTLINE(performance-noexcept-move-constructor)
Certificate& Certificate::operator=(Certificate&& other) = default;
Certificate::~Certificate() = default;

const char* name_of(Verdict value) {
    return word_of<Verdict::failed>(value, {"optimal", "local", "feasible", "infeasible", "failed"});
}

const char* name_of(ProofKind value) {
    if (value == ProofKind::any_curve_limit) return "any_curve_limit";
    if (value == ProofKind::boxes) return "boxes";
    return value == ProofKind::duality ? "duality" : "none";
}

std::string row_name(const DualityProof& proof, std::size_t row) {
    return proof.rows.empty() ? proof.origins[row].text() : proof.rows[row];
}

double relative_gap(double objective, double bound) {
    return std::max(0.0, objective - bound) / std::max(1.0, std::abs(objective));
}

bool bound_passes(double objective, double bound, double tolerance) {
    return bound > objective + tolerance * std::max(1.0, std::abs(objective));
}

void take_bound(Certificate& certificate, const Certificate& relaxed, double wanted_gap) {
    certificate.lower_bound = std::min(*relaxed.lower_bound, certificate.objective);
    certificate.gap = relative_gap(certificate.objective, *certificate.lower_bound);
    certificate.proof_kind = relaxed.proof_kind;
    certificate.proof = relaxed.proof;
    certificate.cases = relaxed.cases;
    certificate.box_proof = relaxed.box_proof;
    if (*certificate.gap > wanted_gap) return;
    certificate.verdict = Verdict::optimal;
    certificate.reason = Reason::none;
}

void settle_by_relaxation(Certificate& certificate, const Certificate& relaxed, double wanted_gap) {
    if (relative_gap(certificate.objective, *relaxed.lower_bound) <= wanted_gap)
        return take_bound(certificate, relaxed, wanted_gap);
    forget_proof(certificate);  // of rows that the scene does not have
    if (certificate.verdict != Verdict::optimal) return;
    certificate.verdict = Verdict::local;
    certificate.reason = Reason::stationary;
}

double recomputed_bound(const DualityProof& proof) {
    const Eigen::Index variables = proof.cost.size();
    const Eigen::Index rows = proof.multipliers.size();
    if (proof.matrix.rows() != rows || proof.matrix.cols() != variables || proof.lower.size() != rows ||
        proof.upper.size() != rows || proof.box.lower.size() != variables ||
        proof.box.upper.size() != variables) {
        throw ModelError("duality proof: its parts do not have matching sizes");
    }
    // `size` sums the magnitudes of the terms: a double carries each to half a unit in the last place, and
    // the round-off of the long double sums below is far smaller.
    long double bound = proof.constant;
    long double size = std::abs(proof.constant);
    std::vector<long double> reduced(proof.cost.begin(), proof.cost.end());
    std::vector<long double> reduced_size(variables);
    for (Eigen::Index j = 0; j < variables; ++j) reduced_size[j] = std::abs(proof.cost[j]);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const long double multiplier = proof.multipliers[i];
        if (multiplier == 0.0L) continue;
        const double side = multiplier > 0.0L ? proof.upper[i] : proof.lower[i];
        if (!std::isfinite(side)) throw ModelError("duality proof: a multiplier refers to a missing bound");
        bound -= multiplier * side;
        size += std::abs(multiplier * side);
        for (decltype(proof.matrix)::InnerIterator entry(proof.matrix, i); entry; ++entry) {
            reduced[entry.col()] += multiplier * entry.value();
            reduced_size[entry.col()] += std::abs(multiplier * entry.value());
        }
    }
    constexpr long double rounding = std::numeric_limits<double>::epsilon();
    for (Eigen::Index j = 0; j < variables; ++j) {
        if (reduced_size[j] == 0.0L) continue;
        const long double lower = proof.box.lower[j];
        const long double upper = proof.box.upper[j];
        const long double slack = rounding * reduced_size[j];
        // The reduced cost is known to ± slack: take the worse end of both.
        for (const long double cost : {reduced[j] - slack, reduced[j] + slack}) {
            const long double at = cost > 0.0L ? lower : upper;
            if (cost != 0.0L && !std::isfinite(at)) return -infinity;
        }
        const auto least = [&](long double cost) { return cost > 0.0L ? cost * lower : cost * upper; };
        bound += std::min(least(reduced[j] - slack), least(reduced[j] + slack));
    }
    return static_cast<double>(bound - rounding * size);
}

const char* name_of(Reason value) {
    return named_reasons[static_cast<std::size_t>(value)].name;
}

Reason reason_named(std::string_view name) {
    for (const Named& row : named_reasons)
        if (name == row.name) return row.reason;
    std::string allowed;
    for (const Named& row : named_reasons)
        if (row.reason != Reason::none) append_item(allowed, in_quotes(row.name));
    throw InputError(fmt::format("reason: found \"{}\"; allowed: {}", name, allowed));
}

Reason reason_of(Termination termination) {
    return reason_named(name_of(termination));
}

std::ostream& operator<<(std::ostream& stream, Reason value) {
    return stream << name_of(value);
}

}  // namespace camopt
