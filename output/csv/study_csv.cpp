// SPDX-License-Identifier: MIT
#include "output/csv/study_csv.hpp"

#include "output/csv/csv_line.hpp"
#include "output/view/shown_units.hpp"
#include "output/words/study_text.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

/// The limits of the scene, from the first row that has been judged.
std::vector<std::string> limit_keys(const Comparison& comparison) {
    std::vector<std::string> keys;
    const auto judged =
        std::ranges::find_if(comparison.rows, [](const auto& row) { return row.misfit.empty(); });
    if (judged == comparison.rows.end()) return keys;
    for (const LimitOutcome& outcome : judged->limits) keys.push_back(outcome.reached.key);
    return keys;
}

/// Of a scene with a motor.
constexpr std::array motor_titles = {"motor_torque_nm", "motor_torque_rms_nm", "motor_speed_rpm"};

void add_figures(CsvLine& line, const ComparisonRow& row, std::size_t limits, bool motor) {
    if (!row.misfit.empty()) {
        line.blank(2 + cost_figure_count + static_cast<int>(limits + (motor ? motor_titles.size() : 0)));
        return;
    }
    line.number(row.objective).number(row.loss_percent);
    for (const CostTerm& term : cost_terms()) line.number(term.measured.of(row.peaks));
    if (motor && row.drive)
        line.number(row.drive->torque.value)
            .number(row.drive->rms_torque)
            .number(rpm_shown.of(row.drive->speed.value));
    else if (motor)
        line.blank(static_cast<int>(motor_titles.size()));
    for (const LimitOutcome& outcome : row.limits) {
        const double worst = outcome.reached.worst;
        line.number(outcome.reached.no_contact || std::isnan(worst) ? std::nullopt : std::optional(worst));
    }
}

}  // namespace

std::string dynamics_csv(const TrainStudy& study) {
    CsvLine titles;
    for (const char* title : {"motion", "stroke", "speed_rpm", "frequency_ratio", "residual",
                              "peak_deflection", "peak_acceleration", "lifts_off"})
        titles.words(title);
    titles.words(study.scene.motion.lift_is_angle ? "least_force_nm" : "least_force_n");
    std::string text = titles.finish();
    for (const TrainRow& row : study.rows)
        text += CsvLine()
                    .words(row.motion)
                    .count(row.stroke)
                    .number(rpm_shown.of(row.speed))
                    .number(row.frequency_ratio)
                    .number(row.residual)
                    .number(row.peak_deflection)
                    .number(row.peak_acceleration)
                    .count(row.lifts_off() ? 1 : 0)
                    .number(row.least_force)
                    .finish();
    return text;
}

std::string history_csv(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    const bool angle = motion.lift_is_angle;
    const double lift = (angle ? degrees_shown : millimetres_shown).of(motion.lift);
    CsvLine titles;
    for (const char* title : {"motion", "speed_rpm", "theta_deg"}) titles.words(title);
    titles.words(angle ? "input_deg" : "input_mm").words(angle ? "output_deg" : "output_mm");
    titles.words(angle ? "output_rad_s2" : "output_m_s2").words(angle ? "force_nm" : "force_n");
    std::string text = titles.finish();
    for (const TrainHistory& history : study.histories) {
        const double per_second = history.speed / motion.unit_angle();
        for (const TrainInstant& one : history.instants)
            text += CsvLine()
                        .words(history.motion)
                        .number(rpm_shown.of(history.speed))
                        .number(degrees_shown.of(one.x * motion.unit_angle()))
                        .number(one.input * lift)
                        .number(one.output * lift)
                        .number(one.acceleration * motion.lift * per_second * per_second)
                        .number(one.force)
                        .finish();
    }
    return text;
}

std::string comparison_csv(const Comparison& comparison) {
    const std::vector<std::string> keys = limit_keys(comparison);
    CsvLine titles;
    for (const char* title : {"law", "title", "fits", "feasible", "objective", "loss_percent"})
        titles.words(title);
    for (const CostTerm& term : cost_terms()) titles.words(term.name());
    const bool motor = comparison.optimum.scene.drive.has_value();
    for (const char* title : motor_titles)
        if (motor) titles.words(title);
    for (const std::string& key : keys) titles.words(key);
    for (const char* title : {"base_radius_needed_mm", "broken", "note"}) titles.words(title);
    std::string text = titles.finish();
    for (const ComparisonRow& row : comparison.rows) {
        CsvLine line;
        line.words(row.key)
            .words(row_title(row))
            .count(row.misfit.empty() ? 1 : 0)
            .count(row.feasible ? 1 : 0);
        add_figures(line, row, keys.size(), motor);
        const bool has_radius = row.base && row.base->radius;
        line.number(has_radius ? std::optional(millimetres_shown.of(*row.base->radius)) : std::nullopt);
        line.words(fmt::format("{}", fmt::join(broken_limits(row), "; ")));
        std::string note = row.misfit;
        if (row.base && !row.base->radius) note = "no base radius tried suffices: " + row.base->broken;
        text += line.words(note).finish();
    }
    return text;
}

}  // namespace camopt
