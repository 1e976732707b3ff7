// SPDX-License-Identifier: MIT
#include "output/chart/studies/dynamics_svg.hpp"

#include "core/units.hpp"
#include "output/chart/studies/paper_figure_svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

namespace camopt {
namespace {

// Beside optimum, static optimum and reference law: those most drives offer.
constexpr std::array<std::string_view, 3> shown_laws = {"modified_sine", "polynomial_345", "cycloidal"};

bool is_shown(const TrainStudy& study, const std::string& key) {
    return key == "optimum" || key == "static_optimum" || key == study.scene.objective.reference.law ||
           std::ranges::find(shown_laws, key) != shown_laws.end();
}

PaperFigure over_speed(const TrainStudy& study, const char* title, const char* unit,
                       const std::function<double(const TrainRow&)>& value) {
    PaperFigure figure;
    figure.title = title;
    figure.x_title = "speed of the cam, rpm";
    figure.y_title = unit;
    const std::size_t count = study.speeds.size();
    for (std::size_t i = 0; i < study.motions.size(); ++i) {
        if (!is_shown(study, study.motions[i].first)) continue;
        PaperSeries series;
        series.title = study.motions[i].second;
        for (std::size_t k = 0; k < count; ++k) {
            const TrainRow& row = study.rows[i * count + k];
            series.x.push_back(row.speed / units::revolution_per_minute);
            series.y.push_back(value(row));
        }
        figure.series.push_back(std::move(series));
    }
    return figure;
}

PaperFigure over_angle(const TrainStudy& study, const std::string& title, const char* unit,
                       const std::function<double(const TrainInstant&)>& value) {
    PaperFigure figure;
    figure.title = title;
    figure.x_title = "cam angle from the beginning of the rise, deg";
    figure.y_title = unit;
    for (const TrainHistory& history : study.histories) {
        PaperSeries series;
        const auto named =
            std::ranges::find(study.motions, history.motion, &std::pair<std::string, std::string>::first);
        series.title = named->second;
        for (const TrainInstant& instant : history.instants) {
            series.x.push_back(instant.x * study.scene.motion.unit_angle() / units::degree);
            series.y.push_back(value(instant));
        }
        figure.series.push_back(std::move(series));
    }
    return figure;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> dynamics_pictures(const TrainStudy& study) {
    const MotionSpec& motion = study.scene.motion;
    const bool angle = motion.lift_is_angle;
    const double amplitude = angle ? motion.lift / (1e-3 * units::degree) : motion.lift / 1e-6;
    const char* const amplitude_unit = angle ? "mdeg" : "µm";
    const char* const acceleration_unit = angle ? "rad/s²" : "m/s²";
    const auto physical = [&](double value, double speed) {
        return value * motion.lift * speed * speed / (motion.unit_angle() * motion.unit_angle());
    };
    std::vector<std::pair<std::string, std::string>> pictures;
    const auto add = [&](const char* name, const PaperFigure& figure) {
        pictures.emplace_back(name, paper_figure_svg(figure));
    };
    add("residual_over_speed.svg",
        over_speed(study, "Residual vibration after one rise from rest", amplitude_unit,
                   [&](const TrainRow& row) { return row.residual * amplitude; }));
    add("acceleration_over_speed.svg",
        over_speed(study, "Largest acceleration of the output during the rise", acceleration_unit,
                   [&](const TrainRow& row) { return physical(row.peak_acceleration, row.speed); }));
    if (study.histories.empty()) return pictures;
    const std::string at =
        fmt::format(" at {:.6g} rpm", study.histories.front().speed / units::revolution_per_minute);
    const double speed = study.histories.front().speed;
    add("deflection.svg",
        over_angle(study, "Output minus cam path" + at, amplitude_unit,
                   [&](const TrainInstant& one) { return (one.output - one.input) * amplitude; }));
    add("acceleration.svg",
        over_angle(study, "Acceleration of the output" + at, acceleration_unit,
                   [&](const TrainInstant& one) { return physical(one.acceleration, speed); }));
    add("force.svg", over_angle(study, "Force of the train on the cam" + at, angle ? "N m" : "N",
                                [](const TrainInstant& one) { return one.force; }));
    return pictures;
}

}  // namespace camopt
