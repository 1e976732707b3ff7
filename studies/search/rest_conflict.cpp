// SPDX-License-Identifier: MIT
#include "studies/search/rest_conflict.hpp"

#include "core/units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

bool speaks_of_rest(const PlacedRule& rule) {
    return rule->limit() && rule->parameters().empty() && rule->highest_order() <= 1 && rule.stretch == -1 &&
           rule->curvature(-infinity, infinity) == Curvature::general;
}

bool holds_at(const PointRule& rule, double x) {
    return rule.places().empty() || std::ranges::binary_search(rule.places(), x);
}

}  // namespace

std::optional<RestConflict> rest_conflict(const CamModel& model, double tolerance) {
    std::optional<RestConflict> worst;
    for (const PlacedRule& rule : model.rules) {
        if (!speaks_of_rest(rule)) continue;
        for (const KnownPoint& known : model.known_points) {
            if (!known.at_rest || !holds_at(*rule, known.x)) continue;
            const double value = rule->evaluate({known.x, {known.y, 0.0, 0.0, 0.0}}, {}).value;
            const double violation = value / rule->scale();
            if (violation > tolerance && (!worst || violation > worst->violation))
                worst = RestConflict{rule->name(), known, violation};
        }
    }
    return worst;
}

namespace {

/// The common violation t is at least that at the place of rest: a problem of one row.
DualityProof proof_of(const RestConflict& conflict) {
    DualityProof proof;
    proof.statement = "least_common_violation";
    proof.variables = {"common violation"};
    proof.cost = Eigen::VectorXd::Ones(1);
    proof.rows = {fmt::format("{} at rest, x = {:.17g}, y = {:.17g}", conflict.key, conflict.where.x,
                              conflict.where.y)};
    proof.origins = {{conflict.key, {}, conflict.where.x, Side::right, true}};
    proof.matrix.resize(1, 1);
    proof.matrix.insert(0, 0) = 1.0;
    proof.lower = Eigen::VectorXd::Constant(1, conflict.violation);
    proof.upper = Eigen::VectorXd::Constant(1, infinity);
    proof.multipliers = Eigen::VectorXd::Constant(1, -1.0);
    proof.box = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 1.0 + conflict.violation)};
    proof.bound = recomputed_bound(proof);
    return proof;
}

}  // namespace

bool report_rest_conflict(Solution& solution, const CamModel& model) {
    const auto worst = rest_conflict(model, solution.scene.solver.tolerance);
    if (!worst) return false;
    solution.certificate.verdict = Verdict::infeasible;
    solution.certificate.reason = Reason::limit_broken_at_rest;
    solution.certificate.proof = proof_of(*worst);
    solution.certificate.proof_kind = ProofKind::duality;
    solution.conflict = {{worst->key, worst->where.x, 1.0, {}}};
    solution.notes.push_back(fmt::format(
        "every motion of this scene rests at {:.6g} deg at displacement {:.6g} (in lifts), and {} is "
        "violated there for every motion",
        worst->where.x * solution.scene.motion.unit_angle() / units::degree, worst->where.y, worst->key));
    return true;
}

}  // namespace camopt
