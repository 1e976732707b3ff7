// SPDX-License-Identifier: MIT
#include "benchmarks/papers/guide.hpp"
#include "benchmarks/papers/paper_000_parts.hpp"
#include "benchmarks/papers/paper_guide.hpp"
#include "benchmarks/papers/polyline_check.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"

#include <fmt/format.h>

#include <chrono>

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
        "Largest errors at inner nodes. Away: at nodes further than one step from every joint of the guide. "
        "θ″ jumps at the joints, and a difference across a jump is wrong by up to half of it, however many "
        "nodes: that error does not converge, it only varies with the position of the joint between two "
        "nodes. Times are of this run.",
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
        "stroke's time. Slot: a roller of 0.5 in (chosen) on one wall, a smooth curve through the wall's "
        "points; 2000 places of the roller from L = 2 to 13.9 in.",
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

const Misprint* misprint_at(std::string_view time, int column) {
    const auto found = std::ranges::find_if(
        misprints(), [&](const Misprint& one) { return one.time == time && one.column == column; });
    return found == misprints().end() ? nullptr : &*found;
}

/// theta of the body that puts the feeder at the row's printed Y: what the row's other columns say of theta.
double theta_from_feeder(const PrintedRow& row) {
    const auto& info = column_info(feeder);
    const double place = required_number(row.cells[feeder]) * info.unit_value;
    return body_motion(linkage(), {place, 0.0, 0.0}).body.angle / column_info(theta).unit_value;
}

PaperTable table_1() {
    PaperTable table{
        "table_1",
        "Table 1: kinematic properties of cam and feeder",
        "Ours: exact motion of the recovered machine. Half digits: difference in halves of the last printed "
        "digit; up to 1 agrees to the printed rounding.",
        {{"time_s", "t", "s", 4},
         {"quantity", "quantity", ""},
         {"unit", "unit", ""},
         {"printed", "printed", "", 7},
         {"ours", "ours", "", 6},
         {"difference", "difference", "", 2},
         {"half_digits", "half digits", "", 3},
         {"remark", "remark", ""}},
        {}};
    for (const PrintedRow& row : printed_rows()) {
        const auto values = computed_row(row);
        for (int i = 0; i < columns; ++i) {
            const std::string_view words = row.cells[static_cast<std::size_t>(i)];
            const double difference = values[static_cast<std::size_t>(i)] - required_number(words);
            const Misprint* misprint = misprint_at(row.time, i);
            table.rows.push_back({required_number(row.time), std::string(column_info(i).symbol),
                                  std::string(column_info(i).unit), required_number(words),
                                  values[static_cast<std::size_t>(i)], difference,
                                  std::abs(difference) / half_digit(words),
                                  std::string(misprint == nullptr ? "" : "misprint")});
        }
    }
    return table;
}

PaperTable misprint_table() {
    PaperTable table{"misprints",
                     "Digits of Table 1 that contradict the others",
                     "Consistent: the range that the row's other columns allow. θ from Y: the angle at "
                     "which the row's own Y is reached.",
                     {{"time_s", "t", "s", 4},
                      {"quantity", "quantity", ""},
                      {"unit", "unit", ""},
                      {"printed", "printed", "", 7},
                      {"consistent_least", "consistent from", "", 6},
                      {"consistent_most", "to", "", 6},
                      {"ours", "ours", "", 6},
                      {"theta_from_feeder_deg", "θ from Y", "deg", 4},
                      {"evidence", "evidence", ""}},
                     {}};
    for (const Misprint& misprint : misprints()) {
        const auto row = std::ranges::find(printed_rows(), misprint.time, &PrintedRow::time);
        std::optional<double> angle;
        if (misprint.column == theta) angle = theta_from_feeder(*row);
        table.rows.push_back(
            {required_number(misprint.time), std::string(column_info(misprint.column).symbol),
             std::string(column_info(misprint.column).unit),
             required_number(row->cells[static_cast<std::size_t>(misprint.column)]), misprint.least,
             misprint.most, computed_row(*row)[static_cast<std::size_t>(misprint.column)], cell_of(angle),
             std::string(misprint.evidence)});
    }
    return table;
}

PaperTable agreement_table() {
    const Agreement found = agreement();
    PaperTable table{"agreement",
                     "How well the recovered machine explains Table 1",
                     "θ … Y″ of the eight rows in which the body moves; nothing left out.",
                     {{"measure", "measure", ""}, {"entries", "entries", ""}, {"of", "of", ""}},
                     {}};
    const double all = found.entries;
    table.rows.push_back(
        {std::string("within the printed rounding"), static_cast<double>(found.rounded), all});
    table.rows.push_back(
        {std::string("within 0.3 % or 5 half digits"), static_cast<double>(found.close), all});
    return table;
}

PaperTable dimension_table() {
    PaperTable table{
        "dimensions",
        "The machine, recovered from Table 1 (not printed in the paper)",
        "Guides: fits to θ, θ′, θ″ of each stroke. No "
        "single guide makes both strokes (the best one is 0.23 deg off); why is unknown. Rocker: Table 1 "
        "determines only a family in L1 (4 to 20 in fit equally); this member is chosen.",
        {{"dimension", "dimension", ""},
         {"unit", "unit", ""},
         {"forward", "forward", "", 6},
         {"back", "return", "", 6},
         {"origin", "origin", ""}},
        {}};
    const auto add = [&](const char* name, const char* unit, double forward, double back,
                         const char* origin) {
        table.rows.push_back({std::string(name), std::string(unit), forward, back, std::string(origin)});
    };
    const G1GuideDimensions f = forward_guide(), r = return_guide();
    const FeederLinkage l = linkage();
    using units::degree, units::inch;
    add("x0, end of the first line", "in", f.line_end / inch, r.line_end / inch, "recovered");
    add("R1, first arc", "in", f.first_radius / inch, r.first_radius / inch, "recovered");
    add("R2, second arc", "in", f.second_radius / inch, r.second_radius / inch, "recovered");
    add("beta, direction of the last line", "deg", f.end_angle / degree, r.end_angle / degree, "recovered");
    add("L1, pin from the pivot", "in", l.pin_distance / inch, l.pin_distance / inch, "chosen member");
    add("al0, angle of the pin", "deg", l.pin_angle / degree, l.pin_angle / degree, "chosen member");
    add("Xc, rocker's pivot", "in", l.rocker_pivot.x() / inch, l.rocker_pivot.x() / inch,
        "follows from L1, al0");
    add("Yc", "in", l.rocker_pivot.y() / inch, l.rocker_pivot.y() / inch, "follows from L1, al0");
    add("Lx, feeder from the rocker's pivot", "in", l.feeder_offset / inch, l.feeder_offset / inch,
        "follows from L1, al0");
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

std::vector<PaperTable> printed_tables() {
    return {table_1(), misprint_table(), agreement_table(), dimension_table()};
}

}  // namespace camopt::feeding_paper
