// SPDX-License-Identifier: MIT
#include "core/text/number_parsing.hpp"
#include "core/units.hpp"
#include "profiles/inverse/guide_points.hpp"
#include "profiles/inverse/node_method.hpp"
#include "studies/papers/paper_000_parts.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace camopt::feeding_paper {

namespace {

using units::degree, units::inch;
constexpr double gap = std::numeric_limits<double>::quiet_NaN();

struct Stroke {
    std::string title;
    Guide guide;
    RollerStroke law;
};

std::vector<Stroke> strokes() {
    const RollerLaw law = roller_law();
    return {{"forward", make_g1_guide(forward_guide()), law.strokes()[0]},
            {"return", make_g1_guide(return_guide()), law.strokes()[1]}};
}

/// A quantity over the time of one stroke; where the guide's joints make it jump, the line is drawn as a
/// step.
PaperSeries over_time(const Stroke& stroke, const std::function<double(const InverseState&)>& quantity) {
    constexpr int points = 600;
    PaperSeries series{stroke.title, {}, {}};
    for (int i = 0; i <= points; ++i) {
        const double time = stroke.law.begin + (stroke.law.end - stroke.law.begin) * i / points;
        const InverseState state = inverse_state(stroke.guide, linkage(), state_of(stroke.law, time));
        series.x.push_back(time);
        series.y.push_back(state.fault == InverseFault::none ? quantity(state) : gap);
    }
    return series;
}

PaperFigure time_figure(const std::string& key, const std::string& title, const std::string& y_title,
                        const std::function<double(const InverseState&)>& quantity) {
    PaperFigure figure{key, title, "time [s]", y_title, {}};
    for (const Stroke& stroke : strokes()) figure.series.push_back(over_time(stroke, quantity));
    return figure;
}

PaperSeries printed_points(int column) {
    PaperSeries series{"printed in Table 1", {}, {}, true};
    for (const PrintedRow& row : printed_rows()) {
        series.x.push_back(instant_of(row.time));
        series.y.push_back(required_number(row.cells[static_cast<std::size_t>(column)]));
    }
    return series;
}

/// theta'' of the paper's method at its 100 steps of the forward stroke.
PaperSeries node_accelerations() {
    const Stroke forward = strokes().front();
    PaperSeries series{"forward, 101 nodes and central differences", {}, {}, true};
    const auto rows = node_method(forward.guide, forward.law, 101);
    for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
        series.x.push_back(rows[i].time);
        series.y.push_back(rows[i].body.acceleration);
    }
    return series;
}

PaperSeries points_of(const std::string& title, const std::vector<Eigen::Vector2d>& points) {
    PaperSeries series{title, {}, {}};
    for (const Eigen::Vector2d& point : points) {
        series.x.push_back(point.x() / inch);
        series.y.push_back(point.y() / inch);
    }
    return series;
}

Eigen::Vector2d turned(const Eigen::Vector2d& point, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * point.x() - s * point.y(), s * point.x() + c * point.y()};
}

/// The machine at one time of the forward stroke: guide, pin, rocker, feeder.
void add_pose(PaperFigure& figure, double time, const std::string& title) {
    const Stroke forward = strokes().front();
    const InverseState state = inverse_state(forward.guide, linkage(), state_of(forward.law, time));
    std::vector<Eigen::Vector2d> guide;
    for (const Eigen::Vector2d& point : guide_points(forward.guide, 200).points)
        guide.push_back(turned(point, state.body.angle));
    figure.series.push_back(points_of("guide, " + title, guide));
    const Eigen::Vector2d pivot = linkage().rocker_pivot;
    const Eigen::Vector2d feeder_point(pivot.x() + linkage().feeder_offset, state.feeder.feeder.s);
    figure.series.push_back(
        points_of("pin, rocker, feeder, " + title, {{0.0, 0.0}, state.feeder.pin, pivot, feeder_point}));
    PaperSeries roller = points_of("roller, " + title, {{state.roller.distance, 0.0}});
    roller.markers = true;
    figure.series.push_back(roller);
}

PaperFigure machine_figure() {
    PaperFigure figure{"machine",
                       "The machine at 0.100 s (L = 6.5 in) and at 0.158 s (L = 13.98 in)",
                       "x [in]",
                       "y [in]",
                       {}};
    figure.equal_scales = true;
    add_pose(figure, 0.1, "0.100 s");
    add_pose(figure, 0.158, "0.158 s");
    return figure;
}

}  // namespace

std::vector<PaperFigure> printed_figures() {
    std::vector<PaperFigure> figures = {
        machine_figure(),
        time_figure("figure_9_angle", "Fig. 9: angle of the cam", "θ [deg]",
                    [](const InverseState& s) { return s.body.angle / degree; }),
        time_figure("figure_9_velocity", "Fig. 9: angular velocity of the cam", "θ′ [rad/s]",
                    [](const InverseState& s) { return s.body.velocity; }),
        time_figure("figure_9_acceleration", "Fig. 9: angular acceleration of the cam", "θ″ [rad/s²]",
                    [](const InverseState& s) { return s.body.acceleration; }),
        time_figure("figure_10_position", "Fig. 10: place of the feeder", "Y [in]",
                    [](const InverseState& s) { return s.feeder.feeder.s / inch; }),
        time_figure("figure_10_velocity", "Fig. 10: velocity of the feeder", "Y′ [in/s]",
                    [](const InverseState& s) { return s.feeder.feeder.velocity / inch; }),
        time_figure("figure_10_acceleration", "Fig. 10: acceleration of the feeder", "Y″ [in/s²]",
                    [](const InverseState& s) { return s.feeder.feeder.acceleration / inch; })};
    for (int i = theta; i < columns; ++i)
        figures[static_cast<std::size_t>(i)].series.push_back(printed_points(i));
    figures[static_cast<std::size_t>(theta_acceleration)].series.push_back(node_accelerations());
    return figures;
}

}  // namespace camopt::feeding_paper
