// SPDX-License-Identifier: MIT
#include "studies/search/contradiction.hpp"

#include "objectives/scene_model.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

// In lifts: a control point of a motion lies within a few.
constexpr double farthest_control_point = 1e3;
// So many times the segments have freedom enough for whatever can be met at all; beyond a thousand there is
// no want of it.
constexpr int plenty = 16, most_conflict_segments = 1024;

int plenty_of(int segments) {
    return std::max(segments, std::min(plenty * segments, most_conflict_segments));
}

/// Weak duality for a cost of zero: the rows of a contradiction add up to 0 >= bound > 0. The box only
/// absorbs the rounding of that sum; it leaves out no curve a cam could follow.
DualityProof contradiction_proof(const ConditionConflict& conflict, int control_points) {
    DualityProof proof;
    proof.statement = "conditions";
    proof.cost = Eigen::VectorXd::Zero(control_points);
    proof.box = {Eigen::VectorXd::Constant(control_points, -farthest_control_point),
                 Eigen::VectorXd::Constant(control_points, farthest_control_point)};
    for (int j = 0; j < control_points; ++j)
        proof.variables.push_back(fmt::format("free control point {}", j));
    const auto rows = static_cast<Eigen::Index>(conflict.rows.size());
    proof.matrix.resize(rows, control_points);
    proof.lower.resize(rows);
    proof.multipliers.resize(rows);
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index i = 0; i < rows; ++i) {
        const ConflictRow& row = conflict.rows[static_cast<std::size_t>(i)];
        proof.rows.push_back(row.name);
        proof.origins.push_back({row.name, {}, {}, Side::right, false});
        proof.lower[i] = -row.row.offset;
        proof.multipliers[i] = row.multiplier;
        for (std::size_t k = 0; k < row.row.columns.size(); ++k) {
            entries.emplace_back(i, row.row.columns[k], row.row.weights[k]);
        }
    }
    proof.upper = proof.lower;
    proof.matrix.setFromTriplets(entries.begin(), entries.end());
    proof.bound = recomputed_bound(proof);
    return proof;
}

}  // namespace

std::string list_of(const ConditionConflict& conflict) {
    return fmt::format("{}", fmt::join(conflict.others, "; "));
}

void report_contradictions(Solution& solution, const MotionFamily& family) {
    int run = 0;
    while (family.run(run).contradictions().empty()) ++run;
    const DesignVector& design = family.run(run);
    solution.certificate.verdict = Verdict::infeasible;
    solution.certificate.reason = Reason::conditions_contradict;
    solution.certificate.proof =
        contradiction_proof(design.contradictions().front(), design.space().dimension());
    solution.certificate.proof_kind = ProofKind::duality;
    // Conditions that no spline can meet together are not a matter of freedom.
    const bool freedom =
        scene_family(with_segments(solution.scene, plenty_of(segments_of(solution.scene.spline))),
                     DesignKind::states)
            .contradictions()
            .empty();
    for (const ConditionConflict& conflict : design.contradictions()) {
        std::string note =
            conflict.others.empty() && !freedom
                ? fmt::format(
                      "{} contradicts the conditions at the ends of the motion, at its top or where its "
                      "segments join; more segments were tried without success: change it",
                      conflict.condition)
            : conflict.others.empty()
                ? fmt::format(
                      "degree {} with {} segments leaves too little freedom to meet the conditions at both "
                      "ends: give the spline more segments",
                      design.space().degree(), design.space().segments())
                : fmt::format("{} contradicts {}; {}", conflict.condition, list_of(conflict),
                              freedom
                                  ? "the spline has too little freedom to meet all of them: change one, or "
                                    "give it more segments"
                                  : "more segments were tried and do not help: change one");
        // A region is several conditions with one name.
        if (std::ranges::find(solution.notes, note) == solution.notes.end())
            solution.notes.push_back(std::move(note));
    }
}

}  // namespace camopt
