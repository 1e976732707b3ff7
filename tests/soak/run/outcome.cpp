// SPDX-License-Identifier: MIT
#include "tests/soak/run/outcome.hpp"

#include "input/loading/load_scene.hpp"
#include "report/json/certificate_json.hpp"
#include "report/json/result_json.hpp"
#include "studies/search/planned_solve.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <ctime>
#include <exception>
#include <numbers>

namespace camopt::soak {

namespace {

using nlohmann::json;

constexpr double degree = std::numbers::pi / 180.0;

std::optional<double> number_of(const json& value) {
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::string text_of(const json& value) {
    return value.is_string() ? value.get<std::string>() : "";
}

std::vector<double> list_of(const json& values) {
    std::vector<double> list;
    for (const json& value : values) list.push_back(value.get<double>());
    return list;
}

std::vector<std::optional<double>> open_list_of(const json& values) {
    std::vector<std::optional<double>> list;
    for (const json& value : values) list.push_back(number_of(value));
    return list;
}

std::optional<PublishedSpline> spline_of(const json& value) {
    if (value.is_null()) return std::nullopt;
    return PublishedSpline{value.at("degree"),
                           value.at("continuity"),
                           list_of(value.at("breakpoints")),
                           list_of(value.at("knots")),
                           list_of(value.at("coefficients")),
                           {}};
}

/// Numbers, and the values of extremes, under "name" or "prefix.name".
void collect(const json& object, const std::string& prefix, std::map<std::string, double>& into) {
    if (!object.is_object()) return;
    for (const auto& [name, value] : object.items()) {
        if (const auto number = number_of(value)) into[prefix + name] = *number;
        if (value.is_object() && value.contains("value")) {
            if (const auto number = number_of(value["value"])) into[prefix + name] = *number;
        } else if (value.is_object()) {
            collect(value, prefix + name + ".", into);
        }
    }
}

void read_segments(const json& list, Outcome& outcome) {
    if (!list.is_array()) return;
    for (const json& item : list) {
        PublishedSegment segment;
        segment.kind = text_of(item.at("kind"));
        segment.law = text_of(item.at("law"));
        segment.start = item.at("start_deg").get<double>() * degree;
        segment.angle = item.at("angle_deg").get<double>() * degree;
        segment.from = item.at("from");
        segment.to = item.at("to");
        segment.spline = spline_of(item.at("spline"));
        collect(item.at("peaks"), "", segment.peaks);
        outcome.segments.push_back(segment);
    }
}

void read_limits(const json& result, Outcome& outcome) {
    for (const json& row : result.at("constraints")) {
        const auto limit = number_of(row.at("limit"));
        // A cam that is nowhere hollow, or nowhere convex, has no least radius there.
        const bool of_radius = text_of(row.at("key")).find("_radius_min") != std::string::npos;
        if (outcome.has_motion() && row.at("worst").is_null() && !of_radius)
            outcome.limits_without_worst.push_back(text_of(row.at("key")));
        const auto worst = number_of(row.at("worst"));
        if (limit && worst)
            outcome.limits.push_back(
                {text_of(row.at("name")), text_of(row.at("key")), text_of(row.at("unit")), *limit, *worst});
    }
    if (!result.contains("relaxation")) return;
    for (const json& row : result.at("relaxation")) {
        const auto given = row.contains("given") ? number_of(row.at("given")) : std::nullopt;
        if (!row.contains("key") || !given) continue;
        outcome.relaxation.push_back({text_of(row.at("key")), *given,
                                      row.contains("needed") ? number_of(row.at("needed")) : std::nullopt});
        if (!row.contains("also")) continue;
        outcome.relaxation.back().solved = row.at("solved");
        for (const json& other : row.at("also"))
            outcome.relaxation.back().also.push_back(
                {other.at("key"), other.at("given"), other.at("solved")});
    }
}

/// Whatever stands under "seconds" and "allowed_seconds" (what was left of the time), at any depth.
void erase_seconds(json& value) {
    if (value.is_object()) {
        value.erase("seconds");
        value.erase("allowed_seconds");
    }
    for (json& member : value)
        if (member.is_structured()) erase_seconds(member);
}

void read_result(const std::string& text, Outcome& outcome) {
    json result = json::parse(text);
    outcome.verdict = text_of(result.at("verdict"));
    outcome.reason = text_of(result.at("reason"));
    outcome.objective = number_of(result.at("objective"));
    outcome.lower = number_of(result.at("bound").at("lower"));
    outcome.gap = number_of(result.at("bound").at("gap"));
    outcome.any_curve_limit = number_of(result.at("bound").at("any_curve_limit"));
    outcome.proof_kind = text_of(result.at("bound").at("proof"));
    outcome.worst_violation = number_of(result.at("worst_violation"));
    outcome.solver = text_of(result.at("solver").at("name"));
    outcome.termination = text_of(result.at("solver").at("termination"));
    outcome.convex = result.at("solver").at("convex");
    if (result.at("design").is_object()) outcome.design = text_of(result.at("design").at("kind"));
    collect(result.at("peaks"), "", outcome.peaks);
    collect(result.at("reference"), "", outcome.references);
    collect(result.at("dimensions"), "", outcome.dimensions);
    collect(result.at("cam"), "", outcome.cam);
    outcome.spline = spline_of(result.at("spline"));
    read_segments(result.at("segments"), outcome);
    read_limits(result, outcome);
    for (const json& note : result.at("notes")) outcome.notes.push_back(text_of(note));
    if (result.contains("explanation"))
        for (const json& key : result["explanation"].at("unsettled"))
            outcome.unsettled.push_back(text_of(key));
    erase_seconds(result);
    if (result["cam"].is_object()) result["cam"].erase("forward_check");
    outcome.repeatable += result.dump();
}

void read_certificate_text(const std::string& text, Outcome& outcome) {
    const json file = json::parse(text);
    outcome.repeatable += file.dump();
    if (const auto boxes = file.find("boxes"); boxes != file.end() && !boxes->is_null())
        outcome.has_box_proof = !boxes->at("steps").empty();
    if (const json& cases = file.at("cases"); !cases.is_null() && !cases.empty())
        outcome.has_box_proof = std::ranges::all_of(cases, [&](const json& one) {
            const json& at = one.at("proof_of_case");
            return !at.is_null() && !cases.at(at.get<std::size_t>()).at("proof").is_null();
        });
    const json& proof = file.at("proof");
    if (proof.is_null()) return;
    Proof found;
    found.statement = text_of(proof.at("statement"));
    found.cost = list_of(proof.at("cost"));
    found.constant = proof.at("constant");
    for (const json& row : proof.at("rows"))
        found.rows.push_back({row.at("indices").get<std::vector<int>>(), list_of(row.at("values")),
                              number_of(row.at("lower")), number_of(row.at("upper")), row.at("multiplier")});
    found.box_lower = open_list_of(proof.at("box").at("lower"));
    found.box_upper = open_list_of(proof.at("box").at("upper"));
    found.bound = number_of(proof.at("bound"));
    outcome.proof = std::move(found);
}

void add_pieces(const std::optional<SplineCurve>& curve, std::optional<PublishedSpline>& spline) {
    if (!curve || !spline) return;
    for (const auto& piece : curve->pieces().colwise())
        spline->pieces.emplace_back(piece.begin(), piece.end());
}

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Outcome solve_text(const std::string& scene, Scope scope) {
    Outcome outcome;
    const double begin = processor_seconds();
    const auto wall = std::chrono::steady_clock::now();
    std::string result, certificate;
    try {
        const Scene read = scene_of_toml(scene, {}, "soak");
        outcome.solution = std::make_shared<const Solution>(
            scope == Scope::published ? solve(read) : solve_without_explaining(read, {}));
        outcome.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
        result = result_json(*outcome.solution);
        certificate = certificate_json(outcome.solution->certificate);
    } catch (const std::exception& error) {
        outcome.refusal = error.what();
    }
    outcome.processor_seconds = processor_seconds() - begin;
    if (!outcome.refusal.empty()) return outcome;
    try {
        read_result(result, outcome);
        read_certificate_text(certificate, outcome);
        if (scope == Scope::published) return outcome;
        add_pieces(outcome.solution->curve, outcome.spline);
        for (std::size_t k = 0; k < outcome.segments.size(); ++k)
            add_pieces(outcome.solution->segments[k].curve, outcome.segments[k].spline);
    } catch (const std::exception& error) {
        outcome.broken = fmt::format("the JSON cannot be read: {}", error.what());
    }
    return outcome;
}

std::vector<std::string> available_solvers() {
    std::vector<std::string> names;
    for (const SolverEntry& entry : solver_entries())
        if (entry.available) names.push_back(entry.name);
    return names;
}

}  // namespace camopt::soak
