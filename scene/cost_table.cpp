// SPDX-License-Identifier: MIT
#include "scene/cost_table.hpp"

#include <functional>

namespace camopt {
namespace {

using Kind = CostTerm::Kind;

// A row is read as a row.
// clang-format off
constexpr std::array<CostTerm, cost_figure_count> rows = {{
    {CostFigure::velocity, Kind::peak, peak_figure("velocity"), "V",
     &ObjectiveSpec::velocity, &Reference::velocity, &LimitSpec::velocity, 1.76, true,
     "Weight of the velocity peak V.",
     "Reference of the velocity peak; needed where its weight is > 0, like the others."},
    {CostFigure::acceleration, Kind::peak, peak_figure("acceleration"), "A",
     &ObjectiveSpec::acceleration, &Reference::acceleration, &LimitSpec::acceleration, 5.53, true,
     "Weight of the acceleration peak A.",
     "Reference of the acceleration peak."},
    {CostFigure::jerk, Kind::peak, peak_figure("jerk"), "J",
     &ObjectiveSpec::jerk, &Reference::jerk, &LimitSpec::jerk, 69.5, true,
     "Weight of the jerk peak J.",
     "Reference of the jerk peak."},
    {CostFigure::torque, Kind::torque, peak_figure("torque"), "Q",
     &ObjectiveSpec::torque, &Reference::torque, nullptr, 5.46, false,
     "Weight of the torque peak Q, the largest magnitude of y'·y''; not convex.",
     "Reference of the torque peak."},
    {CostFigure::rms_acceleration, Kind::rms, peak_figure("rms_acceleration"), "rms A",
     &ObjectiveSpec::rms_acceleration, &Reference::rms_acceleration, nullptr, 3.91, true,
     "Weight of the root mean square of the acceleration.",
     "Reference of the root mean square of the acceleration."},
    {CostFigure::rms_jerk, Kind::rms, peak_figure("rms_jerk"), "rms J",
     &ObjectiveSpec::rms_jerk, &Reference::rms_jerk, nullptr, 23.0, true,
     "Weight of the root mean square of the jerk.",
     "Reference of the root mean square of the jerk."},
}};
constexpr std::array<ResponseTerm, 7> response_rows = {{
    {ResponseFigure::residual, "residual", "R",
     &ObjectiveSpec::residual, &Reference::residual,
     "Weight of the residual vibration R, the amplitude of the output after each rise and return.",
     "Reference of the residual vibration, in lifts."},
    {ResponseFigure::dynamic_acceleration, "dynamic_acceleration", "D",
     &ObjectiveSpec::dynamic_acceleration, &Reference::dynamic_acceleration,
     "Weight of D, the largest acceleration of the output on its elastic train.",
     "Reference of the output's acceleration, normalised as A."},
    {ResponseFigure::lost_area, "area", "lost area",
     &ObjectiveSpec::area, &Reference::area,
     "Weight of the lost area 1 - (1/L) ∫ y dx, y in lifts over the whole motion of length L (DRD 1, RR 1 + "
     "return/rise, programs one revolution): the larger the area under the curve, the smaller it is.",
     "Reference of the lost area; 0.5 is that of every symmetric law over DRD and RR."},
    {ResponseFigure::motor_torque, "motor_torque", "M",
     &ObjectiveSpec::motor_torque, &Reference::motor_torque,
     "Weight of the peak of the motor's torque.",
     "Reference of the peak of the motor's torque, N m."},
    {ResponseFigure::motor_torque_rms, "motor_torque_rms", "rms M",
     &ObjectiveSpec::motor_torque_rms, &Reference::motor_torque_rms,
     "Weight of the root mean square of the motor's torque over the cycle: what heats the motor.",
     "Reference of the root mean square of the motor's torque, N m."},
    {ResponseFigure::deviation, "deviation", "largest deviation",
     &ObjectiveSpec::deviation, &Reference::deviation,
     "Weight of the largest deviation from the rows of [measured].",
     "Reference of that deviation, in lifts; without it 0.001."},
    {ResponseFigure::deviation_rms, "deviation_rms", "rms deviation",
     &ObjectiveSpec::deviation_rms, &Reference::deviation_rms,
     "Weight of the root mean square of the deviations from the rows of [measured].",
     "Reference of that root mean square, in lifts; without it 0.001."},
}};
// clang-format on

constexpr bool in_order() {
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (rows[i].figure != static_cast<CostFigure>(i)) return false;
    return true;
}
static_assert(in_order(), "rows are in the order of CostFigure");

}  // namespace

std::span<const CostTerm> cost_terms() {
    return rows;
}

const CostTerm& cost_term(CostFigure figure) {
    return rows.at(static_cast<std::size_t>(figure));
}

std::span<const ResponseTerm> response_terms() {
    return response_rows;
}

bool weighs_response(const ObjectiveSpec& objective) {
    return std::ranges::any_of(response_rows, [&](const ResponseTerm& term) {
        return term.needs_dynamics() && term.weight_in(objective) > 0.0;
    });
}

const char* name_of(CostFigure figure) {
    return cost_term(figure).name();
}

std::vector<std::string> cost_term_names() {
    std::vector<std::string> names;
    names.reserve(rows.size());
    for (const CostTerm& term : rows) names.emplace_back(term.name());
    return names;
}

bool weighs_any(const ObjectiveSpec& objective, CostTerm::Kind kind) {
    return std::ranges::any_of(
        rows, [&](const CostTerm& term) { return term.kind == kind && term.weight_in(objective) > 0.0; });
}

double least_objective(const ObjectiveSpec& objective) {
    return objective.area > 0.0 ? -infinity : 0.0;
}

const char* name_of(PeakScope value) {
    return value == PeakScope::strokes ? "strokes" : "motion";
}

const char* name_of(TieBreak value) {
    return value == TieBreak::none ? "none" : "rms_jerk";
}

namespace {

bool same_cam(const std::optional<CamSpec>& one, const std::optional<CamSpec>& other) {
    if (!one || !other) return one.has_value() == other.has_value();
    return one->type == other->type && one->rotation == other->rotation &&
           one->dimensions == other->dimensions && one->choices == other->choices &&
           one->face_half_width == other->face_half_width && one->face_radius == other->face_radius;
}

bool same_objective_but_for_peaks(const ObjectiveSpec& one, const ObjectiveSpec& other) {
    ObjectiveSpec weighed = other;
    for (const CostTerm& term : cost_terms())
        if (term.kind != CostTerm::Kind::rms) std::invoke(term.weight, weighed) = term.weight_in(one);
    return one == weighed;
}

}  // namespace

bool weigh_same_peaks(const ObjectiveSpec& one, const ObjectiveSpec& other) {
    return std::ranges::all_of(cost_terms(), [&](const CostTerm& term) {
        return term.kind == CostTerm::Kind::rms ||
               (term.weight_in(one) > 0.0) == (term.weight_in(other) > 0.0);
    });
}

bool differ_in_peak_weights_only(const Scene& one, const Scene& other) {
    const auto own = [](const Scene& scene) { return !scene.own_terms.empty() || !scene.own_limits.empty(); };
    return !own(one) && !own(other) && same_objective_but_for_peaks(one.objective, other.objective) &&
           one.motion == other.motion && one.spline == other.spline && one.limits == other.limits &&
           one.solver == other.solver && same_cam(one.cam, other.cam) && one.forces == other.forces &&
           one.dynamics == other.dynamics && one.measured == other.measured && one.drawing == other.drawing &&
           one.title == other.title && one.length_unit == other.length_unit;
}

}  // namespace camopt
