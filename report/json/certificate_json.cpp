// SPDX-License-Identifier: MIT
#include "report/json/certificate_json.hpp"

#include "core/version.hpp"
#include "report/json/json_text.hpp"
#include "solvers/certificate/box_proof.hpp"

namespace camopt {

namespace {

/// What is not said is as in its own RowOrigin: no remark, the side above x, one side.
Json origin_json(const RowOrigin& origin) {
    Json json = {{"rule", origin.rule}, {"limit", origin.limit}};
    if (!origin.remark.empty()) json["remark"] = origin.remark;
    if (origin.at) json["at"] = number_json(*origin.at);
    if (origin.side == Side::left) json["side"] = "left";
    if (origin.order) json["order"] = *origin.order;
    if (origin.sign != 0) json["sign"] = origin.sign;
    return json;
}

Json proof_json(const DualityProof& proof) {
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < proof.matrix.rows(); ++i) {
        std::vector<int> indices;
        std::vector<double> values;
        for (decltype(proof.matrix)::InnerIterator entry(proof.matrix, i); entry; ++entry) {
            indices.push_back(static_cast<int>(entry.col()));
            values.push_back(entry.value());
        }
        const auto place = static_cast<std::size_t>(i);
        rows.push_back({{"name", row_name(proof, place)},
                        {"origin", origin_json(proof.origins[place])},
                        {"indices", indices},
                        {"values", numbers_json(values)},
                        {"lower", number_json(proof.lower[i])},
                        {"upper", number_json(proof.upper[i])},
                        {"multiplier", number_json(proof.multipliers[i])}});
    }
    return {{"statement", proof.statement},
            {"variables", proof.variables},
            {"cost", numbers_json(proof.cost)},
            {"constant", number_json(proof.constant)},
            {"rows", rows},
            {"box", {{"lower", numbers_json(proof.box.lower)}, {"upper", numbers_json(proof.box.upper)}}},
            {"bound", number_json(proof.bound)},
            {"limits_relaxed_by", number_json(proof.limits_relaxed_by)}};
}

/// Proofs that several cases share stand in the first; the others name it.
Json cases_json(const std::vector<CaseProof>& cases) {
    if (cases.empty()) return nullptr;
    std::map<const DualityProof*, int> written;
    Json list = Json::array();
    for (int i = 0; i < static_cast<int>(cases.size()); ++i) {
        const CaseProof& part = cases[i];
        const auto [known, fresh] = written.try_emplace(part.proof.get(), i);
        list.push_back({{"region", part.region},
                        {"infeasible", part.infeasible},
                        {"bound", part.infeasible ? Json(nullptr) : number_json(part.bound)},
                        {"proof_of_case", part.proof ? Json(known->second) : Json(nullptr)},
                        {"proof", part.proof && fresh ? proof_json(*part.proof) : Json(nullptr)}});
    }
    return list;
}

/// Only what is not 0.
Json sparse_json(const Eigen::VectorXd& values) {
    std::vector<Eigen::Index> indices;
    std::vector<double> kept;
    for (Eigen::Index j = 0; j < values.size(); ++j) {
        if (values[j] == 0.0) continue;
        indices.push_back(j);
        kept.push_back(values[j]);
    }
    return {{"indices", indices}, {"values", numbers_json(kept)}};
}

Json multipliers_json(const std::vector<std::pair<int, double>>& multipliers) {
    Json list = Json::array();
    for (const auto& [step, multiplier] : multipliers) list.push_back({step, number_json(multiplier)});
    return list;
}

Json step_json(const BoxStep& step) {
    Json json = sparse_json(step.weights);
    json["kind"] = name_of(step.kind);
    json["side"] = number_json(step.side);
    if (step.kind == BoxStep::Kind::linear || step.kind == BoxStep::Kind::plane)
        json["origin"] = origin_json(step.origin);
    if (step.kind == BoxStep::Kind::derived) {
        json["multipliers"] = multipliers_json(step.multipliers);
        json["bounds"] = step.bounds;
    }
    if (step.kind == BoxStep::Kind::plane) {
        Json lower = Json::array(), upper = Json::array();
        for (const Interval& number : step.box) {
            lower.push_back(number_json(number.lower));
            upper.push_back(number_json(number.upper));
        }
        json["box"] = {{"lower", lower}, {"upper", upper}};
        json["ends"] = step.ends;
        json["slope"] = numbers_json(step.slope);
        json["constant"] = number_json(step.constant);
    }
    return json;
}

Json box_proof_json(const BoxProof& proof) {
    Json steps = Json::array(), parts = Json::array();
    for (const BoxStep& step : proof.steps) steps.push_back(step_json(step));
    for (const BoxPart& part : proof.parts)
        parts.push_back({{"splits", part.splits},
                         {"infeasible", part.infeasible},
                         {"bound", part.infeasible ? Json(nullptr) : number_json(part.bound)},
                         {"multipliers", multipliers_json(part.multipliers)},
                         {"bounds", part.bounds}});
    return {{"variables", proof.variables},
            {"cost", numbers_json(proof.cost)},
            {"constant", number_json(proof.constant)},
            {"box", {{"lower", numbers_json(proof.box.lower)}, {"upper", numbers_json(proof.box.upper)}}},
            {"steps", steps},
            {"parts", parts},
            {"bound", number_json(proof.bound)}};
}

}  // namespace

std::string_view how_to_check() {
    return "The problem: minimize constant + sum_j cost[j] x[j] over lower <= sum_k values[k] "
           "x[indices[k]] <= upper for every row, with x in the box, which is known to hold a best "
           "point. Weak duality, with the multipliers m: let b_i be the row's upper side where m_i > 0 "
           "and its lower side where m_i < 0, and r[j] = cost[j] + sum_i m_i G_ij, where G_ij are the "
           "rows' values. Then no point of the problem has less than constant - sum_i m_i b_i + sum_j "
           "min(r[j] box.lower[j], r[j] box.upper[j]). This number must not be less than \"bound\" (up "
           "to the rounding of your own sum). Any multipliers give a true bound, so the solver need "
           "not be trusted. Statement \"objective\": no curve of this kind has a smaller "
           "objective than the bound; where \"limits_relaxed_by\" is above 0, the rows of limits are moved "
           "out by that part of their size, and the bound holds for every curve that satisfies the limits to "
           "within "
           "it. Statement \"least_common_violation\": every curve of this kind "
           "violates some limit by at least the bound, so a bound above 0 proves that the scene is "
           "infeasible. Statement \"conditions\": the rows are conditions that contradict each other; a "
           "bound above 0 proves that no curve of this kind meets them all. null: the side is open "
           "(infinite). \"cases\": where displacements are free, the cases together cover all that they may "
           "be, each has its bound, proved by the problem of the case that \"proof_of_case\" counts (from "
           "0), and the least of the bounds is that of the whole. A case may rest on the proof of a larger "
           "one, or, where a segment between dwells moves in it, on that of the single rise in the same "
           "spline space, whose peaks are lower bounds for such a segment. \"boxes\": a list of inequalities "
           "sum_k "
           "values[k] x[indices[k]] <= side, of kinds \"linear\" (a row of the scene), \"cost\" (no worse "
           "than "
           "the current motion), \"plane\" (slope . z + constant <= 0 with z = (y, y', y'', y\'\'\', "
           "parameters "
           "of the rule): slope . z + constant lies below a positive multiple of the rule wherever z lies in "
           "the step's box, whose ends are the steps that \"ends\" names, -1: what the box of x says), "
           "\"derived\" (r = weights - sum of multipliers times earlier steps' weights; the side is no less "
           "than the sum of multipliers times their sides plus the greatest r . x over the box and the steps "
           "in \"bounds\", each of which bounds one variable), \"split\" (assumed in one part, its opposite "
           "in another). Each part ends in the same way with -cost . x, or in a contradiction. The parts are "
           "the leaves of a tree of splits and together cover everything; the bound is the least of theirs, "
           "and at most the cost of the current motion.";
}

std::string certificate_json(const Certificate& certificate) {
    Json json;
    json["camopt"] = version();
    json["verdict"] = name_of(certificate.verdict);
    json["reason"] = certificate.reason == Reason::none ? Json(nullptr) : Json(name_of(certificate.reason));
    json["objective"] = number_json(certificate.objective);
    json["lower_bound"] = number_json(certificate.lower_bound);
    json["gap"] = number_json(certificate.gap);
    json["worst_violation"] = number_json(certificate.worst_violation);
    json["stationarity"] = number_json(certificate.stationarity);
    json["verified"] = certificate.verified;
    json["unverified"] = certificate.unverified;
    json["proof_kind"] = name_of(certificate.proof_kind);
    json["how_to_check"] = how_to_check();
    json["proof"] = certificate.proof ? proof_json(*certificate.proof) : Json(nullptr);
    json["cases"] = cases_json(certificate.cases);
    if (certificate.box_proof) json["boxes"] = box_proof_json(*certificate.box_proof);
    return json_text(json);
}

}  // namespace camopt
