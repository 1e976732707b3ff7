// SPDX-License-Identifier: MIT
#include "output/json/certificate_json.hpp"

#include "core/version.hpp"
#include "output/json/json_text.hpp"

#include <map>
#include <vector>

namespace camopt {

namespace {

/// What is not said is as in a RowOrigin of its own: no remark, the side above x.
Json origin_json(const RowOrigin& origin) {
    Json json = {{"rule", origin.rule}, {"limit", origin.limit}};
    if (!origin.remark.empty()) json["remark"] = origin.remark;
    if (origin.at) json["at"] = number_json(*origin.at);
    if (origin.side == Side::left) json["side"] = "left";
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
        rows.push_back({{"name", proof.rows[place]},
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
        const CaseProof& part = cases[static_cast<std::size_t>(i)];
        const auto [known, fresh] = written.try_emplace(part.proof.get(), i);
        list.push_back({{"region", part.region},
                        {"infeasible", part.infeasible},
                        {"bound", part.infeasible ? Json(nullptr) : number_json(part.bound)},
                        {"proof_of_case", part.proof ? Json(known->second) : Json(nullptr)},
                        {"proof", part.proof && fresh ? proof_json(*part.proof) : Json(nullptr)}});
    }
    return list;
}

}  // namespace

std::string_view how_to_check() {
    return "The problem: minimize constant + sum_j cost[j] x[j] over lower <= sum_k values[k] "
           "x[indices[k]] <= upper for every row, with x in the box, which is known to hold a best "
           "point. Weak duality, with the multipliers m: let b_i be the row's upper side where m_i > 0 "
           "and its lower side where m_i < 0, and r[j] = cost[j] + sum_i m_i G_ij, where G_ij are the "
           "rows' values. Then no point of the problem has less than constant - sum_i m_i b_i + sum_j "
           "min(r[j] box.lower[j], r[j] box.upper[j]). This number must not be less than \"bound\" (up "
           "to the rounding of your own sum). Any multipliers give a true bound, so nothing has to be "
           "believed of the solver. Statement \"objective\": no curve of this kind has a smaller "
           "objective than the bound; where \"limits_relaxed_by\" is above 0, the rows of limits stand moved "
           "out by that part of their size, and the bound is of every curve that keeps the limits to within "
           "it. Statement \"least_common_violation\": every curve of this kind "
           "violates some limit by at least the bound, so a bound above 0 proves that the scene is "
           "infeasible. Statement \"conditions\": the rows are conditions that contradict each other; a "
           "bound above 0 proves that no curve of this kind meets them all. null: the side is open "
           "(infinite). \"cases\": where displacements are free, the cases together hold all that they may "
           "be, each has its bound, proved by the problem of the case that \"proof_of_case\" counts (from "
           "0), and the least of the bounds is that of the whole. A case may rest on the proof of a larger "
           "one, or, where a segment between dwells moves in it, on that of the single rise in the same "
           "spline space, whose peaks no such segment can pass below.";
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
    json["proof_kind"] = name_of(certificate.proof_kind);
    json["how_to_check"] = how_to_check();
    json["proof"] = certificate.proof ? proof_json(*certificate.proof) : Json(nullptr);
    json["cases"] = cases_json(certificate.cases);
    return json_text(json);
}

}  // namespace camopt
