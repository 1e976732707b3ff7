// SPDX-License-Identifier: MIT
#include "report/json/certificate_json.hpp"

#include "core/text/text_file.hpp"
#include "core/version.hpp"
#include "report/json/json_fields.hpp"
#include "solvers/certificate/box_proof.hpp"

#include <fmt/format.h>

namespace camopt {

template <>
inline constexpr BoxStep::Kind last_of<BoxStep::Kind> = BoxStep::Kind::split;

namespace {

/// 2: rows and cases have fields beside their words.
constexpr int certificate_format = 2;

/// What is not 0.
struct SparseVector {
    std::vector<int> indices;
    std::vector<double> values;
};

void fields(const JsonFields& json, SparseVector& sparse) {
    json("indices", sparse.indices);
    json("values", sparse.values);
    json.check("values", sparse.values.size() == sparse.indices.size(), "as many numbers as indices");
}

void check_indices(const std::vector<int>& indices, std::size_t variables, const JsonFields& json) {
    for (const int index : indices)
        if (index < 0 || static_cast<std::size_t>(index) >= variables)
            json.at("indices").fail(fmt::format("found {}; allowed: 0 or more, below {}", index, variables));
}

/// An object of numbers, left out where there are none.
void named_numbers(const JsonFields& json, const std::string& key, std::map<std::string, double>& numbers) {
    if (!json.reads()) {
        if (numbers.empty()) return;
        const JsonFields own = json.at(key);
        for (auto& [name, number] : numbers) own(name, number);
        return;
    }
    numbers.clear();
    if (!json.has(key)) return;
    for (const auto& [name, number] : json.at(key).members()) numbers[name] = number.as<double>();
}

/// A row of a proof as the file has it.
struct ProofRow {
    std::string name;
    RowOrigin origin;
    SparseVector entries;
    double lower = 0.0, upper = 0.0, multiplier = 0.0;
};

void fields(const JsonFields& json, ProofRow& row) {
    json("name", row.name);
    json("origin", row.origin);
    fields(json, row.entries);
    json("lower", row.lower, -infinity);
    json("upper", row.upper, infinity);
    json("multiplier", row.multiplier);
}

std::vector<ProofRow> proof_rows(const DualityProof& proof) {
    std::vector<ProofRow> rows(static_cast<std::size_t>(proof.matrix.rows()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(i);
        rows[i] = {row_name(proof, i), proof.origins[i], {},
                   proof.lower[at],    proof.upper[at],  proof.multipliers[at]};
        for (decltype(proof.matrix)::InnerIterator entry(proof.matrix, at); entry; ++entry) {
            rows[i].entries.indices.push_back(static_cast<int>(entry.col()));
            rows[i].entries.values.push_back(entry.value());
        }
    }
    return rows;
}

void take_rows(DualityProof& proof, const std::vector<ProofRow>& rows, const JsonFields& json) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    for (Eigen::VectorXd* side : {&proof.lower, &proof.upper, &proof.multipliers}) side->resize(count);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const ProofRow& row = rows[i];
        const auto at = static_cast<Eigen::Index>(i);
        proof.rows.push_back(row.name);
        proof.origins.push_back(row.origin);
        proof.lower[at] = row.lower;
        proof.upper[at] = row.upper;
        proof.multipliers[at] = row.multiplier;
        const auto& [indices, values] = row.entries;
        check_indices(indices, proof.variables.size(), json.at(i));
        for (std::size_t k = 0; k < indices.size(); ++k)
            entries.emplace_back(static_cast<int>(i), indices[k], values[k]);
    }
    proof.matrix.resize(count, static_cast<Eigen::Index>(proof.variables.size()));
    proof.matrix.setFromTriplets(entries.begin(), entries.end());
}

/// A case as the file has it: a proof that several share is in the first of them, and the others name it.
struct ProofCase {
    CaseProof part;
    std::optional<int> proof_of_case;
};

void fields(const JsonFields& json, ProofCase& one) {
    json("region", one.part.region);
    json.unless("parts", one.part.parts, std::vector<CasePart>{});
    json("infeasible", one.part.infeasible);
    json("bound", one.part.bound, infinity);
    json("proof_of_case", one.proof_of_case);
    json("proof", one.part.proof);
}

std::optional<std::vector<ProofCase>> proof_cases(const Certificate& certificate) {
    if (certificate.cases.empty()) return {};
    std::map<const DualityProof*, int> known;
    std::vector<ProofCase> cases;
    for (const CaseProof& part : certificate.cases) {
        ProofCase& one = cases.emplace_back(ProofCase{part, {}});
        if (part.infeasible) one.part.bound = infinity;
        if (!part.proof) continue;
        const auto [first, fresh] = known.try_emplace(part.proof.get(), static_cast<int>(cases.size()) - 1);
        one.proof_of_case = first->second;
        if (!fresh) one.part.proof = nullptr;
    }
    return cases;
}

void take_cases(Certificate& certificate, const std::vector<ProofCase>& cases, const JsonFields& json) {
    for (const ProofCase& one : cases) {
        const std::size_t number = certificate.cases.size();
        CaseProof& part = certificate.cases.emplace_back(one.part);
        if (part.proof || !one.proof_of_case) continue;
        const auto first = static_cast<std::size_t>(*one.proof_of_case);  // below 0: a large number
        json.at(number).check("proof_of_case", first < number, "a case before it");
        part.proof = certificate.cases[first].proof;
    }
}

SparseVector weights_of(const BoxStep& step) {
    SparseVector sparse;
    for (Eigen::Index j = 0; j < step.weights.size(); ++j) {
        if (step.weights[j] == 0.0) continue;
        sparse.indices.push_back(static_cast<int>(j));
        sparse.values.push_back(step.weights[j]);
    }
    return sparse;
}

void take_weights(BoxStep& step, const SparseVector& sparse, std::size_t variables, const JsonFields& json) {
    check_indices(sparse.indices, variables, json);
    step.weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(variables));
    for (std::size_t k = 0; k < sparse.indices.size(); ++k)
        step.weights[sparse.indices[k]] = sparse.values[k];
}

Box box_of(const BoxStep& step) {
    const auto size = static_cast<Eigen::Index>(step.box.size());
    Box box{Eigen::VectorXd(size), Eigen::VectorXd(size)};
    for (Eigen::Index i = 0; i < size; ++i) {
        box.lower[i] = step.box[static_cast<std::size_t>(i)].lower;
        box.upper[i] = step.box[static_cast<std::size_t>(i)].upper;
    }
    return box;
}

void take_box(BoxStep& step, const Box& box, const JsonFields& json) {
    json.check("upper", box.upper.size() == box.lower.size(), "as many numbers as lower");
    for (Eigen::Index i = 0; i < box.lower.size(); ++i) step.box.emplace_back(box.lower[i], box.upper[i]);
}

}  // namespace

static void fields(const JsonFields& json, Box& box, std::optional<std::size_t> variables = {}) {
    json.numbers("lower", box.lower, variables, -infinity);
    json.numbers("upper", box.upper, variables, infinity);
}

static void fields(const JsonFields& json, CasePart& part) {
    json.count("segment", part.segment);
    json.unless("rises", part.rises, std::nullopt);
    json.unless("angle_deg", part.angle_deg, std::nullopt);
}

/// What is left out is as in a new RowOrigin: no remark, the side above x, one side. `rule` and `remark` are
/// words for people, all other keys fields for programs.
static void fields(const JsonFields& json, RowOrigin& origin) {
    json("rule", origin.rule);
    json("limit", origin.limit);
    json.unless("remark", origin.remark, "");
    json.unless("axis", origin.fields.axis, "");
    json.unless("key", origin.fields.key, "");
    json.unless("part", origin.fields.part, "");
    named_numbers(json, "which", origin.fields.which);
    named_numbers(json, "made", origin.fields.made);
    json.unless("at", origin.at, std::nullopt);
    json.unless("side", origin.side, Side::right);
    json.unless("order", origin.order, std::nullopt);
    json.unless("sign", origin.sign, 0);
}

static void fields(const JsonFields& json, DualityProof& proof) {
    json("statement", proof.statement);
    json("variables", proof.variables);
    const std::size_t variables = proof.variables.size();
    json.numbers("cost", proof.cost, variables, infinity);
    json("constant", proof.constant);
    std::vector<ProofRow> rows = proof_rows(proof);
    json("rows", rows);
    if (json.reads()) take_rows(proof, rows, json.at("rows"));
    fields(json.at("box"), proof.box, variables);
    json("bound", proof.bound, -infinity);
    json("limits_relaxed_by", proof.limits_relaxed_by);
}

static void fields(const JsonFields& json, BoxStep& step, std::size_t variables) {
    using enum BoxStep::Kind;
    SparseVector weights = weights_of(step);
    fields(json, weights);
    if (json.reads()) take_weights(step, weights, variables, json);
    json("kind", step.kind);
    json("side", step.side);
    if (step.kind == linear || step.kind == plane) json("origin", step.origin);
    if (step.kind == derived) {
        json("multipliers", step.multipliers);
        json("bounds", step.bounds);
    }
    if (step.kind != plane) return;
    Box box = box_of(step);
    json("box", box);
    if (json.reads()) take_box(step, box, json.at("box"));
    json("ends", step.ends);
    json.check("ends", step.ends.size() == step.box.size(), "one for each number of a side of the box");
    json.numbers("slope", step.slope, step.box.size(), infinity);
    json("constant", step.constant);
}

static void fields(const JsonFields& json, BoxPart& part) {
    json("splits", part.splits);
    json("infeasible", part.infeasible);
    json("bound", part.bound, infinity);
    json("multipliers", part.multipliers);
    json("bounds", part.bounds);
}

static void fields(const JsonFields& json, BoxProof& proof) {
    json("variables", proof.variables);
    const std::size_t variables = proof.variables.size();
    json.numbers("cost", proof.cost, variables, infinity);
    json("constant", proof.constant);
    fields(json.at("box"), proof.box, variables);
    json.each("steps", proof.steps,
              [&](const JsonFields& one, BoxStep& step) { fields(one, step, variables); });
    json("parts", proof.parts);
    json("bound", proof.bound, infinity);
}

static void fields(const JsonFields& json, Certificate& certificate) {
    json.shown("camopt", version());
    json.shown("format", certificate_format);
    json("verdict", certificate.verdict);
    json("reason", certificate.reason);
    json("objective", certificate.objective, infinity);
    json("lower_bound", certificate.lower_bound);
    json("gap", certificate.gap);
    json("worst_violation", certificate.worst_violation, infinity);
    json("stationarity", certificate.stationarity);
    json("verified", certificate.verified);
    json("unverified", certificate.unverified);
    json("proof_kind", certificate.proof_kind);
    json.shown("how_to_check", how_to_check());
    json("proof", certificate.proof);
    std::optional<std::vector<ProofCase>> cases = proof_cases(certificate);
    json("cases", cases);
    if (json.reads() && cases) take_cases(certificate, *cases, json.at("cases"));
    json.unless("boxes", certificate.box_proof, nullptr);
}

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
    return json_text(written(certificate));
}

Certificate certificate_of_text(std::string_view json, std::string_view name) {
    return JsonFields(json, name, "a certificate").as<Certificate>();
}

Certificate read_whole_certificate(const std::filesystem::path& path) {
    return certificate_of_text(read_text_file(path), path.string());
}

DualityProof read_certificate(const std::filesystem::path& path) {
    const JsonFields stored = JsonFields(read_text_file(path), path.string(), "a certificate").at("proof");
    if (stored.is_null()) stored.fail("the certificate holds no proof");
    return stored.as<DualityProof>();
}

}  // namespace camopt
