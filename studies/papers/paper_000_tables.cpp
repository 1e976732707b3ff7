// SPDX-License-Identifier: MIT
#include "core/text/number_parsing.hpp"
#include "core/units.hpp"
#include "studies/papers/paper_000_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace camopt::feeding_paper {

namespace {

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
                     "Consistent: the range that the row's other columns allow. θ from Y: the angle at which "
                     "the row's own "
                     "Y is reached.",
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

std::vector<PaperTable> printed_tables() {
    return {table_1(), misprint_table(), agreement_table(), dimension_table()};
}

}  // namespace camopt::feeding_paper
