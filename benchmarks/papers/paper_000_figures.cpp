// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_000_parts.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "profiles/sampling.hpp"

#include <Eigen/Geometry>

namespace camopt::feeding_paper {

namespace {

using units::degree, units::inch;

/// A quantity over the time of one stroke; where the guide's joints make it jump, the line is drawn as a
/// step.
PaperSeries over_time(const std::string& title, const FeederStroke& stroke,
                      const std::function<double(const FeederState&)>& quantity) {
    constexpr int points = 600;
    std::vector<double> times = stroke.joints();
    std::erase_if(times, [&](double time) { return time <= stroke.begin() || time >= stroke.end(); });
    times.insert(times.begin(), stroke.begin());
    times.push_back(stroke.end());
    PaperSeries series{title, {}, {}};
    // Time and the roller's distance grow together going out, and against each other coming back.
    const bool back = stroke.begin() > 0.0;
    for (const double time : even_places(times, points)) {
        const bool joint = std::ranges::find(times, time) != times.end();
        for (const Side side : {Side::left, Side::right}) {
            if (side == Side::left && !joint) continue;
            series.x.push_back(time);
            series.y.push_back(
                quantity(stroke.at(time, back == (side == Side::left) ? Side::right : Side::left)));
        }
    }
    return series;
}

PaperSeries printed_points(int column) {
    PaperSeries series{"printed in Table 1", {}, {}, true};
    for (const PrintedRow& row : printed_rows()) {
        series.x.push_back(instant_of(row.time));
        series.y.push_back(required_number(row.cells[static_cast<std::size_t>(column)]));
    }
    return series;
}

struct TimeFigure {
    const char *key, *title, *y_title;
    double (*quantity)(const FeederState&);
    std::optional<Column> printed = {};
};

constexpr std::array time_figures = {
    TimeFigure{"figure_7_position", "Fig. 7: position of the roller", "L [in]",
               [](const FeederState& s) { return s.roller.distance / inch; }, distance},
    TimeFigure{"figure_7_velocity", "Fig. 7: velocity of the roller", "L′ [in/s]",
               [](const FeederState& s) { return s.roller.velocity / inch; }},
    TimeFigure{"figure_7_acceleration", "Fig. 7: acceleration of the roller", "L″ [in/s²]",
               [](const FeederState& s) { return s.roller.acceleration / inch; }},
    TimeFigure{"figure_9_angle", "Fig. 9: angle of the cam", "θ [deg]",
               [](const FeederState& s) { return s.body.angle / degree; }, theta},
    TimeFigure{"figure_9_velocity", "Fig. 9: angular velocity of the cam", "θ′ [rad/s]",
               [](const FeederState& s) { return s.body.velocity; }, theta_velocity},
    TimeFigure{"figure_9_acceleration", "Fig. 9: angular acceleration of the cam", "θ″ [rad/s²]",
               [](const FeederState& s) { return s.body.acceleration; }, theta_acceleration},
    TimeFigure{"figure_10_position", "Fig. 10: position of the feeder", "Y [in]",
               [](const FeederState& s) { return s.feeder.s / inch; }, feeder},
    TimeFigure{"figure_10_velocity", "Fig. 10: velocity of the feeder", "Y′ [in/s]",
               [](const FeederState& s) { return s.feeder.velocity / inch; }, feeder_velocity},
    TimeFigure{"figure_10_acceleration", "Fig. 10: acceleration of the feeder", "Y″ [in/s²]",
               [](const FeederState& s) { return s.feeder.acceleration / inch; }, feeder_acceleration},
};

/// theta'' of the paper's method at its 100 steps of the forward stroke.
PaperSeries node_accelerations() {
    PaperSeries series{"forward, 101 nodes and central differences", {}, {}, true};
    for (const NodeRow& row : node_method(forward_stroke(), 101)) {
        series.x.push_back(row.time);
        series.y.push_back(row.body.acceleration);
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

/// The machine at one time of the forward stroke: guide, pin, rocker, feeder.
void add_pose(PaperFigure& figure, double time, const std::string& title) {
    constexpr int points = 200;
    const Solution& solution = forward_stroke().solution();
    const FeederState state = forward_stroke().at(time);
    const MotionScale scale{solution.scene.motion.lift, solution.scene.motion.unit_angle()};
    const Eigen::Rotation2D<double> turn(state.body.angle);
    std::vector<Eigen::Vector2d> guide;
    for (const MechanismPoint& point :
         mechanism_profile(solution.cam->cam, *solution.motion, scale, points).points)
        guide.emplace_back(turn * Eigen::Vector2d(point.pitch.head<2>()));
    figure.series.push_back(points_of("guide, " + title, guide));
    const FeederLinkage linkage = linkage_of(solution.cam->cam.dimensions);
    const Eigen::Vector2d tip(linkage.rocker_pivot.x() + linkage.feeder_offset, state.feeder.s);
    figure.series.push_back(
        points_of("pin, rocker, feeder, " + title,
                  {{0.0, 0.0}, pin_at(linkage, state.body.angle), linkage.rocker_pivot, tip}));
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
    add_pose(figure, turning_time, "0.158 s");
    return figure;
}

}  // namespace

std::vector<PaperFigure> printed_figures() {
    std::vector<PaperFigure> figures = {machine_figure()};
    for (const TimeFigure& row : time_figures) {
        PaperFigure figure{row.key, row.title, "time [s]", row.y_title, {}};
        figure.series.push_back(over_time("forward", forward_stroke(), row.quantity));
        figure.series.push_back(over_time("return", return_stroke(), row.quantity));
        if (row.printed) figure.series.push_back(printed_points(*row.printed));
        if (row.printed == theta_acceleration) figure.series.push_back(node_accelerations());
        figures.push_back(std::move(figure));
    }
    return figures;
}

}  // namespace camopt::feeding_paper
