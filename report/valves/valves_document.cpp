// SPDX-License-Identifier: MIT
#include "report/valves/valves_document.hpp"

#include "report/valves/valve_tables.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Kind = Sentence::Kind;

constexpr int length_digits = 5, crank_digits = 7;
constexpr int crank_steps = 720;  // of two turns

/// Two of the cam: an angle of the crankshaft in rad.
const ShownUnit crank_degrees("crank deg", units::degree, "_crank_deg");

Table overlap_table(const ValvePair& pair, const ShownUnit& length) {
    Table table{"overlap",
                "Overlap",
                {{"height", "valve lift", millimetres_shown},
                 {"intake_opens", "intake opens", crank_degrees},
                 {"exhaust_closes", "exhaust closes", crank_degrees},
                 {"overlap", "overlap (crank deg)", crank_degrees}},
                {},
                "B, A: before, after; TDC, BDC: top, bottom dead centre."};
    for (const ValvePair::Overlap& overlap : pair.overlaps) {
        const double duration = std::max(0.0, overlap.duration());
        table.rows.push_back({Cell(overlap.height).in_words(length.asked_text(overlap.height)),
                              Cell(overlap.opens).in_words(dead_centre_text(overlap.opens)),
                              Cell(overlap.closes).in_words(dead_centre_text(overlap.closes)),
                              Cell(duration, crank_digits).in_words(duration > 0.0 ? "" : "none")});
    }
    return table;
}

/// From where the exhaust opens to where the intake closes.
Curves lift_curves(const Solution& intake, const Solution& exhaust, const ValvePair& pair,
                   const ShownUnit& length) {
    Curves curves;
    curves.key = "valves";
    curves.caption = "Lifts of both valves over the crank angle";
    curves.angle_key = "crank";
    curves.angle_title = "crank angle after top dead centre";
    Curve in{"intake", "Lifts of the valves, 0° at top dead centre", "Intake", "l", length};
    Curve out{"exhaust", "Lifts of the valves, 0° at top dead centre", "Exhaust", "l", length};
    Curve between{"clearance", "Clearance between the valves", "Clearance", "c", length};
    for (int k = 0; k <= crank_steps; ++k) {
        const double angle = 720.0 * k / crank_steps - 360.0;
        const double crank = angle * units::degree;
        const double one = valve_lift_over_crank(intake, crank),
                     other = valve_lift_over_crank(exhaust, crank);
        curves.angles.push_back(angle);
        in.values.push_back(length.of(one));
        out.values.push_back(length.of(other));
        if (pair.gap) between.values.push_back(length.of(valve_clearance(*pair.gap, one, other)));
    }
    const auto mark = [&](Curve& curve, double value, double at, const char* words) {
        curve.marks.push_back({degrees_shown.of(at), length.of(value),
                               fmt::format("{}{}", words, length.text(value, length_digits))});
    };
    if (pair.intake_at_tdc > 0.0) mark(in, pair.intake_at_tdc, 0.0, "");
    if (pair.exhaust_at_tdc > 0.0) mark(out, pair.exhaust_at_tdc, 0.0, "");
    curves.curves = {std::move(in), std::move(out)};
    if (!pair.gap) return curves;
    between.limits.push_back({curves.angles.front(), curves.angles.back(), 0.0, -1, "the valves touch"});
    mark(between, *pair.clearance, *pair.clearance_at, "closest: ");
    curves.curves.push_back(std::move(between));
    return curves;
}

}  // namespace

Document valves_document(const Solution& intake, const Solution& exhaust, const ValvePair& pair) {
    const ShownUnit length = shown_units(intake.scene).length;
    const bool touch = pair.clearance && !(*pair.clearance > 0.0);
    const Field separation{"lobe_separation", "lobe separation", degrees_shown};
    Document document{"Intake and exhaust on one crankshaft", touch ? "bad" : "good"};
    Section& section = document.sections.emplace_back();
    const auto at = [&](Field field, const std::optional<double>& value, double crank) {
        field.unit = millimetres_shown;
        section.figures.push_back({std::move(field), Cell(value, length, length_digits), crank, crank_degrees,
                                   dead_centre_text(crank)});
    };
    section.figures = {{separation, Cell(pair.lobe_separation,
                                         ShownUnit("cam deg", units::degree, "_cam_deg"), crank_digits)}};
    for (const auto& [key, title, lift] :
         {std::tuple("intake_lift_at_tdc", "intake at top dead centre", pair.intake_at_tdc),
          std::tuple("exhaust_lift_at_tdc", "exhaust at top dead centre", pair.exhaust_at_tdc)})
        section.figures.push_back({{key, title, millimetres_shown}, Cell(lift, length, length_digits)});
    at({"common_lift", "both valves open"}, pair.common_lift, pair.common_at);
    if (pair.clearance) at({"clearance", "least clearance"}, *pair.clearance, *pair.clearance_at);
    section.sentences = {
        {Kind::headline, "clearance",
         touch ? "THE VALVES TOUCH"
         : pair.clearance
             ? fmt::format("The valves stay {} apart", length.text(*pair.clearance, length_digits))
             : fmt::format("Lobe separation {}", shown_text(section.figures.front().cell, separation))}};
    if (!(pair.common_lift > 0.0))
        section.sentences.push_back({Kind::remark, "overlap", "Both valves are never open at once."});
    section.curves = lift_curves(intake, exhaust, pair, length);
    section.tables = {overlap_table(pair, length)};
    return document;
}

}  // namespace camopt
