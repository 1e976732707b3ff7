// SPDX-License-Identifier: MIT
#include "core/units.hpp"
#include "profiles/inverse/guide_points.hpp"
#include "profiles/inverse/node_method.hpp"
#include "studies/inverse/inverse_forward.hpp"
#include "studies/papers/paper_000_parts.hpp"

#include <chrono>
#include <string>
#include <utility>

namespace camopt::feeding_paper {

namespace {

using units::inch;
constexpr double roller_radius = 0.5 * inch;  // chosen

// Round values near the recovered ones, chosen: what the reference numbers of the tests are for.
constexpr G1GuideDimensions reference_guide{5.25 * inch,         9.92 * inch, 10.67 * inch,
                                            9.0 * units::degree, 1.5 * inch,  14.0 * inch};

double microseconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

/// Wall time of the exact motion at as many instants.
double exact_microseconds(const Guide& guide, const RollerStroke& stroke, int nodes) {
    const auto begin = std::chrono::steady_clock::now();
    double sum = 0.0;
    for (int i = 0; i < nodes; ++i)
        sum += body_on_guide(guide,
                             state_of(stroke, stroke.begin + (stroke.end - stroke.begin) * i / (nodes - 1)))
                   .acceleration;
    return sum != sum ? 0.0 : microseconds_since(begin);
}

PaperTable node_table(PaperFigure& figure) {
    PaperTable table{
        "node_method",
        "The paper's approximate method against the exact one, forward stroke",
        "Largest errors at inner nodes. Away: at nodes farther than one step from every joint of the guide. "
        "θ″ jumps at the joints, and a difference across a jump is wrong by up to half of it, however many "
        "nodes: that error does not converge, it only wanders with the place of the joint between two nodes. "
        "Times are of this run.",
        {{"nodes", "nodes", ""},
         {"velocity_error_rad_s", "error of θ′", "rad/s", 4},
         {"acceleration_error_rad_s2", "error of θ″", "rad/s²", 4},
         {"acceleration_error_away_rad_s2", "away from joints", "rad/s²", 4},
         {"nodes_us", "time, nodes", "µs", 3},
         {"exact_us", "time, exact", "µs", 3}},
        {}};
    PaperSeries velocity{"θ′ [rad/s]", {}, {}}, acceleration{"θ″ [rad/s²]", {}, {}},
        away{"θ″ away from joints [rad/s²]", {}, {}};
    const Guide guide = make_g1_guide(reference_guide);
    const RollerStroke stroke = roller_law().strokes()[0];
    for (const int nodes : {26, 51, 101, 201, 401, 801, 1601, 3201, 6401}) {
        const NodeMethodError error = node_method_error(guide, stroke, nodes);
        const auto begin = std::chrono::steady_clock::now();
        const std::size_t rows = node_method(guide, stroke, nodes).size();
        const double seconds = microseconds_since(begin);
        table.rows.push_back({static_cast<double>(rows), error.velocity, error.acceleration,
                              error.acceleration_away, seconds, exact_microseconds(guide, stroke, nodes)});
        for (auto [series, value] : {std::pair{&velocity, error.velocity},
                                     {&acceleration, error.acceleration},
                                     {&away, error.acceleration_away}}) {
            series->x.push_back(nodes);
            series->y.push_back(value);
        }
    }
    figure.series = {velocity, acceleration, away};
    return table;
}

GuideCheckInput check_input(const Guide& guide) {
    GuideCheckInput input;
    input.designed = [&guide](double distance) { return guide.at(distance).angle; };
    input.begin = 2.0 * inch;
    input.end = 13.9 * inch;
    input.places = 2000;
    input.roller_radius = roller_radius;
    return input;
}

PaperTable forward_table() {
    PaperTable table{
        "forward_simulation",
        "The finished guide pushed by its roller: points only",
        "Polyline: the roller's centre on straight lines between points at even steps of the forward "
        "stroke's "
        "time. Slot: a roller of 0.5 in (chosen) on one wall, a smooth curve through the wall's points; 2000 "
        "places of the roller from L = 2 to 13.9 in.",
        {{"method", "method", ""},
         {"points", "points", ""},
         {"deviation_rad", "largest error of θ", "rad", 3},
         {"deviation_deg", "the same", "deg", 3},
         {"seconds", "time", "s", 2}},
        {}};
    const auto add = [&](const std::string& method, const GuideCheckResult& result) {
        table.rows.push_back({method, static_cast<double>(result.points), result.deviation,
                              result.deviation / units::degree, result.seconds});
    };
    const Guide guide = make_g1_guide(reference_guide);
    const RollerStroke stroke = roller_law().strokes()[0];
    GuideCheckInput input = check_input(guide);
    for (const int steps : {100, 400, 1600}) {
        input.points.clear();
        for (int i = 0; i <= steps; ++i)
            input.points.push_back(guide.at(state_of(stroke, stroke.end * i / steps).distance).position);
        add("polyline", polyline_check(input));
    }
    for (const double side : {1.0, -1.0}) {
        const GuidePoints wall = guide_points(guide, 400, side * roller_radius);
        input.points = wall.points;
        input.breaks = wall.breaks;
        add(side > 0.0 ? "slot, left wall" : "slot, right wall", slot_check(input));
    }
    return table;
}

}  // namespace

void add_checks(PaperReport& report) {
    PaperFigure figure{"node_method_error",
                       "The approximate method: largest errors against the number of nodes",
                       "nodes",
                       "error",
                       {}};
    figure.logarithmic = true;
    report.tables.push_back(node_table(figure));
    report.figures.push_back(std::move(figure));
    report.tables.push_back(forward_table());
}

}  // namespace camopt::feeding_paper
