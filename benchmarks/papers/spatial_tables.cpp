// SPDX-License-Identifier: MIT
#include "benchmarks/papers/spatial_tables.hpp"

#include "benchmarks/papers/spatial_methods.hpp"
#include "core/deadline.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>

namespace camopt::spatial_tables {

namespace {

using units::degree;
using units::millimetre;

constexpr double modified_sine_ramp = 0.125;
constexpr int figure_angles = 721;
constexpr int method_angles = 721;

std::vector<double> three_heights(const SpatialCam& cam) {
    return {0.0, 0.5 * cam.roller_length, cam.roller_length};
}

std::vector<double> figure_places(const FollowerMotion& motion) {
    return even_angles(motion, figure_angles);
}

std::string height_words(double height) {
    return fmt::format("h = {:.6g} mm", height / millimetre);
}

/// A row of the study of accuracy against points.
struct SpatialForwardCheckRow {
    int points = 0;                   ///< of one section
    double deviation_positive = 0.0;  ///< flank +1
    double deviation_negative = 0.0;  ///< flank −1
    double travel = 0.0;              ///< over the angles checked
    double seconds = 0.0;             ///< generation and check of both flanks
};

/// Sections at the near and the far end of the roller; about `count` points over the motion, its breakpoints
/// among them.
SpatialForwardCheckRow forward_check_row(const CamFlanks& cam, const FollowerMotion& motion, int count) {
    const Stopwatch watch;
    const FlankGrid grid = flank_grid(cam, motion, FlankSampling{.sections = 2, .angles = count});
    const auto sections = sections_of(grid);
    const std::size_t half = sections.size() / 2;
    SpatialForwardCheckRow row;
    for (const bool positive : {true, false}) {
        SpatialForwardCheckInput input;
        const auto first = sections.begin() + static_cast<std::ptrdiff_t>(positive ? 0 : half);
        input.sections.assign(first, first + static_cast<std::ptrdiff_t>(half));
        input.breaks = grid.breaks;
        input.follower = cam;
        input.designed = [&motion](double theta) { return motion.state(theta).s; };
        input.begin = motion.begin();
        input.end = motion.end();
        const SpatialForwardCheckResult result = spatial_forward_check(input);
        (positive ? row.deviation_positive : row.deviation_negative) = result.deviation;
        row.points = result.points;
        if (positive) row.travel = result.travel;
    }
    row.seconds = watch.seconds();
    return row;
}

}  // namespace

FollowerMotion modified_sine_rise(const Rise& rise) {
    const std::shared_ptr<const Law> law = make_law("modified_sine", std::array{modified_sine_ramp});
    FollowerMotion motion;
    motion.state = [law, rise](double theta) -> FollowerState {
        const double x = (theta - rise.from) / rise.width;
        if (x <= 0.0) return {};
        if (x >= 1.0) return {rise.lift, 0.0, 0.0};
        const auto y = law->at(x).derivative;
        const double rate = rise.lift / rise.width;
        return {rise.lift * y[0], rate * y[1], rate / rise.width * y[2]};
    };
    motion.breakpoints = {rise.from, rise.from + modified_sine_ramp * rise.width,
                          rise.from + (1.0 - modified_sine_ramp) * rise.width, rise.from + rise.width};
    if (rise.begin < rise.from) motion.breakpoints.insert(motion.breakpoints.begin(), rise.begin);
    // A dwell of rounding is none.
    if (rise.end > motion.end() + 1e-12) motion.breakpoints.push_back(rise.end);
    return motion;
}

PaperTable pressure_table(const Example& example) {
    PaperTable table{"pressure_angle",
                     "Largest pressure angle along the roller",
                     "The paper gives none.",
                     {{"height_mm", "height on the roller", "mm", 6},
                      {"pressure_angle_deg", "largest |φ|", "deg", 12},
                      {"theta_deg", "at cam angle", "deg", 9}},
                     {}};
    for (const double height : three_heights(example.cam)) {
        const SpatialExtreme worst = largest_pressure_angle(example.cam, example.motion, height);
        table.rows.push_back({height / millimetre, worst.value / degree, worst.theta / degree});
    }
    return table;
}

PaperTable undercut_table(const Example& example) {
    const SpatialCam& cam = example.cam;
    PaperTable table{"undercut",
                     "Undercut: least g, critical dimensions at the roller's far end",
                     "g > 0: the flank is regular. The paper gives none of this.",
                     {{"flank", "flank", ""},
                      {"least_g", "least g", "", 12},
                      {"theta_deg", "at cam angle", "deg", 9},
                      {"height_mm", "at height", "mm", 6},
                      {"critical_roller_radius_mm", "critical roller radius", "mm", 12},
                      {"critical_center_distance_mm", "critical centre distance", "mm", 12}},
                     {}};
    for (const int flank : {1, -1}) {
        const RollerStation far_end{cam.roller_length, flank};
        const SpatialExtreme worst = least_undercut(cam, example.motion, flank, {0.0, cam.roller_length});
        std::vector<PaperCell> row = {flank > 0 ? std::string("+") : std::string("-"), worst.value,
                                      worst.theta / degree, worst.height / millimetre};
        const auto radius = critical_roller_radius(cam, example.motion, far_end);
        const auto distance = critical_center_distance(cam, example.motion, far_end);
        for (const auto& critical : {radius, distance})
            row.push_back(cell_of(critical ? std::optional(critical->value / millimetre) : std::nullopt));
        table.rows.push_back(std::move(row));
    }
    const Interference found = interference(cam, example.motion, {});
    table.introduction += fmt::format(
        " A cutter of the roller's size and length enters {} flank points nowhere by more than {:.0e} mm.",
        found.points, std::max(found.depth, 1e-16) / millimetre);
    return table;
}

double method_difference_mm(const Example& example) {
    double largest = 0.0;
    for (const double theta : even_angles(example.motion, method_angles))
        for (const double height : three_heights(example.cam))
            for (const int flank : {1, -1}) {
                const FollowerState state = example.motion.state(theta);
                const RollerStation station{height, flank};
                const Eigen::Vector3d difference =
                    envelope_contact(example.cam, theta, state, station) -
                    relative_velocity_contact(example.cam, theta, state, station);
                largest = std::max(largest, difference.norm());
            }
    return largest / millimetre;
}

PaperTable forward_table(const Example& example, const std::vector<int>& points,
                         const PaperProgress& finished) {
    PaperTable table{"forward_check",
                     "Forward check: the points of the flanks drive the follower",
                     "Each section of each flank alone, at both ends of the roller, tracked over the turn; "
                     "the simulation knows points and the follower's dimensions only.",
                     {{"points", "points a section", "", 6},
                      {"deviation_positive_rad", "largest error, flank +", "rad", 3},
                      {"deviation_negative_rad", "flank -", "rad", 3},
                      {"travel_deg", "follower turns in one revolution", "deg", 12},
                      {"seconds", "seconds", "s", 2}},
                     {}};
    for (const int count : points) {
        const SpatialForwardCheckRow row = forward_check_row(example.cam, example.motion, count);
        table.rows.push_back({static_cast<double>(row.points), row.deviation_positive, row.deviation_negative,
                              row.travel / degree, row.seconds});
        if (finished) finished(fmt::format("forward check with {} points a section", row.points));
    }
    return table;
}

PaperFigure displacement_figure(const Example& example, const std::string& key, const std::string& title) {
    PaperFigure figure{
        key, title, "cam angle, deg", "displacement, deg; 50 x velocity; 50 x acceleration", {}};
    constexpr double magnified = 50.0;  // so that all three are seen
    PaperSeries s{"displacement", {}, {}}, velocity{"50 x velocity", {}, {}},
        acceleration{"50 x acceleration, 1/rad", {}, {}};
    for (const double theta : figure_places(example.motion)) {
        const FollowerState state = example.motion.state(theta);
        for (PaperSeries* series : {&s, &velocity, &acceleration}) series->x.push_back(theta / degree);
        s.y.push_back(state.s / degree);
        velocity.y.push_back(magnified * state.velocity);
        acceleration.y.push_back(magnified * state.acceleration);
    }
    figure.series = {s, velocity, acceleration};
    return figure;
}

PaperFigure pressure_figure(const Example& example) {
    PaperFigure figure{"pressure_angle_curves",
                       "Pressure angle along the roller",
                       "cam angle, deg",
                       "pressure angle, deg",
                       {}};
    for (const double height : three_heights(example.cam)) {
        PaperSeries series{height_words(height), {}, {}};
        for (const double theta : figure_places(example.motion)) {
            const SpatialPoint point =
                spatial_point(example.cam, theta, example.motion.state(theta), {height, 1});
            series.x.push_back(theta / degree);
            series.y.push_back(point.pressure_angle / degree);
        }
        figure.series.push_back(series);
    }
    return figure;
}

PaperFigure undercut_figure(const Example& example) {
    PaperFigure figure{"undercut_curves", "Undercut function g of both flanks", "cam angle, deg", "g", {}};
    for (const int flank : {1, -1})
        for (const double height : {0.0, example.cam.roller_length}) {
            PaperSeries series{
                fmt::format("flank {}, {}", flank > 0 ? "+" : "-", height_words(height)), {}, {}};
            for (const double theta : figure_places(example.motion)) {
                series.x.push_back(theta / degree);
                series.y.push_back(
                    spatial_point(example.cam, theta, example.motion.state(theta), {height, flank}).undercut);
            }
            figure.series.push_back(series);
        }
    return figure;
}

PaperFigure unrolled_figure(const Example& example, const std::string& key, const std::string& title) {
    PaperFigure figure{key, title, "angle around the cam, deg", "along the cam's axis, mm", {}};
    for (const int flank : {1, -1})
        for (const double height : {0.0, example.cam.roller_length}) {
            PaperSeries series{
                fmt::format("flank {}, {}", flank > 0 ? "+" : "-", height_words(height)), {}, {}};
            double before = 0.0;
            for (const double theta : figure_places(example.motion)) {
                const Eigen::Vector3d point =
                    spatial_point(example.cam, theta, example.motion.state(theta), {height, flank}).contact;
                double angle = std::atan2(point.y(), point.x()) / degree;
                // Unrolled without a seam.
                if (!series.x.empty()) angle += 360.0 * std::round((before - angle) / 360.0);
                before = angle;
                series.x.push_back(angle);
                series.y.push_back(point.z() / millimetre);
            }
            figure.series.push_back(series);
        }
    return figure;
}

}  // namespace camopt::spatial_tables
