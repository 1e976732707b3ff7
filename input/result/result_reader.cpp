// SPDX-License-Identifier: MIT
#include "input/result/result_reader.hpp"

#include "core/errors.hpp"
#include "core/nlp.hpp"
#include "core/text/printable.hpp"
#include "core/version.hpp"
#include "input/result/json_source.hpp"

#include <fmt/format.h>

namespace camopt::input {

namespace {

CurveRecord read_curve(const JsonSource& json) {
    CurveRecord curve;
    curve.degree = json.at("degree").integer();
    curve.continuity = json.at("continuity").integer();
    if (curve.degree != 3 && curve.degree != 5)
        json.at("degree").fail(fmt::format("found {}; allowed: 3 or 5", curve.degree));
    curve.breakpoints = json.at("breakpoints").numbers();
    const std::vector<JsonSource> pieces = json.at("pieces").items();
    curve.pieces.resize(curve.degree + 1, static_cast<Eigen::Index>(pieces.size()));
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::vector<double> piece = pieces[i].numbers();
        if (static_cast<Eigen::Index>(piece.size()) != curve.pieces.rows())
            pieces[i].fail(
                fmt::format("found {} numbers; allowed: {}, degree + 1", piece.size(), curve.pieces.rows()));
        curve.pieces.col(static_cast<Eigen::Index>(i)) =
            Eigen::Map<const Eigen::VectorXd>(piece.data(), curve.pieces.rows());
    }
    return curve;
}

PartRecord read_part(const JsonSource& json, std::size_t curves) {
    PartRecord part;
    part.begin = json.at("begin").number();
    part.end = json.at("end").number();
    if (const JsonSource curve = json.at("curve"); !curve.is_null()) {
        part.curve = curve.integer();
        if (static_cast<std::size_t>(*part.curve) >= curves)
            curve.fail(
                fmt::format("found {}; allowed: one of the {} curves, counted from 0", *part.curve, curves));
    }
    part.law = json.at("law").words();
    part.x0 = json.at("x0").number();
    part.x_scale = json.at("x_scale").number();
    part.y0 = json.at("y0").number();
    part.y_scale = json.at("y_scale").number();
    if (part.x_scale == 0.0) json.at("x_scale").fail("found 0; allowed: any other number");
    return part;
}

std::optional<ForwardCheckRecord> read_forward_check(const JsonSource& json) {
    if (json.is_null()) return {};
    ForwardCheckRecord check;
    // Nonfinite values are stored as null.
    const auto number = [&](const char* key) {
        const JsonSource value = json.at(key);
        return !value.is_null() ? value.number() : infinity;
    };
    check.deviation = number(json.has("deviation_deg") ? "deviation_deg" : "deviation_mm");
    check.relative = number("relative");
    check.points = json.at("points").integer();
    check.seconds = json.at("seconds").number();
    check.at_deg = json.at("at_deg").number();
    if (!json.has("play")) return check;
    const JsonSource play = json.at("play");
    const auto extreme = [&](const char* turned, const char* straight) {
        const JsonSource value = play.at(play.has(turned) ? turned : straight);
        return !value.is_null() ? value.number() : infinity;
    };
    check.play.emplace();
    check.play->least = extreme("least_deg", "least_mm");
    check.play->largest = extreme("largest_deg", "largest_mm");
    check.play->least_at_deg = play.at("least_at_deg").number();
    check.play->largest_at_deg = play.at("largest_at_deg").number();
    if (play.has("least_groove_width_mm"))
        check.play->least_groove_width_mm = play.at("least_groove_width_mm").number();
    return check;
}

std::optional<CamRecord> read_cam(const JsonSource& json) {
    if (json.is_null()) return {};
    CamRecord cam;
    for (const auto& [name, value] : json.at("dimensions").members())
        cam.dimensions.emplace_back(name, value.number());
    cam.forward_check = read_forward_check(json.at("forward_check"));
    return cam;
}

SolverRecord read_solver(const JsonSource& json) {
    SolverRecord solver;
    solver.name = json.at("name").text();
    solver.termination = json.at("termination").text();
    solver.iterations = json.at("iterations").integer();
    solver.exchange_rounds = json.at("exchange_rounds").integer();
    solver.native_status = json.at("native_status").words();
    solver.choice = json.at("choice").words();
    solver.convex = json.at("convex").flag();
    solver.starts = json.at("starts").integer();
    return solver;
}

EvaluationRecord read_evaluations(const JsonSource& json) {
    return {json.at("cost").count(),     json.at("gradient").count(), json.at("constraints").count(),
            json.at("jacobian").count(), json.at("hessian").count(),  json.at("profile_points").count()};
}

void read_motion(const JsonSource& json, ResultRecord& record) {
    if (json.is_null() || record.verdict == "infeasible")  // a prescribed one is shown, not made
        json.fail(
            fmt::format("found none: the verdict is {}; allowed: a result with a motion", record.verdict));
    for (const JsonSource& curve : json.at("curves").items()) record.curves.push_back(read_curve(curve));
    for (const JsonSource& part : json.at("parts").items())
        record.parts.push_back(read_part(part, record.curves.size()));
}

constexpr std::size_t longest_shown = 60;

}  // namespace

ResultRecord read_result(std::string_view json, std::string_view source_name, RecordedMotion needed) {
    const JsonSource source(json, source_name);
    if (const JsonSource written = source.at("camopt"); written.words() != version())
        written.fail(fmt::format("found a result of camopt {}; allowed: of {}: solve its scene again",
                                 written.words(), version()));
    ResultRecord record;
    record.scene_file = source.at("scene").words();
    record.command = source.at("command").words();
    record.verdict = source.at("verdict").text();
    const JsonSource motion = source.at("motion");
    const bool moves = needed == RecordedMotion::required || !motion.is_null();
    if (moves) read_motion(motion, record);
    const JsonSource limit = source.at("bound").at("any_curve_limit");
    if (!limit.is_null()) record.any_curve_limit = limit.number();
    record.cam = read_cam(source.at("cam"));
    if (const JsonSource design = source.at("design"); moves)
        record.design = {design.at("kind").text(), design.at("names").texts(), design.at("values").numbers()};
    record.solver = read_solver(source.at("solver"));
    record.solver.proof_source = source.at("bound").at("source").words();
    record.evaluations = read_evaluations(source.at("evaluations"));
    const JsonSource seconds = source.at("seconds");
    record.seconds_total = seconds.at("total").number();
    record.seconds_solve = seconds.at("solve").number();
    for (const auto& [name, value] : seconds.members()) record.seconds[name] = value.number();
    record.notes = source.at("notes").texts();
    if (source.has("machine")) record.machine = source.at("machine").words();
    return record;
}

JsonSource::JsonSource(std::string_view text, std::string_view source_name) : file_(source_name) {
    try {
        document_ = std::make_shared<const Json>(Json::parse(text));
    } catch (const Json::exception& error) {
        throw InputError(fmt::format("{}: found no JSON: {}", printable(file_), printable(error.what())));
    }
    value_ = document_.get();
}

std::string JsonSource::shown() const {
    return json_words(*value_);
}

void JsonSource::fail(std::string_view what) const {
    throw InputError(
        fmt::format("{}: {}{}{}", printable(file_), printable(path_), path_.empty() ? "" : ": ", what));
}

std::string JsonSource::path_to(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

JsonSource JsonSource::at(const char* key) const {
    if (!value_->is_object()) fail(fmt::format("found {}; allowed: an object", shown()));
    const auto found = value_->find(key);
    if (found == value_->end())
        throw InputError(fmt::format("{}: {}: found no such key; allowed: a result as camopt writes it",
                                     printable(file_), printable(path_to(key))));
    return {*this, *found, path_to(key)};
}

std::vector<JsonSource> JsonSource::items() const {
    if (!value_->is_array()) fail(fmt::format("found {}; allowed: a list", shown()));
    std::vector<JsonSource> all;
    all.reserve(value_->size());
    for (std::size_t i = 0; i < value_->size(); ++i)
        all.push_back({*this, (*value_)[i], fmt::format("{}[{}]", path_, i)});
    return all;
}

double JsonSource::number() const {
    if (!value_->is_number()) fail(fmt::format("found {}; allowed: a number", shown()));
    return value_->get<double>();
}

std::vector<double> JsonSource::numbers() const {
    std::vector<double> all;
    for (const JsonSource& item : items()) all.push_back(item.number());
    return all;
}

long JsonSource::count() const {
    const bool whole =
        value_->is_number_unsigned() &&
        value_->get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<long>::max());
    if (!whole) fail(fmt::format("found {}; allowed: a whole number, 0 or more", shown()));
    return value_->get<long>();
}

int JsonSource::integer() const {
    const long value = count();
    if (value > std::numeric_limits<int>::max())
        fail(fmt::format("found {}; allowed: up to {}", value, std::numeric_limits<int>::max()));
    return static_cast<int>(value);
}

bool JsonSource::flag() const {
    if (!value_->is_boolean()) fail(fmt::format("found {}; allowed: true or false", shown()));
    return value_->get<bool>();
}

std::string JsonSource::text() const {
    if (!value_->is_string()) fail(fmt::format("found {}; allowed: a text", shown()));
    return value_->get<std::string>();
}

std::vector<std::string> JsonSource::texts() const {
    std::vector<std::string> all;
    for (const JsonSource& item : items()) all.push_back(item.text());
    return all;
}

std::vector<std::pair<std::string, JsonSource>> JsonSource::members() const {
    if (!value_->is_object()) fail(fmt::format("found {}; allowed: an object", shown()));
    std::vector<std::pair<std::string, JsonSource>> all;
    for (const auto& [key, value] : value_->items())
        all.emplace_back(key, JsonSource(*this, value, path_to(key)));
    return all;
}

std::string json_words(const nlohmann::ordered_json& value) {
    if (value.is_object()) return "an object";
    if (value.is_array()) return fmt::format("a list of {}", value.size());
    const std::string text =
        printable(value.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace));
    return text.size() <= longest_shown ? text : text.substr(0, longest_shown) + "...";
}

}  // namespace camopt::input
