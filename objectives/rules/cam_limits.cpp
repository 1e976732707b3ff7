// SPDX-License-Identifier: MIT
#include "objectives/rules/cam_limits.hpp"

#include "objectives/rules/made_cams.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

namespace camopt {

namespace cam_limit_parts {

Limits::Limits(const Scene& scene, const CamVariables& variables)
    : scene_(scene), variables_(std::make_shared<const CamVariables>(variables)) {
    active_.reserve(variables.own_variables());
    for (std::size_t k = 0; k < variables.own_variables(); ++k)
        active_.push_back(variables.variables[k].dimension);
}

double Limits::roller(int station) const {
    const int index = cam().roller_radius_at(station);
    return index < 0 ? 0.0 : dimensions()[index];
}

void Limits::add_at(CamFormula formula, int station) {
    if (cam().direct() != nullptr) formula.remark = cam().station_name(station);
    if (cam().stations() > 1) formula.fields.which["station"] = station;
    add(std::move(formula));
}

void add_regularity(Limits& limits, const WrittenLimit& limit, int station, std::string part) {
    using enum MechanismQuantity;
    if (!limits.structure().binds(regularity, station)) return;
    const double margin = limit.value;
    const std::string name = part.empty() ? limit.key : fmt::format("{} ({})", limit.key, part);
    RowFields fields{.key = limit.key, .part = std::move(part)};
    const int base = limits.cam().base_radius_index();
    // Of a pushed flat face (base + s + s'')/base >= margin times base is linear in the base radius too.
    if (base >= 0 && limits.is_linear(cam_radius)) {
        const double unit = limits.dimensions()[static_cast<std::size_t>(base)];
        CamFormula formula = cam_formula(name, [=](const auto& call) {
            return margin / unit * call.dimension(base) + -1.0 / unit * call.quantity(cam_radius, station);
        });
        formula.fields = std::move(fields);
        formula.linear = true;
        return limits.add(std::move(formula));
    }
    CamFormula formula = cam_formula(
        name, [=](const auto& call) { return -1.0 * call.quantity(regularity, station) + margin; });
    formula.fields = std::move(fields);
    formula.figure = regularity;
    formula.over = [=](const CamCallOver& call) {
        const MechanismEnclosures* const known = call.cam.enclosures();
        return known == nullptr ? std::nullopt : known->regularity_over(margin, call.state, station);
    };
    limits.add_at(std::move(formula), station);
}

}  // namespace cam_limit_parts

namespace {

using namespace cam_limit_parts;
using enum MechanismQuantity;

// A flat oscillating face reverses where 1 + σψ' vanishes; it stays this far away.
constexpr double least_face_turn = 1e-3;

/// (r + shift) κ − 1 with the curvature of the station: the convex radius stays above shift, the concave one
/// above −shift; in a groove shift is half the clearance more.
void add_radius(Limits& limits, const WrittenLimit& limit, double shift, double scale, int station) {
    const int roller = limits.cam().roller_radius_at(station);
    CamFormula formula = cam_formula(limit.key, [=](const auto& call) {
        const auto curvature = call.quantity(pitch_curvature, station);
        if (roller < 0) return shift * curvature + -1.0;
        return (call.dimension(roller) + shift) * curvature + -1.0;
    });
    formula.over = [=](const CamCallOver& call) -> std::optional<RangeOver> {
        const MechanismEnclosures* const known = call.cam.enclosures();
        if (known == nullptr) return {};
        const RangeOver radius = roller < 0 ? RangeOver(shift) : call.dimension(roller) + RangeOver(shift);
        return known->radius_over(radius, call.state, station);
    };
    formula.figure = pitch_curvature;
    formula.scale = scale;
    limits.add_at(std::move(formula), station);
}

void add_radii(Limits& limits, int station) {
    const LimitSpec& written = limits.scene().limits;
    const bool roller = limits.cam().roller_radius_at(station) >= 0;
    const double wider = limits.wider_by(station), nominal = limits.roller(station) + wider;
    if (const auto& limit = limit_on(written, LimitedFigure::convex_radius);
        limit && (roller || limit->value > 0.0)) {
        const double least = limit->value;
        const double scale = least > 0.0 ? std::max(least_scale, least / (nominal + least)) : 1.0;
        add_radius(limits, *limit, least + wider, scale, station);
    }
    // A roller fits into any hollow larger than itself.
    const auto& concave = limit_on(written, LimitedFigure::concave_radius);
    const bool moves = limits.variables().is_variable(limits.cam().roller_radius_at(station));
    if (concave && (moves || concave->value > nominal)) {
        const double least = concave->value;
        const double scale = std::clamp(least / std::max(least - nominal, least_scale * least), 1.0, 1e3);
        add_radius(limits, *concave, wider - least, scale, station);
    }
}

void add_flat_radius(Limits& limits) {
    const auto& limit = limit_on(limits.scene().limits, LimitedFigure::convex_radius);
    if (!limit) return;
    const double base = *limits.cam().base_radius(limits.dimensions()), least = limit->value;
    CamFormula formula = cam_formula(
        limit->key, [=](const auto& call) { return -1.0 / base * (call.quantity(cam_radius, 0) + -least); });
    formula.linear = limits.is_linear(cam_radius);
    formula.scale = least > 0.0 ? std::max(least_scale, least / base) : 1.0;
    limits.add(std::move(formula));
}

/// 1 + σψ' of an oscillating flat face stays positive: where it vanishes there is no contact.
void add_face_turn(Limits& limits, const std::string& key) {
    const DirectCam* const cam = limits.cam().direct();
    const double sense = cam == nullptr ? 0.0 : cam->face_turn();
    if (sense == 0.0) return;
    CamFormula formula = cam_formula(
        key, [sense](const auto& call) { return -sense * call.velocity() + (least_face_turn - 1.0); });
    formula.remark = "face turns back";
    formula.fields.part = "face_turn";
    formula.highest_order = 1;
    formula.linear = true;
    limits.add(std::move(formula));
}

void add_face_width(Limits& limits) {
    const std::optional<CamSpec>& cam = limits.scene().cam;
    if (!cam || !cam->face_half_width) return;
    const double width = *cam->face_half_width;
    for (const int sign : {1, -1}) {
        CamFormula formula = cam_formula(cam->face_key(), [sign, width](const auto& call) {
            return sign / width * call.velocity() + -1.0;
        });
        formula.sign = sign;
        formula.highest_order = 1;
        formula.linear = true;
        limits.add(std::move(formula));
    }
}

/// The limit on the shape of the cam's surface, if any: satisfying it ensures contact.
const WrittenLimit* limit_of_contact(const Scene& scene) {
    const bool press = scene.forces && scene.motion.speed;
    for (const LimitedFigure figure : {LimitedFigure::convex_radius, LimitedFigure::regularity,
                                       LimitedFigure::hertz_pressure, LimitedFigure::torque}) {
        if (limit_row(figure).needs_forces && !press) continue;
        if (const auto& limit = limit_on(scene.limits, figure)) return &*limit;
    }
    return nullptr;
}

// Relative to the longest dimension: a cam closer to the limit of its reach than this is ill-conditioned.
constexpr double least_reach = 1e-6;

void add_inequality(CamModel& model, const CamSpec& spec, std::span<const SignedIndex> inequality) {
    ParameterRow row{"cam.base_radius", {}, {}, 0.0, true, 1.0};
    double most = 0.0, longest = 0.0;
    for (const auto& [which, sign] : inequality) {
        const Dimension& dimension = spec.dimensions[static_cast<std::size_t>(which)].value;
        most += std::max(sign * dimension.low, sign * dimension.high);
        longest = std::max({longest, std::abs(dimension.low), std::abs(dimension.high)});
        if (!dimension.is_variable()) {
            row.upper -= sign * dimension.low;
            continue;
        }
        const auto variable =
            std::ranges::find(model.cam->variables, which, &CamVariables::Variable::dimension);
        row.parameters.push_back(variable->parameter);
        row.weights.push_back(sign * variable->reference);
    }
    const double margin = least_reach * longest;
    if (row.parameters.empty() || most <= -margin) return;
    row.upper -= margin;
    // Normalised by the longest dimension.
    for (double& weight : row.weights) weight /= longest;
    row.upper /= longest;
    model.parameter_rows.push_back(std::move(row));
}

/// Of one cam.
std::vector<std::shared_ptr<const CamRule>> limits_of_cam(const Scene& scene, const CamVariables& variables) {
    Limits limits(scene, variables);
    const CamMechanism& cam = limits.cam();
    add_pressure(limits);
    if (cam.radius_quantity() == cam_radius) add_flat_radius(limits);
    if (cam.radius_quantity() == pitch_curvature)
        for (int station = 0; station < cam.stations(); ++station) add_radii(limits, station);
    if (const auto& limit = limit_on(scene.limits, LimitedFigure::regularity))
        for (int station = 0; station < cam.stations(); ++station) add_regularity(limits, *limit, station);
    if (const WrittenLimit* limit = limit_of_contact(scene)) add_face_turn(limits, limit->key);
    add_face_width(limits);
    add_forces(limits);
    return limits.taken();
}

}  // namespace

std::vector<std::shared_ptr<const CamRule>> cam_limits(const Scene& scene, const CamVariables& variables) {
    if (!scene.tolerance) return limits_of_cam(scene, variables);
    return limits_of_made_cams(scene, variables, limits_of_cam);
}

void add_reach_rows(CamModel& model, const CamSpec& spec) {
    const auto formulas = spec.formulas();
    const DirectCam* const cam = formulas->direct();
    if (cam == nullptr) return;
    for (const auto& inequality : cam->reach()) add_inequality(model, spec, inequality);
}

}  // namespace camopt
