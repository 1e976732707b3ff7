// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_000_parts.hpp"

#include "benchmarks/papers/guide.hpp"
#include "benchmarks/papers/paper_guide.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"

namespace camopt::feeding_paper {

namespace {

using units::degree, units::inch;
constexpr double turning_time = 0.158;   // s, forward stroke
constexpr double sample_step = 0.00158;  // s, its hundredth part
constexpr double guide_end = 14.0;       // inch; the roller turns at 13.982

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

const ColumnInfo& column_info(int column) {
    static constexpr std::array<ColumnInfo, columns> table = {{{"L", "in", inch},
                                                               {"θ", "deg", degree},
                                                               {"θ′", "rad/s", 1.0},
                                                               {"θ″", "rad/s²", 1.0},
                                                               {"Y", "in", inch},
                                                               {"Y′", "in/s", inch},
                                                               {"Y″", "in/s²", inch}}};
    return table[static_cast<std::size_t>(column)];
}

std::span<const PrintedRow> printed_rows() {
    static constexpr std::array<PrintedRow, 13> table = {{
        {"0.0", {"1.500", "0.00", "0.000", "0.0", "-0.656", "0.0", "0"}, false},
        {"0.087", {"5.276", "0.00", "-0.043", "-143.4", "-0.656", "0.67", "2236"}, true},
        {"0.128", {"9.689", "-6.00", "-4.49", "-107.1", "1.125", "86.0", "2097"}, true},
        {"0.130", {"9.900", "-6.90", "-4.51", "278.4", "1.256", "80.0", "-479"}, true},
        {"0.150", {"12.765", "-9.00", "-0.157", "168.1", "2.042", "2.8", "-2985"}, true},
        {"0.152", {"13.000", "-9.00", "0.00", "0.0", "2.039", "0.0", "0"}, false},
        {"0.163", {"12.765", "-9.00", "0.00", "0.0", "2.039", "0.0", "0"}, false},
        {"0.164", {"12.529", "-8.98", "0.332", "382.8", "2.033", "-5.9", "-6800"}, true},
        {"0.178", {"9.488", "-6.21", "7.193", "652.4", "1.171", "-127.5", "-11160"}, true},
        {"0.179", {"9.290", "-5.78", "7.344", "-254.0", "1.039", "-129.7", "4978"}, true},
        {"0.205", {"5.000", "0.00", "0.016", "-345.9", "-0.656", "-0.3", "5395"}, true},
        {"0.206", {"4.875", "0.00", "0.00", "0.0", "-0.656", "0.0", "0"}, false},
        {"0.258", {"1.500", "0.00", "0.00", "0.0", "-0.656", "0.0", "0"}, false},
    }};
    return table;
}

std::span<const Misprint> misprints() {
    static constexpr std::array<Misprint, 9> table = {{
        {"0.128", theta, -6.06, -6.05, "goes with Y = 1.125 and with arc 1"},
        {"0.128", theta_velocity, -4.86, -4.85, "Y′ = 86.0 over the slope dY/dθ"},
        {"0.128", feeder_acceleration, 2085.0, 2090.0, "every rocker that fits; perhaps 2087"},
        {"0.130", distance, 9.8925, 9.8935, "the roller's time base; arcs fit far worse with 9.900"},
        {"0.130", theta, -6.49, -6.47, "goes with Y = 1.256"},
        {"0.130", feeder_acceleration, -4850.0, -4750.0, "a lost digit"},
        {"0.150", theta, -9.0145, -9.0055,
         "Y = 2.042 of this row; the other end rows have 2.039: arc 2 is about 0.01 deg off the 9 deg line"},
        {"0.152", distance, 13.0025, 13.0035, "the roller's time base"},
        {"0.205", distance, 5.0055, 5.0065, "the roller's time base"},
    }};
    return table;
}

RollerLaw roller_law() {
    return RollerLaw({{0.0, turning_time, 0.0, 1.5 * inch, 0.0, 1000.0 * inch},
                      {turning_time, 0.258, 0.258, 1.5 * inch, 0.0, 2496.4 * inch}});
}

G1GuideDimensions forward_guide() {
    return {5.24986 * inch, 9.9190 * inch, 10.6696 * inch, 9.017 * degree, 1.5 * inch, guide_end * inch};
}

G1GuideDimensions return_guide() {
    return {4.99997 * inch, 10.0922 * inch, 11.7604 * inch, 8.9820 * degree, 1.5 * inch, guide_end * inch};
}

FeederLinkage linkage() {
    return {15.0 * inch, 9.0 * degree, {18.3756 * inch, 0.93306 * inch}, 4.0 * inch};
}

double instant_of(std::string_view time) {
    const double printed = required_number(time);
    return printed < turning_time ? sample_step * std::round(printed / sample_step) : printed;
}

std::array<double, columns> computed_row(const PrintedRow& row) {
    const double time = instant_of(row.time);
    const Guide guide = make_g1_guide(time < turning_time ? forward_guide() : return_guide());
    const InverseState state = inverse_state(guide, linkage(), roller_law().at(time));
    const FollowerState& y = state.feeder.feeder;
    std::array<double, columns> values = {state.roller.distance,
                                          state.body.angle,
                                          state.body.velocity,
                                          state.body.acceleration,
                                          y.s,
                                          y.velocity,
                                          y.acceleration};
    for (int i = 0; i < columns; ++i) values[static_cast<std::size_t>(i)] /= column_info(i).unit_value;
    return values;
}

double half_digit(std::string_view printed) {
    const auto point = printed.find('.');
    const auto decimals = point == std::string_view::npos ? 0 : static_cast<int>(printed.size() - point - 1);
    return 0.5 * std::pow(10.0, -decimals);
}

Agreement agreement() {
    constexpr double rounding = 1.0 + 1e-9;  // a value on the edge of the rounding is inside
    Agreement result;
    for (const PrintedRow& row : printed_rows()) {
        if (!row.moving) continue;
        const auto values = computed_row(row);
        for (int i = theta; i < columns; ++i) {
            const std::string_view words = row.cells[static_cast<std::size_t>(i)];
            const double printed = required_number(words), half = half_digit(words);
            const double difference = std::abs(values[static_cast<std::size_t>(i)] - printed);
            ++result.entries;
            if (difference <= half * rounding) ++result.rounded;
            if (difference <= 5.0 * half || difference <= 0.003 * std::abs(printed)) ++result.close;
        }
    }
    return result;
}

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
