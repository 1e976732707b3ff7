// SPDX-License-Identifier: MIT
#include "output/chart/studies/study_svg.hpp"

#include "output/chart/chart.hpp"
#include "output/papers/paper_output.hpp"
#include "output/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

// Beside optimum, static optimum and reference law: those most drives offer.
constexpr std::array<std::string_view, 3> shown_laws = {"modified_sine", "polynomial_345", "cycloidal"};

bool is_shown(const TrainStudy& study, const std::string& key) {
    return key == "optimum" || key == "static_optimum" || key == study.scene.objective.reference.law ||
           std::ranges::find(shown_laws, key) != shown_laws.end();
}

/// One series a motion that is shown, of its worst stroke at each speed.
PaperFigure over_speed(const TrainStudy& study, const char* title, const std::string& unit,
                       const std::function<double(const TrainRow&)>& value) {
    PaperFigure figure{"", title, "speed of the cam, rpm", unit, {}};
    const std::size_t count = study.speeds.size();
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        if (!is_shown(study, study.motions[i].first)) continue;
        PaperSeries& series = figure.series.emplace_back(PaperSeries{study.motions[i].second, {}, {}});
        for (std::size_t k = 0; k < count; ++k) {
            series.x.push_back(rpm_shown.of(study.speeds[k]));
            double& worst = series.y.emplace_back(0.0);
            for (std::size_t row = i * count + k; row < study.rows.size();
                 row += study.motions.size() * count)
                worst = std::max(worst, value(study.rows[row]));
        }
    }
    return figure;
}

PaperFigure over_angle(const TrainStudy& study, const std::string& title, const std::string& unit,
                       const std::function<double(const TrainInstant&)>& value) {
    PaperFigure figure{"", title, "cam angle from the beginning of the first stroke, deg", unit, {}};
    for (const TrainHistory& history : study.histories) {
        const auto named =
            std::ranges::find(study.motions, history.motion, &std::pair<std::string, std::string>::first);
        PaperSeries& series = figure.series.emplace_back(PaperSeries{named->second, {}, {}});
        for (const TrainInstant& instant : history.instants) {
            series.x.push_back(degrees_shown.of(instant.x * study.scene.motion.unit_angle()));
            series.y.push_back(value(instant));
        }
    }
    return figure;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    const ShownUnits shown = shown_units(study.scene);
    const double amplitude = shown.vibration.of(motion.lift);
    const std::string& amplitude_unit = shown.vibration.name;
    const MotionUnit& acceleration_unit = shown.motion[2].first;
    const auto physical = [&](double value, double speed) {
        return acceleration_unit.of(value * motion.lift * speed * speed /
                                    (motion.unit_angle() * motion.unit_angle()));
    };
    std::vector<std::pair<std::string, std::string>> pictures;
    const auto add = [&](const char* name, const PaperFigure& figure) {
        pictures.emplace_back(name, paper_figure_svg(figure));
    };
    add("residual_over_speed.svg",
        over_speed(study, "Residual vibration after a stroke from rest", amplitude_unit,
                   [&](const TrainRow& row) { return row.residual * amplitude; }));
    add("acceleration_over_speed.svg",
        over_speed(study, "Largest acceleration of the output during a stroke", acceleration_unit.name,
                   [&](const TrainRow& row) { return physical(row.peak_acceleration, row.speed); }));
    if (study.histories.empty()) return pictures;
    const std::string at = fmt::format(" at {:.6g} rpm", rpm_shown.of(study.histories.front().speed));
    const double speed = study.histories.front().speed;
    add("deflection.svg",
        over_angle(study, "Output minus cam path" + at, amplitude_unit,
                   [&](const TrainInstant& one) { return (one.output - one.input) * amplitude; }));
    add("acceleration.svg",
        over_angle(study, "Acceleration of the output" + at, acceleration_unit.name,
                   [&](const TrainInstant& one) { return physical(one.acceleration, speed); }));
    add("force.svg", over_angle(study, "Force of the train on the cam" + at, shown.load.name,
                                [&](const TrainInstant& one) { return shown.load.of(one.force); }));
    return pictures;
}

}  // namespace camopt
