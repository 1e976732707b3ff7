// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_000_parts.hpp"
#include "core/text/parsing.hpp"
#include "core/units.hpp"
#include "studies/inverse/inverse_forward.hpp"

namespace camopt::feeding_paper {

namespace {

using units::degree, units::inch;

PaperTable node_table(PaperFigure& figure) {
    PaperTable table{
        "node_method",
        "The paper's approximate method against the exact one, forward stroke",
        "Largest errors at inner nodes. Away: at nodes further than one step from every joint of the guide. "
        "θ″ jumps at the joints, and a difference across a jump is wrong by up to half of it, however many "
        "nodes: that error does not converge, it only varies with the position of the joint between two "
        "nodes.",
        {{"nodes", "nodes", ""},
         {"velocity_error_rad_s", "error of θ′", "rad/s", 4},
         {"acceleration_error_rad_s2", "error of θ″", "rad/s²", 4},
         {"acceleration_error_away_rad_s2", "away from joints", "rad/s²", 4}},
        {}};
    PaperSeries velocity{"θ′ [rad/s]", {}, {}}, acceleration{"θ″ [rad/s²]", {}, {}},
        away{"θ″ away from joints [rad/s²]", {}, {}};
    for (const int nodes : {26, 51, 101, 201, 401, 801, 1601}) {
        const NodeMethodError error = node_method_error(forward_stroke(), nodes);
        table.rows.push_back(
            {static_cast<double>(nodes), error.velocity, error.acceleration, error.acceleration_away});
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

PaperTable forward_table() {
    PaperTable table{"forward_simulation",
                     "The finished guide pushed by its roller: points only",
                     "A roller of 0.5 in (chosen) on either wall of the slot, a smooth curve through the "
                     "wall's points, at as many positions of the roller.",
                     {{"guide", "guide", ""},
                      {"points", "points", ""},
                      {"deviation_in", "largest error of the feeder", "in", 3},
                      {"relative", "of its lift", "", 3},
                      {"seconds", "time", "s", 2}},
                     {}};
    for (const auto& [name, stroke] :
         {std::pair{"forward", &forward_stroke()}, {"return", &return_stroke()}}) {
        const ForwardCheckReport check = check_guide(stroke->solution());
        table.rows.push_back({std::string(name), static_cast<double>(check.points), check.deviation / inch,
                              check.relative, check.seconds});
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
    const FeederLinkage linkage = linkage_of(forward_stroke().solution().cam->cam.dimensions);
    return body_motion(linkage, {place, 0.0, 0.0}).body.angle / column_info(theta).unit_value;
}

PaperTable table_1() {
    PaperTable table{"table_1",
                     "Table 1: kinematic properties of cam and feeder",
                     "Ours: the motion of the scenes of given guides. Half digits: difference in halves of "
                     "the last printed "
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

/// x0, R1, R2 and beta of a guide of line, arc, arc, line.
std::array<double, 4> shape_of(const FeederStroke& stroke) {
    const std::vector<CamPiece>& pieces = stroke.solution().scene.cam->pieces;
    const auto radius = [](const CamPiece& arc) {
        return std::hypot(arc.to[0] - arc.center[0], arc.to[1] - arc.center[1]);
    };
    const CamPiece& last = pieces.back();
    return {pieces[0].to[0], radius(pieces[1]), radius(pieces[2]), std::atan2(last.to[1], last.to[0])};
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
    const std::array<double, 4> f = shape_of(forward_stroke()), r = shape_of(return_stroke());
    const FeederLinkage l = linkage_of(forward_stroke().solution().cam->cam.dimensions);
    add("x0, end of the first line", "in", f[0] / inch, r[0] / inch, "recovered");
    add("R1, first arc", "in", f[1] / inch, r[1] / inch, "recovered");
    add("R2, second arc", "in", f[2] / inch, r[2] / inch, "recovered");
    add("beta, direction of the last line", "deg", f[3] / degree, r[3] / degree, "recovered");
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
