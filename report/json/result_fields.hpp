// SPDX-License-Identifier: MIT
// The fields of result.json that are read back, for both directions (report/json/json_fields.hpp). All others
// are written only: report/json/result_json.cpp. Private to report/.
#pragma once

#include "report/json/json_fields.hpp"
#include "report/view/shown_units.hpp"
#include "studies/delivered/result_record.hpp"

#include <fmt/format.h>

namespace camopt {

inline void fields(const JsonFields& json, CurveRecord& curve) {
    json.count("degree", curve.degree);
    json.check("degree", curve.degree == 3 || curve.degree == 5 || curve.degree == 7, "3, 5 or 7");
    json.count("continuity", curve.continuity);
    json("breakpoints", curve.breakpoints);
    json("pieces", curve.pieces);
    json.check("pieces",
               std::ranges::all_of(curve.pieces,
                                   [&](const auto& piece) { return piece.size() == curve.degree + 1; }),
               fmt::format("lists of {} numbers, degree + 1", curve.degree + 1));
}

inline void fields(const JsonFields& json, PartRecord& record, std::size_t curves) {
    ChainPart& part = record.part;
    json("begin", part.begin);
    json("end", part.end);
    json("curve", record.curve);
    json.check("curve", !record.curve || static_cast<std::size_t>(*record.curve) < curves,
               fmt::format("one of the {} curves, counted from 0", curves));
    json.words("law", record.law);
    json("x0", part.x0);
    json("x_scale", part.x_scale);
    json.check("x_scale", part.x_scale != 0.0, "any other number");
    json("y0", part.y0);
    json("y_scale", part.y_scale);
}

inline void fields(const JsonFields& json, MotionRecord& motion) {
    json("curves", motion.curves);
    json.each("parts", motion.parts,
              [&](const JsonFields& one, PartRecord& part) { fields(one, part, motion.curves.size()); });
}

inline void fields(const JsonFields& json, DesignReport& design) {
    json("kind", design.kind);
    json("names", design.names);
    json.numbers("values", design.values, design.names.size());
}

inline void fields(const JsonFields& json, LeastReport& least) {
    json("key", least.key);
    json("largest", least.largest);
    json("value", least.value);
    json("impossible", least.impossible);
    json("verdict", least.verdict);
    json("limited_by", least.limited_by);
}

inline void fields(const JsonFields& json, ToleranceReport& tolerance) {
    json("price", tolerance.price);
    json.each("worst", tolerance.decides, [](const JsonFields& one, ToleranceReport::Decides& decides) {
        one("limit", decides.limit);
        one("tolerance", decides.tolerance);
    });
    json.each("halved", tolerance.halved, [](const JsonFields& one, ToleranceReport::Halved& halved) {
        one("tolerance", halved.tolerance);
        one("gain", halved.gain);
    });
    json("segments_worth_making", tolerance.segments_worth);
    json.unless("open", tolerance.open, std::vector<std::string>{});
}

inline void fields(const JsonFields& json, SolverReport& solver) {
    json("name", solver.name);
    json("termination", solver.termination);
    json.count("iterations", solver.iterations);
    json.count("exchange_rounds", solver.exchange_rounds);
    json.words("native_status", solver.native_status);
    json.words("choice", solver.choice);
    json("convex", solver.convex);
    json.count("starts", solver.starts);
}

inline void fields(const JsonFields& json, EvaluationCounts& counts) {
    json.count("cost", counts.cost);
    json.count("gradient", counts.gradient);
    json.count("constraints", counts.constraints);
    json.count("jacobian", counts.jacobian);
    json.count("hessian", counts.hessian);
    json.count("profile_points", counts.profile_points);
}

/// x as an angle of the cam in files.
struct AngleOfX {
    double degrees_per_x;
    std::string suffix = degrees_shown.suffix;

    [[nodiscard]] double of(double x) const { return degrees_per_x * x; }
    [[nodiscard]] double si_of(double degrees) const {
        return value_shown_as(degrees, degrees / degrees_per_x, [&](double x) { return of(x); });
    }
};

inline void fields(const JsonFields& json, ForwardCheckReport& check, const Scene& scene) {
    const ShownUnits units = file_units(scene);
    const ShownUnit& output = scene.motion.lift_is_angle ? units.angle : units.length;
    const AngleOfX angle{units.degrees_per_x};
    json.in(output, "deviation", check.deviation, infinity);
    json("relative", check.relative, infinity);
    json.count("points", check.points);
    json("seconds", check.seconds);
    json.in(angle, "at", check.at);
    if (ForwardCheckReport::Play* const play = json.if_there("play", check.play)) {
        const JsonFields part = json.at("play");
        part.in(output, "least", play->least, infinity);
        part.in(angle, "least_at", play->least_at);
        part.in(output, "largest", play->largest, infinity);
        part.in(angle, "largest_at", play->largest_at);
        part.in(units.length, "least_groove_width", play->least_groove_width);
    }
}

/// At the head of the file: of a RunOrigin, or of a record.
void origin_fields(const JsonFields& json, auto& origin, std::string_view title) {
    json.words("scene", origin.scene_file);
    json.shown("title", words_json(title));
    json.words("command", origin.command);
}

/// Of "bound"; limit: the objective that no curve can pass.
inline void bound_fields(const JsonFields& json, std::optional<double>& limit, SolverReport& solver) {
    json("any_curve_limit", limit);
    json.words("source", solver.proof_source);
}

/// At the end of the file: of a Solution, or of its record.
void run_fields(const JsonFields& json, auto& run) {
    json("solver", run.solver);
    json("evaluations", run.evaluations);
    const JsonFields seconds = json.at("seconds");
    seconds("total", run.seconds_total);
    seconds("solve", run.seconds_solve);
    for (const PhaseRow& phase : phase_rows) seconds(phase.name, run.phases.*phase.seconds);
    json("notes", run.notes);
    json.unless("machine", run.machine, "");
    json.unless("least", run.least, std::nullopt);
    json.unless("tolerance", run.tolerance, std::nullopt);
}

}  // namespace camopt
