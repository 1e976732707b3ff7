// SPDX-License-Identifier: MIT
#include "studies/delivered/solution_parts.hpp"

#include "motions/laws/law_catalogue.hpp"
#include "objectives/deviation_rules.hpp"
#include "objectives/drive_rules.hpp"
#include "objectives/motion_bounds.hpp"
#include "objectives/own_point_rule.hpp"
#include "objectives/response/response_rule.hpp"
#include "objectives/scene_model.hpp"
#include "objectives/spring_rules.hpp"

namespace camopt {

namespace {

/// The value farthest from `wanted`, from either side.
void look_at(SetPointReport& report, const Motion& motion, double wanted, double x) {
    for (const Side side : {Side::left, Side::right}) {
        // Outside of a region its velocity does not hold.
        const bool region = report.point.is_region() && report.order > 0;
        if (region && ((side == Side::left && x <= report.point.begin) ||
                       (side == Side::right && x >= report.point.end)))
            continue;
        const double found = motion.at(x, side).derivative[static_cast<std::size_t>(report.order)];
        const double distance = std::abs(found - wanted);
        if (distance < report.distance) continue;
        report.distance = distance;
        report.found = found;
        report.at = x;
    }
}

/// The motion is a polynomial on each piece of a region: where its velocity is right at degree places of a
/// piece and one more, it is right everywhere.
void look_along(SetPointReport& report, const Motion& motion, double wanted, int degree) {
    const PlacedPoint& region = report.point;
    std::vector<double> ends = {region.begin, region.end};
    for (const double point : motion.breakpoints())
        if (point > region.begin && point < region.end) ends.push_back(point);
    std::ranges::sort(ends);
    const int places = degree + 1;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        for (int k = 0; k <= places; ++k)
            look_at(report, motion, wanted, std::lerp(ends[i], ends[i + 1], static_cast<double>(k) / places));
}

ResponseReport response_report_of(const Scene& scene, ResponseKind kind, const Motion& motion) {
    const WorstResponse worst = worst_response(scene, kind, motion);
    return {worst.value, worst.speed, worst.at};
}

double weighted_dimensions(const Solution& solution) {
    if (!solution.cam) return 0.0;
    const CamSpec& spec = solution.scene.cam.value();
    const std::vector<double>& delivered = solution.cam->cam.dimensions;
    double sum = 0.0;
    for (std::size_t d = 0; d < delivered.size(); ++d)
        sum += dimension_weight(solution.scene, spec.dimensions[d].name) * std::abs(delivered[d]);
    return sum;
}

}  // namespace

std::shared_ptr<const MotionFamily> family_of(const Solution& solution) {
    if (solution.family) return solution.family;
    return std::make_shared<const MotionFamily>(scene_family(solution.scene, DesignKind::states));
}

const char* set_point_name(int order) {
    constexpr std::array<const char*, 3> names = {"via_displacement", "via_velocity", "via_acceleration"};
    return names.at(static_cast<std::size_t>(order));
}

std::vector<SetPointReport> set_point_reports(const MotionSpec& spec, int degree, const Motion& motion) {
    std::vector<SetPointReport> all;
    for (const PlacedPoint& point : placed_points(spec)) {
        for (int order = 0; order < 3; ++order) {
            const std::optional<double>& wanted = point.wanted[static_cast<std::size_t>(order)];
            if (!wanted) continue;
            const WrittenValue written = written_value(spec, point, order);
            SetPointReport report;
            report.point = point;
            report.order = order;
            report.key = written.key;
            report.unit = written.unit;
            report.size = std::abs(*wanted);
            if (point.is_region() && order == 1)
                look_along(report, motion, *wanted, degree);
            else
                look_at(report, motion, *wanted, std::clamp(point.begin, motion.begin(), motion.end()));
            report.wanted = as_written(*wanted * written.per_normalised);
            report.found *= written.per_normalised;
            all.push_back(std::move(report));
        }
    }
    return all;
}

LawMotion law_in_place(const Solution& solution, std::string_view law) {
    const Scene& scene = solution.scene;
    if (scene.motion.type != MotionType::program)
        return law_motion(strokes_of(scene.motion), false, make_law(law));
    const CamModel model = scene_model(scene, DesignKind::states, solution.reference_peaks);
    return law_motion(strokes_of(scene, model, &solution.output_motion()), scene.motion.closed,
                      make_law(law));
}

TrainReport train_report(const Scene& scene, const Motion& motion) {
    const DynamicsSpec& spec = scene.dynamics.value();
    TrainReport report;
    report.natural_frequencies = train_of(scene).natural_frequencies();
    report.frequency_ratio = scene.motion.unit_angle() / scene.motion.speed.value() *
                             report.natural_frequencies.front() / units::turn;
    report.speeds = response_speeds(scene);
    if (motion_events(scene.motion).empty()) return report;
    if (train_of(scene).vibrates())
        report.residual = response_report_of(scene, ResponseKind::residual, motion);
    report.acceleration = response_report_of(scene, ResponseKind::acceleration, motion);
    if (spec.pressed()) report.least_force = response_report_of(scene, ResponseKind::contact_force, motion);
    for (const ResponseTerm& term : response_terms())
        if (const double weight = term.weight_in(scene.objective); term.needs_dynamics() && weight > 0.0)
            report.terms.push_back(
                {term.name, weight, response_reference(scene, term),
                 (kind_of(term.figure) == ResponseKind::residual ? report.residual : report.acceleration)
                     .value()});
    return report;
}

std::vector<ConstraintReport> response_constraints(const Scene& scene, const TrainReport& train) {
    std::vector<ConstraintReport> reports;
    for (const LimitRow& row : limit_rows()) {
        const auto& limit = row.in(scene.limits);
        if (!row.needs_dynamics || !limit) continue;
        const bool residual = row.figure == LimitedFigure::residual;
        const std::optional<ResponseReport>& worst = residual ? train.residual : train.least_force;
        if (!worst) continue;
        const double value = residual ? worst->value * scene.motion.lift : worst->value;
        reports.push_back(
            {row.name, limit->key, limit->given(), value / limit->unit_value, limit->unit, worst->at});
    }
    return reports;
}

void report_responses(Solution& solution) {
    const Scene& scene = solution.scene;
    if (!scene.dynamics) return;
    solution.train = train_report(scene, *solution.motion);
    const std::vector<ConstraintReport> limits = response_constraints(scene, *solution.train);
    solution.constraints.insert(solution.constraints.end(), limits.begin(), limits.end());
}

SurgeReport surge_report(const Scene& scene, const Motion& motion) {
    // Up to the resonance and beyond it, but no page of rows for a slow cam.
    constexpr int fewest = 20, most = 60, beyond = 2;
    const double frequency = scene.forces.value().spring_frequency.value();
    const int nearest = scene.nearest_harmonic();
    const auto [first, last] = limited_harmonics(scene);
    SurgeReport report{frequency / scene.motion.speed.value(), {}};
    for (int order = 1; order <= std::max({most, nearest + 1, last}); ++order) {
        const bool near = std::abs(order - nearest) <= 1;
        const bool limited = scene.limits.spring_harmonic && order >= first && order <= last;
        if (!near && !limited && order > std::clamp(nearest + beyond, fewest, most)) continue;
        const double amplitude = scene.motion.lift * harmonic_amplitude(scene.motion, motion, order);
        report.harmonics.push_back({order, amplitude, frequency / order, near, limited});
    }
    return report;
}

std::vector<OwnTermReport> own_term_reports(const Scene& scene, const Motion& motion) {
    std::vector<OwnTermReport> reports;
    for (const OwnTerm& term : scene.own_terms) {
        const Extremum largest = largest_of_own(term, motion);
        reports.push_back({term.name, term.weight, term.reference, largest.value, largest.at});
    }
    if (const double weight = scene.objective.area; weight > 0.0)
        reports.push_back({"area", weight, area_reference(scene, scene_family(scene, DesignKind::states)),
                           lost_area(motion), motion.begin(), true, true});
    for (const ResponseTerm& term : response_terms()) {
        const double weight = term.weight_in(scene.objective);
        if (!term.needs_drive() || !(weight > 0.0)) continue;
        const DriveFigures figures = drive_figures(scene, motion);
        const bool rms = term.figure == ResponseFigure::motor_torque_rms;
        reports.push_back({term.name, weight,
                           drive_reference(scene, scene_family(scene, DesignKind::states), term),
                           rms ? figures.rms_torque : figures.torque.value,
                           rms ? motion.begin() : figures.torque.at, rms, true});
    }
    for (const ResponseTerm& term : response_terms()) {
        const double weight = term.weight_in(scene.objective);
        if (!term.needs_measured() || !(weight > 0.0)) continue;
        const Deviation found = deviation_of(measured_rows(scene, motion.begin(), motion.end()), motion);
        const bool rms = term.figure == ResponseFigure::deviation_rms;
        reports.push_back({term.name, weight, deviation_reference(scene, term),
                           rms ? found.rms : found.largest.value, rms ? motion.begin() : found.largest.at,
                           rms, true});
    }
    return reports;
}

std::vector<ConstraintReport> own_constraints(const Scene& scene, const Motion& motion) {
    std::vector<ConstraintReport> reports;
    for (const OwnLimit& limit : scene.own_limits) {
        const Extremum worst = largest_of_own(limit, motion);
        reports.push_back({limit.key(), limit.key(), limit.limit, worst.value, limit.unit, worst.at});
    }
    return reports;
}

double defined_objective(const Solution& solution) {
    const ObjectiveSpec& weights = solution.scene.objective;
    const Peaks& peaks = solution.peaks;
    const Peaks& reference = solution.reference_peaks;
    double sum = weighted_dimensions(solution);
    // A reference that a term of no weight would need may be infinite or absent.
    for (const CostTerm& term : cost_terms())
        if (const double weight = term.weight_in(weights); weight > 0.0)
            sum += weight * term.measured.of(peaks) / term.measured.of(reference);
    for (const OwnTermReport& term : solution.own_terms) sum += term.weight * term.value / term.reference;
    if (solution.train)
        for (const ResponseTermReport& term : solution.train->terms)
            sum += term.weight * term.worst.value / term.reference;
    return sum;
}

bool follows_noise(const MeasuredReport& measured) {
    return measured.rows < 2 * measured.freedom;
}

std::optional<double> gain_percent(const Solution& solution) {
    const MeasuredReport& measured = *solution.measured;
    const ObjectiveSpec& objective = solution.scene.objective;
    const bool sought = objective.deviation > 0.0 || objective.deviation_rms > 0.0;
    if (sought || follows_noise(measured) || !measured.objective || !solution.motion ||
        !(*measured.objective > 0.0))
        return {};
    return 100.0 * (1.0 - solution.certificate.objective / *measured.objective);
}

}  // namespace camopt
