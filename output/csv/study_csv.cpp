// SPDX-License-Identifier: MIT
#include "output/csv/study_csv.hpp"

#include "output/csv/csv_line.hpp"
#include "output/view/shown_units.hpp"

namespace camopt {

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

}  // namespace camopt
