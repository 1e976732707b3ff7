// SPDX-License-Identifier: MIT
#include "report/machine/machine_json.hpp"

#include "core/version.hpp"
#include "report/document/common_figures.hpp"
#include "report/json/certificate_json.hpp"
#include "report/json/json_text.hpp"
#include "report/view/shown_units.hpp"

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

}  // namespace

std::string machine_json(const MachineSolution& solution, const RunOrigin& machine,
                         const std::vector<RunOrigin>& axes) {
    Json json;
    json["camopt"] = version();
    json["machine"] = words_json(machine.scene_file);
    json["title"] = words_json(solution.spec.title);
    json["command"] = words_json(machine.command);
    json.update(figures_json(verdict_figures(solution.certificate)));
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

}  // namespace camopt
