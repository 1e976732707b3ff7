// SPDX-License-Identifier: MIT
#include "bindings/c/handles.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

namespace camopt::c {

double number_or_absent(const std::optional<double>& value) {
    return value.value_or(absent_number);
}

double finite_or_absent(double value) {
    return std::isfinite(value) ? value : absent_number;
}

void check_size(std::size_t size, std::size_t least, const char* name) {
    if (size < least)
        throw Failure(
            CAMOPT_ERROR_ARGUMENT,
            fmt::format("{}: found size = {}; allowed: sizeof of the struct, {} or more", name, size, least));
}

void check_index(std::size_t index, std::size_t count, const char* name) {
    if (index < count) return;
    throw Failure(CAMOPT_ERROR_ARGUMENT,
                  count == 0 ? fmt::format("{}: found {}; there is none", name, index)
                             : fmt::format("{}: found {}; allowed: 0 to {}", name, index, count - 1));
}

namespace {

using units::degree, units::millimetre;

camopt_summary summary_of(const Solution& solution) {
    const Certificate& certificate = solution.certificate;
    const MotionSpec& motion = solution.scene.motion;
    camopt_summary summary{};
    summary.verdict = verdict_of(certificate.verdict);
    summary.reason = name_of(certificate.reason);
    summary.has_motion = solution.motion ? 1 : 0;
    summary.has_cam = solution.cam ? 1 : 0;
    summary.interrupted = solution.solver.termination == Termination::interrupted ? 1 : 0;
    summary.objective = solution.motion ? finite_or_absent(certificate.objective) : absent_number;
    summary.lower_bound = number_or_absent(certificate.lower_bound);
    summary.gap = number_or_absent(certificate.gap);
    summary.any_curve = solution.any_curve_limit ? solution.any_curve_limit->objective : absent_number;
    summary.violation = finite_or_absent(certificate.worst_violation);
    summary.begin = solution.motion ? solution.motion->begin() : 0.0;
    summary.end = solution.motion ? solution.motion->end() : motion.length();
    summary.rise_deg = motion.unit_angle() / degree;
    summary.lift = motion.lift / (motion.lift_is_angle ? degree : millimetre);
    summary.lift_is_angle = motion.lift_is_angle ? 1 : 0;
    summary.speed_rpm = motion.speed ? *motion.speed / units::revolution_per_minute : absent_number;
    summary.iterations = solution.solver.iterations;
    summary.exchange_rounds = solution.solver.exchange_rounds;
    summary.seconds_total = solution.seconds_total;
    summary.seconds_solve = solution.seconds_solve;
    return summary;
}

camopt_peaks peaks_of(const Peaks& peaks) {
    return {sizeof(camopt_peaks),  peaks.velocity.value, peaks.velocity.at,      peaks.acceleration.value,
            peaks.acceleration.at, peaks.jerk.value,     peaks.jerk.at,          peaks.torque.value,
            peaks.torque.at,       peaks.rms_velocity,   peaks.rms_acceleration, peaks.rms_jerk};
}

/// Those that the cam has; names live as long as the handle.
std::vector<camopt_parameter> parameters_of(const camopt_solution& handle) {
    std::vector<camopt_parameter> all;
    if (!handle.solution.cam) return all;
    const std::vector<double>& numbers = handle.solution.cam->cam.dimensions;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const CamDimension& dimension = handle.solution.scene.cam->dimensions[i];
        if (dimension.value.key.empty()) continue;
        all.push_back({sizeof(camopt_parameter), dimension.name.c_str(), dimension.is_angle ? "deg" : "mm",
                       numbers[i] / (dimension.is_angle ? degree : millimetre),
                       dimension.value.is_variable() ? 1 : 0});
    }
    const Scene& scene = handle.solution.scene;
    const bool swings = scene.motion.lift_is_angle;
    if (scene.forces && scene.forces->preload_range)
        all.push_back({sizeof(camopt_parameter), "preload", swings ? "N m" : "N", scene.forces->preload, 1});
    if (scene.forces && scene.forces->spring_rate_range)
        all.push_back({sizeof(camopt_parameter), "spring_rate", swings ? "N m/rad" : "N/m",
                       scene.forces->spring_rate, 1});
    return all;
}

camopt_constraint constraint_of(const ConstraintReport& report) {
    return {sizeof(camopt_constraint),
            report.name.c_str(),
            report.key.c_str(),
            report.unit.c_str(),
            report.limit,
            report.worst,
            report.at,
            report.active ? 1 : 0,
            report.no_contact ? 1 : 0};
}

camopt_relaxation relaxation_of(const Relaxation& relaxation) {
    return {sizeof(camopt_relaxation),
            relaxation.key.c_str(),
            relaxation.given,
            number_or_absent(relaxation.needed),
            number_or_absent(relaxation.solved),
            relaxation.ruled_out ? 1 : 0,
            relaxation.also.size()};
}

/// list: makes the entries of a handle; `entry` is filled with one of them.
template <class Struct, class List>
camopt_error entry_at(const camopt_solution* solution, std::size_t index, Struct* entry, List list) {
    return guarded([&] {
        require(solution, "solution");
        require(entry, "the struct to fill");
        const auto& entries = list(*solution);
        check_index(index, entries.size(), "index");
        fill(entry, entries[index], "the struct to fill");
    });
}

template <class List>
camopt_error count_of(const camopt_solution* solution, std::size_t* count, List list) {
    return guarded([&] {
        require(solution, "solution");
        require(count, "count");
        *count = list(*solution).size();
    });
}

template <class Report, class Convert>
auto converted(const std::vector<Report>& reports, Convert convert) {
    std::vector<decltype(convert(reports.front()))> all(reports.size());
    std::ranges::transform(reports, all.begin(), convert);
    return all;
}

auto constraints_of(const camopt_solution& handle) {
    return converted(handle.solution.constraints, constraint_of);
}

auto relaxations_of(const camopt_solution& handle) {
    return converted(handle.solution.relaxation, relaxation_of);
}

}  // namespace

camopt_verdict verdict_of(Verdict verdict) {
    static_assert(CAMOPT_OPTIMAL == static_cast<int>(Verdict::optimal) &&
                  CAMOPT_FAILED == static_cast<int>(Verdict::failed));  // the same verdicts in the same order
    return static_cast<camopt_verdict>(verdict);
}

const MotionChain& motion_of(const camopt_solution* solution) {
    require(solution, "solution");
    if (!solution->solution.motion)
        throw Failure(CAMOPT_ERROR_ABSENT, std::string("the solution has no motion: its verdict is ") +
                                               name_of(solution->solution.certificate.verdict));
    return *solution->solution.motion;
}

}  // namespace camopt::c

using namespace camopt::c;

extern "C" {

const char* camopt_verdict_name(camopt_verdict verdict) {
    using camopt::Verdict;
    for (const Verdict known :
         {Verdict::optimal, Verdict::local, Verdict::feasible, Verdict::infeasible, Verdict::failed})
        if (verdict_of(known) == verdict) return camopt::name_of(known);
    return "unknown";
}

camopt_error camopt_solution_summary(const camopt_solution* solution, camopt_summary* summary) {
    return guarded([&] {
        require(solution, "solution");
        fill(summary, summary_of(solution->solution), "summary");
    });
}

camopt_error camopt_solution_peaks(const camopt_solution* solution, camopt_peaks* peaks) {
    return guarded([&] {
        (void)motion_of(solution);
        fill(peaks, peaks_of(solution->solution.peaks), "peaks");
    });
}

camopt_error camopt_solution_motion_peaks(const camopt_solution* solution, camopt_peaks* peaks) {
    return guarded([&] {
        (void)motion_of(solution);
        fill(peaks, peaks_of(solution->solution.motion_peaks), "peaks");
    });
}

camopt_error camopt_parameter_count(const camopt_solution* solution, size_t* count) {
    return count_of(solution, count, parameters_of);
}

camopt_error camopt_parameter_at(const camopt_solution* solution, size_t index, camopt_parameter* parameter) {
    return entry_at(solution, index, parameter, parameters_of);
}

camopt_error camopt_constraint_count(const camopt_solution* solution, size_t* count) {
    return count_of(solution, count, constraints_of);
}

camopt_error camopt_constraint_at(const camopt_solution* solution, size_t index,
                                  camopt_constraint* constraint) {
    return entry_at(solution, index, constraint, constraints_of);
}

camopt_error camopt_relaxation_count(const camopt_solution* solution, size_t* count) {
    return count_of(solution, count, relaxations_of);
}

camopt_error camopt_relaxation_at(const camopt_solution* solution, size_t index,
                                  camopt_relaxation* relaxation) {
    return entry_at(solution, index, relaxation, relaxations_of);
}

camopt_error camopt_relaxation_also(const camopt_solution* solution, size_t index, size_t which,
                                    camopt_companion_change* change) {
    return entry_at(solution, which, change, [index](const camopt_solution& of) {
        check_index(index, of.solution.relaxation.size(), "index");
        return converted(of.solution.relaxation[index].also, [](const camopt::CompanionChange& one) {
            return camopt_companion_change{sizeof(camopt_companion_change), one.key.c_str(), one.given,
                                           one.solved};
        });
    });
}
}
