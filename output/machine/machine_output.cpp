// SPDX-License-Identifier: MIT
#include "output/machine/machine_output.hpp"

#include "core/version.hpp"
#include "output/json/certificate_json.hpp"
#include "output/json/json_text.hpp"
#include "output/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

double rpm(double speed) {
    return as_written(rpm_shown.of(speed));
}
double degrees(double angle) {
    return as_written(degrees_shown.of(angle));
}

const std::string& axis_name(const MachineSolution& solution, int index) {
    return solution.spec.axes[index].name;
}

Json limited_json(const MachineSolution& solution) {
    Json list = Json::array();
    for (const MachineLimit& limit : solution.limited_by) {
        Json one;
        if (limit.axis >= 0) one["axis"] = axis_name(solution, limit.axis);
        if (limit.clearance >= 0) one["clearance"] = limit.clearance;
        one["key"] = limit.key;
        one["at_deg"] = number_json(degrees(limit.angle));
        one["share"] = number_json(limit.share);
        one["unit"] = words_json(limit.unit);
        one["given"] = number_json(limit.given);
        one["needed"] = number_json(limit.needed);
        one["enough_alone"] = limit.asked ? Json(limit.enough_alone) : Json(nullptr);
        list.push_back(std::move(one));
    }
    return list;
}

Json clearances_json(const MachineSolution& solution) {
    Json list = Json::array();
    for (std::size_t k = 0; k < solution.clearances.size(); ++k) {
        const Clearance& written = solution.spec.clearances[k];
        Json between = Json::array();
        for (const int axis : written.axes) between.push_back(axis_name(solution, axis));
        list.push_back(
            {{"key", written.key},
             {"between", between},
             {"factors", numbers_json(written.factors)},
             {"at_least", number_json(as_written(written.at_least / written.unit_value))},
             {"unit", words_json(written.unit)},
             {"least", number_json((written.at_least + solution.clearances[k].value) / written.unit_value)},
             {"at_deg", number_json(degrees(solution.clearances[k].at))}});
    }
    return list;
}

std::string speed_lines(const MachineSolution& solution) {
    const Certificate& certificate = solution.certificate;
    if (certificate.verdict == Verdict::infeasible)
        return solution.at_standstill
                   ? "  infeasible at any speed: the contradiction remains as the speed approaches 0\n"
                   : fmt::format("  infeasible: proved that no motions exist at {:.7g} rpm\n",
                                 rpm(solution.speed));
    if (solution.axes.empty())
        return fmt::format("  {}: {}\n", name_of(certificate.verdict), name_of(certificate.reason));
    std::string text;
    if (!solution.spec.searches_speed())
        text = fmt::format("  speed: {:.7g} rpm, as given\n", rpm(solution.speed));
    else if (solution.impossible_above)
        text = fmt::format("  largest speed: {:.7g} rpm; proved impossible at {:.7g} rpm ({:.2g} % more)\n",
                           rpm(solution.speed), rpm(*solution.impossible_above),
                           100.0 * (*solution.impossible_above / solution.speed - 1.0));
    else
        text =
            fmt::format("  largest speed: {:.7g} rpm{}\n", rpm(solution.speed),
                        solution.reached_most ? ", the end of the range: a larger range may allow more" : "");
    text += fmt::format("  verdict: {}; total objective {:.9g}", name_of(certificate.verdict),
                        certificate.objective);
    if (certificate.lower_bound) text += fmt::format(", at least {:.9g} is proved", *certificate.lower_bound);
    return text + "\n";
}

std::string limit_line(const MachineSolution& solution, const MachineLimit& limit) {
    const std::string unit = limit.unit.empty() ? "" : " " + unit_words(limit.unit);
    std::string text = fmt::format("  {:>5.1f} %  {}{}", 100.0 * limit.share,
                                   limit.axis >= 0 ? axis_name(solution, limit.axis) + ": " : "", limit.key);
    if (limit.given) text += fmt::format(" = {}{}", short_text(*limit.given), unit);
    text += fmt::format(" at {:.1f} deg", degrees(limit.angle));
    if (limit.needed)
        text += fmt::format("; {}{} alone would allow 5 % more speed", short_text(*limit.needed, 4), unit);
    else if (limit.asked)
        text += "; not enough alone for 5 % more speed";
    return text + "\n";
}

}  // namespace

std::string machine_json(const MachineSolution& solution, const RunOrigin& machine,
                         const std::vector<RunOrigin>& axes) {
    Json json;
    json["camopt"] = version();
    json["machine"] = words_json(machine.scene_file);
    json["title"] = words_json(solution.spec.title);
    json["command"] = words_json(machine.command);
    add_verdict(json, solution.certificate);
    json["speed_rpm"] = solution.axes.empty() ? Json(nullptr) : number_json(rpm(solution.speed));
    json["impossible_above_rpm"] =
        solution.impossible_above ? number_json(rpm(*solution.impossible_above)) : Json(nullptr);
    json["reached_most"] = solution.reached_most;
    json["at_standstill"] = solution.at_standstill;
    json["scanned"] = solution.scanned;
    json["worst_violation"] = number_json(solution.certificate.worst_violation);
    json["limited_by"] = limited_json(solution);
    json["clearances"] = clearances_json(solution);
    json["axes"] = Json::object();
    for (std::size_t b = 0; b < solution.axes.size(); ++b) {
        Json axis = Json::parse(result_json(solution.axes[b], axes[b]));
        axis["phase_deg"] = number_json(degrees(solution.spec.axes[b].phase));
        json["axes"][solution.spec.axes[b].name] = std::move(axis);
    }
    json["trials"] = solution.trials;
    if (const std::optional<MachineTiming>& timing = solution.timing) {
        const bool speed = solution.spec.searches_speed();
        Json& own = json["timing"] = {{"tried", timing->tried}, {"complete", timing->complete}};
        own[speed ? "given_speed_rpm" : "given_objective"] =
            timing->given ? number_json(speed ? rpm(*timing->given) : *timing->given) : Json(nullptr);
        for (const AxisSpec& axis : solution.spec.axes) {
            Json angles = Json::array();
            for (const ProgramSegment& segment : axis.scene.motion.segments)
                angles.push_back(number_json(degrees(segment.angle)));
            own["segment_angles_deg"][axis.name] = std::move(angles);
        }
    }
    json["seconds"] = {{"total", number_json(solution.seconds_total)}};
    json["notes"] = solution.notes;
    return json_text(json);
}

std::string impossible_json(const MachineSolution& solution) {
    Certificate certificate;
    certificate.verdict = Verdict::infeasible;
    certificate.reason = Reason::limits_contradict;
    certificate.worst_violation = solution.impossible ? solution.impossible->bound : infinity;
    certificate.proof = solution.impossible;
    certificate.proof_kind = ProofKind::duality;
    return certificate_json(certificate);
}

std::string machine_text(const MachineSolution& solution) {
    std::string text = (solution.spec.title.empty() ? "machine" : solution.spec.title) + "\n";
    text += speed_lines(solution);
    if (!solution.limited_by.empty()) text += "limited by (shares of the proof)\n";
    for (const MachineLimit& limit : solution.limited_by) text += limit_line(solution, limit);
    if (!solution.clearances.empty()) text += "clearances\n";
    for (std::size_t k = 0; k < solution.clearances.size(); ++k) {
        const Clearance& written = solution.spec.clearances[k];
        const Extremum& worst = solution.clearances[k];
        text += fmt::format("  {}: least {}{} at {:.1f} deg, at least {}\n",
                            name_of_clearance(static_cast<int>(k)),
                            short_text((written.at_least + worst.value) / written.unit_value),
                            written.unit.empty() ? "" : " " + written.unit, degrees(worst.at),
                            short_text(written.at_least / written.unit_value));
    }
    if (!solution.axes.empty()) text += "axes\n";
    for (std::size_t b = 0; b < solution.axes.size(); ++b) {
        const Solution& axis = solution.axes[b];
        text += fmt::format("  {}: objective {:.6g}", solution.spec.axes[b].name, axis.certificate.objective);
        for (const ConstraintReport& limit : axis.constraints)
            if (limit.active)
                text += fmt::format("; {} active at {:.1f} deg", limit.key,
                                    degrees(std::fmod(solution.spec.axes[b].phase + units::turn +
                                                          limit.at * axis.scene.motion.unit_angle(),
                                                      units::turn)));
        text += "\n";
    }
    for (const std::string& note : solution.notes) text += "note: " + note + "\n";
    return text + fmt::format("{} speeds tried, {:.2f} s\n", solution.trials, solution.seconds_total);
}

}  // namespace camopt
