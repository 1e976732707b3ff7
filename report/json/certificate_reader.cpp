// SPDX-License-Identifier: MIT
#include "report/json/certificate_reader.hpp"

#include "core/text/text_file.hpp"
#include "report/json/json_text.hpp"
#include "solvers/certificate/box_proof.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

double number_or(const Json& json, double missing) {
    return json.is_null() ? missing : json.get<double>();
}

/// Throws InputError where the list does not have `size` entries.
Eigen::VectorXd read_vector(const Json& json, std::size_t size, double missing, const char* name) {
    if (!json.is_array() || json.size() != size)
        throw InputError(fmt::format("{}: expected a list of {} numbers, found {}", name, size, json.size()));
    Eigen::VectorXd values(static_cast<Eigen::Index>(size));
    for (std::size_t i = 0; i < size; ++i) values[static_cast<Eigen::Index>(i)] = number_or(json[i], missing);
    return values;
}

using Triplets = std::vector<Eigen::Triplet<double>>;

void read_row(const Json& row, int index, int columns, Triplets& entries) {
    const auto indices = row.at("indices").get<std::vector<int>>();
    const auto values = row.at("values").get<std::vector<double>>();
    if (indices.size() != values.size())
        throw InputError(
            fmt::format("row {}: {} indices, but {} values", index, indices.size(), values.size()));
    for (std::size_t k = 0; k < indices.size(); ++k) {
        if (indices[k] < 0 || indices[k] >= columns)
            throw InputError(
                fmt::format("row {}: index {}, allowed 0 to {}", index, indices[k], columns - 1));
        entries.emplace_back(index, indices[k], values[k]);
    }
}

RowOrigin read_origin(const Json& json) {
    RowOrigin origin;
    origin.rule = json.at("rule").get<std::string>();
    origin.limit = json.at("limit").get<bool>();
    origin.remark = json.value("remark", std::string());
    if (json.contains("at")) origin.at = json.at("at").get<double>();
    if (json.value("side", std::string("right")) == "left") origin.side = Side::left;
    if (json.contains("order")) origin.order = json.at("order").get<int>();
    origin.sign = json.value("sign", 0);
    return origin;
}

void read_rows(const Json& rows, DualityProof& proof) {
    const auto count = static_cast<Eigen::Index>(rows.size());
    const int columns = static_cast<int>(proof.variables.size());
    proof.lower.resize(count);
    proof.upper.resize(count);
    proof.multipliers.resize(count);
    Triplets entries;
    for (Eigen::Index i = 0; i < count; ++i) {
        const Json& row = rows.at(static_cast<std::size_t>(i));
        proof.rows.push_back(row.at("name").get<std::string>());
        proof.origins.push_back(read_origin(row.at("origin")));
        proof.lower[i] = number_or(row.at("lower"), -infinity);
        proof.upper[i] = number_or(row.at("upper"), infinity);
        proof.multipliers[i] = row.at("multiplier").get<double>();
        read_row(row, static_cast<int>(i), columns, entries);
    }
    proof.matrix.resize(count, columns);
    proof.matrix.setFromTriplets(entries.begin(), entries.end());
}

DualityProof read_proof(const Json& json) {
    DualityProof proof;
    proof.statement = json.at("statement").get<std::string>();
    proof.variables = json.at("variables").get<std::vector<std::string>>();
    const std::size_t variables = proof.variables.size();
    proof.cost = read_vector(json.at("cost"), variables, infinity, "cost");
    proof.constant = json.at("constant").get<double>();
    read_rows(json.at("rows"), proof);
    proof.box.lower = read_vector(json.at("box").at("lower"), variables, -infinity, "box.lower");
    proof.box.upper = read_vector(json.at("box").at("upper"), variables, infinity, "box.upper");
    proof.bound = number_or(json.at("bound"), -infinity);
    proof.limits_relaxed_by = json.value("limits_relaxed_by", 0.0);
    return proof;
}

std::optional<double> optional_number(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

template <class Choice>
Choice choice_of(const Json& json, std::initializer_list<Choice> choices) {
    if (json.is_string())
        if (const auto choice = choice_named(json.get<std::string>(), choices)) return *choice;
    throw InputError(fmt::format("found {}; allowed: a name that camopt gives", json.dump()));
}

/// Proofs that cases share stand in the first of them.
std::vector<CaseProof> read_cases(const Json& json) {
    std::vector<CaseProof> cases;
    if (json.is_null()) return cases;
    for (const Json& one : json) {
        CaseProof part;
        part.region = one.at("region").get<std::vector<std::string>>();
        part.infeasible = one.at("infeasible").get<bool>();
        part.bound = number_or(one.at("bound"), infinity);
        const Json& proof_of = one.at("proof_of_case");
        if (!one.at("proof").is_null()) {
            part.proof = std::make_shared<const DualityProof>(read_proof(one.at("proof")));
        } else if (!proof_of.is_null()) {
            const auto index = proof_of.get<std::size_t>();
            if (index >= cases.size())
                throw InputError(fmt::format("proof_of_case: found {}; allowed: a case before it", index));
            part.proof = cases[index].proof;
        }
        cases.push_back(std::move(part));
    }
    return cases;
}

std::vector<std::pair<int, double>> read_multipliers(const Json& json) {
    std::vector<std::pair<int, double>> multipliers;
    for (const Json& one : json) multipliers.emplace_back(one.at(0).get<int>(), one.at(1).get<double>());
    return multipliers;
}

BoxStep read_step(const Json& json, std::size_t variables) {
    using enum BoxStep::Kind;
    BoxStep step;
    step.kind = choice_of(json.at("kind"), {linear, cost, plane, derived, split});
    step.weights = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(variables));
    const Json& indices = json.at("indices");
    const Eigen::VectorXd values = read_vector(json.at("values"), indices.size(), infinity, "values");
    for (std::size_t k = 0; k < indices.size(); ++k) {
        const auto at = indices.at(k).get<std::size_t>();
        if (at >= variables)
            throw InputError(fmt::format("indices: found {}; allowed: below {}", at, variables));
        step.weights[static_cast<Eigen::Index>(at)] = values[static_cast<Eigen::Index>(k)];
    }
    step.side = json.at("side").get<double>();
    if (json.contains("origin")) step.origin = read_origin(json.at("origin"));
    if (step.kind == derived) {
        step.multipliers = read_multipliers(json.at("multipliers"));
        step.bounds = json.at("bounds").get<std::vector<int>>();
    }
    if (step.kind != plane) return step;
    step.ends = json.at("ends").get<std::vector<std::array<int, 2>>>();
    const std::size_t numbers = step.ends.size();
    const Eigen::VectorXd lower = read_vector(json.at("box").at("lower"), numbers, -infinity, "box.lower");
    const Eigen::VectorXd upper = read_vector(json.at("box").at("upper"), numbers, infinity, "box.upper");
    for (Eigen::Index i = 0; i < lower.size(); ++i) step.box.emplace_back(lower[i], upper[i]);
    step.slope = read_vector(json.at("slope"), numbers, infinity, "slope");
    step.constant = json.at("constant").get<double>();
    return step;
}

std::shared_ptr<const BoxProof> read_box_proof(const Json& json) {
    auto proof = std::make_shared<BoxProof>();
    proof->variables = json.at("variables").get<std::vector<std::string>>();
    const std::size_t variables = proof->variables.size();
    proof->cost = read_vector(json.at("cost"), variables, infinity, "cost");
    proof->constant = json.at("constant").get<double>();
    proof->box.lower = read_vector(json.at("box").at("lower"), variables, -infinity, "box.lower");
    proof->box.upper = read_vector(json.at("box").at("upper"), variables, infinity, "box.upper");
    for (const Json& step : json.at("steps")) proof->steps.push_back(read_step(step, variables));
    for (const Json& one : json.at("parts")) {
        BoxPart part;
        part.splits = one.at("splits").get<std::vector<int>>();
        part.infeasible = one.at("infeasible").get<bool>();
        part.bound = number_or(one.at("bound"), infinity);
        part.multipliers = read_multipliers(one.at("multipliers"));
        part.bounds = one.at("bounds").get<std::vector<int>>();
        proof->parts.push_back(std::move(part));
    }
    proof->bound = number_or(json.at("bound"), infinity);
    return proof;
}

Certificate certificate_of(const Json& json) {
    using enum Verdict;
    Certificate certificate;
    certificate.verdict = choice_of(json.at("verdict"), {optimal, local, feasible, infeasible, failed});
    if (!json.at("reason").is_null()) certificate.reason = reason_named(json.at("reason").get<std::string>());
    certificate.objective = number_or(json.at("objective"), infinity);
    certificate.lower_bound = optional_number(json.at("lower_bound"));
    certificate.gap = optional_number(json.at("gap"));
    certificate.worst_violation = number_or(json.at("worst_violation"), infinity);
    certificate.stationarity = optional_number(json.at("stationarity"));
    certificate.verified = json.at("verified").get<std::vector<std::string>>();
    certificate.unverified = json.at("unverified").get<std::vector<std::string>>();
    certificate.proof_kind = choice_of(json.at("proof_kind"), {ProofKind::none, ProofKind::duality,
                                                               ProofKind::any_curve_limit, ProofKind::boxes});
    if (!json.at("proof").is_null()) certificate.proof = read_proof(json.at("proof"));
    certificate.cases = read_cases(json.at("cases"));
    if (json.contains("boxes")) certificate.box_proof = read_box_proof(json.at("boxes"));
    return certificate;
}

template <class Read>
auto read_text(std::string_view text, std::string_view name, const Read& read) {
    try {
        return read(Json::parse(text));
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: not a certificate of camopt: {}", name, error.what()));
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    }
}

}  // namespace

Certificate read_whole_certificate(const std::filesystem::path& path) {
    return certificate_of_text(read_text_file(path), path.string());
}

Certificate certificate_of_text(std::string_view json, std::string_view name) {
    return read_text(json, name, certificate_of);
}

DualityProof read_certificate(const std::filesystem::path& path) {
    return read_text(read_text_file(path), path.string(), [](const Json& json) {
        const Json& proof = json.at("proof");
        if (proof.is_null()) throw InputError("the certificate holds no proof");
        return read_proof(proof);
    });
}

}  // namespace camopt
