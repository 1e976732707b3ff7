// SPDX-License-Identifier: MIT
#include "output/chart/studies/study_svg.hpp"

#include "core/units.hpp"
#include "output/chart/axis_ticks.hpp"
#include "output/chart/plot_frame.hpp"
#include "output/chart/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string_view>

namespace camopt {

namespace {

// Layout, px.
constexpr double page_width = 900, left = 84, right = 876, top = 64, bottom = 500, margin_below = 60;
constexpr double least_height = 160;  // of a plot
constexpr double legend_row = 20, legend_column = 264;
constexpr int legend_columns = 3;
constexpr int colours = 8;
constexpr double padding = 0.04;  // of the range, around the values

const char* page_style =
    ".title{font-size:16px;font-weight:600;fill:#111}.key{font-size:12px;fill:#333}"
    ".l0,.l1,.l2,.l3,.l4,.l5,.l6,.l7{fill:none;stroke-width:1.8;stroke-linejoin:round}"
    ".l0{stroke:#0b6bb5}.l1{stroke:#d1495b}.l2{stroke:#2a9d5c}.l3{stroke:#8d5fc4}"
    ".l4{stroke:#c98a10}.l5{stroke:#19a3a3}.l6{stroke:#7a5a44}.l7{stroke:#666}.p0{fill:#0b6bb5}"
    ".p1{fill:#d1495b}.p2{fill:#2a9d5c}.p3{fill:#8d5fc4}.p4{fill:#c98a10}.p5{fill:#19a3a3}"
    ".p6{fill:#7a5a44}.p7{fill:#666}";

struct Range {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;

    void take(double value) {
        lower = std::min(lower, value);
        upper = std::max(upper, value);
    }
};

bool shown(double value, bool logarithmic) {
    return std::isfinite(value) && (!logarithmic || value > 0.0);
}

/// The values' range with air around it; [0, 1] where there is no value.
Range padded(Range range, bool logarithmic) {
    if (!(range.lower <= range.upper)) return {0.0 + (logarithmic ? 0.1 : 0.0), 1.0};
    if (logarithmic) {
        range.lower = std::pow(10.0, std::floor(std::log10(range.lower)));
        range.upper = std::pow(10.0, std::ceil(std::log10(range.upper) + 1e-9));
        return range;
    }
    double air = padding * (range.upper - range.lower);
    if (!(air > 0.0)) air = range.lower == 0.0 ? 1.0 : 0.1 * std::abs(range.lower);
    return {range.lower - air, range.upper + air};
}

/// The bottom of a plot on which one unit is as long on both axes. A wide shape gets a lower plot; where that
/// is not enough, or the shape is high, the range that is too narrow is widened.
double equalised_bottom(Range& across, Range& up) {
    const double unit = (across.upper - across.lower) / (right - left);
    const double wanted = (up.upper - up.lower) / unit;
    const double height = std::clamp(wanted, least_height, bottom - top);
    const auto widen = [](Range& range, double size) {
        const double middle = 0.5 * (range.lower + range.upper);
        range = {middle - 0.5 * size, middle + 0.5 * size};
    };
    if (wanted <= height)
        widen(up, unit * height);
    else
        widen(across, (up.upper - up.lower) / height * (right - left));
    return top + height;
}

std::vector<PlotTick> ticks_of(const Range& range, bool logarithmic, int wanted) {
    if (logarithmic) {
        const double decades = std::log10(range.upper / range.lower);
        return decade_ticks(range.lower, range.upper, decades > 8.0 ? 2 : 1);
    }
    return labelled_ticks(range.lower, range.upper, wanted);
}

PlotFrame frame_of(const PaperFigure& figure) {
    Range across, up;
    for (const PaperSeries& series : figure.series) {
        for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i) {
            if (!shown(series.x[i], figure.logarithmic) || !shown(series.y[i], figure.logarithmic)) continue;
            across.take(series.x[i]);
            up.take(series.y[i]);
        }
    }
    across = padded(across, figure.logarithmic);
    up = padded(up, figure.logarithmic);
    const double plot_bottom = figure.equal_scales ? equalised_bottom(across, up) : bottom;
    PlotFrame frame;
    frame.horizontal = {across.lower, across.upper, left, right, figure.logarithmic};
    frame.vertical = {up.lower, up.upper, plot_bottom, top, figure.logarithmic};
    frame.horizontal_ticks = ticks_of(across, figure.logarithmic, 10);
    frame.vertical_ticks = ticks_of(up, figure.logarithmic, plot_bottom - top < 300 ? 4 : 8);
    frame.horizontal_title = figure.x_title;
    frame.vertical_title = figure.y_title;
    return frame;
}

void draw_series(SvgCanvas& canvas, const PlotFrame& frame, const PaperFigure& figure, std::size_t index) {
    const PaperSeries& series = figure.series[index];
    const std::string colour = std::to_string(index % colours);
    std::string path;
    bool pen_down = false;
    for (std::size_t i = 0; i < series.x.size() && i < series.y.size(); ++i) {
        if (!shown(series.x[i], figure.logarithmic) || !shown(series.y[i], figure.logarithmic)) {
            pen_down = false;
            continue;
        }
        const double x = frame.horizontal.place(series.x[i]), y = frame.vertical.place(series.y[i]);
        if (series.markers) canvas.circle(x, y, 3.2, "p" + colour);
        path += fmt::format("{}{} {}", pen_down ? 'L' : 'M', svg_number(x), svg_number(y));
        pen_down = true;
    }
    if (!series.markers && !path.empty()) canvas.path(path, "l" + colour);
}

void draw_legend(SvgCanvas& canvas, const PaperFigure& figure, double plot_bottom) {
    for (std::size_t i = 0; i < figure.series.size(); ++i) {
        const std::string colour = std::to_string(i % colours);
        const double x = left + legend_column * static_cast<double>(i % legend_columns);
        const std::size_t row = i / legend_columns;
        const double y = plot_bottom + margin_below + legend_row * static_cast<double>(row);
        if (figure.series[i].markers)
            canvas.circle(x + 12, y - 4, 3.2, "p" + colour);
        else
            canvas.line(x, y - 4, x + 24, y - 4, "l" + colour);
        canvas.text(x + 30, y, figure.series[i].title, "key");
    }
}

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

std::string paper_figure_svg(const PaperFigure& figure) {
    const std::size_t legend_rows = (figure.series.size() + legend_columns - 1) / legend_columns;
    const PlotFrame frame = frame_of(figure);
    const double page_height =
        frame.vertical.begin + margin_below + legend_row * static_cast<double>(legend_rows) + 4;
    SvgCanvas canvas(page_width, page_height, page_style, figure.title);
    canvas.rectangle(0, 0, page_width, page_height, "page");
    canvas.text(left, 34, figure.title, "title");
    draw_plot_frame(canvas, frame);
    for (std::size_t i = 0; i < figure.series.size(); ++i) draw_series(canvas, frame, figure, i);
    draw_legend(canvas, figure, frame.vertical.begin);
    return canvas.finish();
}

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
