// SPDX-License-Identifier: MIT
#include "report/valves/valve_tables.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr int crank_digits = 7, rate_digits = 5, place_digits = 4;

/// An angle of the crankshaft in rad, not twice one of the cam.
const ShownUnit crank_degrees("crank deg", units::degree, std::string(unit_named<"crank deg">.suffix));

/// After or before the dead centre after so many half turns.
std::string stroke_text(double crank, int half_turns) {
    const double from = degrees_shown.of(crank) - 180.0 * half_turns;
    return fmt::format("{} {}{}", short_text(std::abs(from)), from < 0.0 ? "B" : "A",
                       half_turns % 2 == 0 ? "TDC" : "BDC");
}

std::string event_text(const ValveSpec& valve, double from_nose) {
    // An intake opens about top dead centre and closes after bottom dead centre, an exhaust the reverse.
    if (valve.centerline) {
        const double nose = 2.0 * *valve.centerline;
        const bool intake = nose > 0.0, opening = from_nose < 0.0;
        return stroke_text(nose + from_nose, intake == opening ? 0 : intake ? 1 : -1);
    }
    return fmt::format("{} {} the nose", short_text(std::abs(degrees_shown.of(from_nose))),
                       from_nose < 0.0 ? "before" : "after");
}

/// By the cam angle: "0.0203 mm/deg² (0.000799 in/deg²)", or inches alone where lengths are in inches.
std::string rate_text(double value, std::size_t order, bool swings, LengthUnit unit) {
    constexpr auto degrees = units_named<"deg/deg", "deg/deg^2">, inches = units_named<"in/deg", "in/deg^2">,
                   millimetres = units_named<"mm/deg", "mm/deg^2">;
    const auto text = [&](const auto& units) {
        return ShownUnit(units.at(order - 1)).text(value, rate_digits);
    };
    if (swings) return text(degrees);
    if (unit == LengthUnit::inch) return text(inches);
    return fmt::format("{} ({})", text(millimetres), text(inches));
}

std::string from_nose(double crank) {
    return crank_degrees.text(crank, place_digits) + " from the nose";
}

/// The figures, then what has no key.
Table figure_table(const Solution& solution, const ValveReport& report) {
    const ShownUnits shown = shown_units(solution.scene);
    Table table{"valve_figures",
                "The lobe",
                {{.key = "the_lobe", .left = true}, {.key = "value", .left = true}},
                {},
                "Velocities and accelerations by the cam angle; accelerations of the follower."};
    const auto add = [&](std::string name, std::string value) {
        table.rows.push_back({std::move(name), std::move(value)});
    };
    for (const Figure& figure : valve_figures(solution, report))
        add(figure.field.title,
            shown_text(figure.cell, figure.field) + (figure.at ? " at " + place_text(figure) : ""));
    for (const auto& [height, duration] : report.tappet_durations)
        add(fmt::format("duration at {} of the tappet", shown.length.asked_text(height)),
            crank_degrees.text(duration, crank_digits));
    for (const ValveMargins& margins : report.margins)
        for (const auto& [part, margin] :
             {std::pair("nose", &margins.nose), std::pair("flank", &margins.flank)})
            add(fmt::format("least force at {}, {}", rpm_shown.text(margins.engine_speed), part),
                fmt::format("{} at {}, {} % of the spring's", shown.load.text(margin->least_force, 5),
                            from_nose(margin->at), short_text(100.0 * margin->share, 3)));
    return table;
}

}  // namespace

std::string dead_centre_text(double crank) {
    return stroke_text(crank, static_cast<int>(std::lround(degrees_shown.of(crank) / 180.0)));
}

Table valve_events(const Solution& solution, const ValveReport& report) {
    const ValveSpec& valve = *solution.scene.motion.valve;
    const ShownUnit length = shown_units(solution.scene).length;
    const ShownUnit area("mm · crank deg", millimetres_shown.size * crank_degrees.size,
                         millimetres_shown.suffix + crank_degrees.suffix);
    Table table{"valve",
                "Valve events",
                {{"height", "valve lift", millimetres_shown},
                 {"opens", "opens", crank_degrees},
                 {"closes", "closes", crank_degrees},
                 {"duration", "duration (crank deg)", crank_degrees},
                 {"area", fmt::format("area ({} · crank deg)", length.name), area}},
                {},
                "The area is that under the valve's lift between the two events. Crank degrees, two for one "
                "of the cam; B, A: before, after; TDC, BDC: top, bottom dead centre."};
    for (const ValveEvent& event : report.events)
        table.rows.push_back(
            {Cell(event.height).in_words(length.asked_text(event.height)),
             Cell(event.opens).in_words(event_text(valve, event.opens)),
             Cell(event.closes).in_words(event_text(valve, event.closes)),
             {event.duration(), crank_digits},
             Cell(event.area).in_words(short_text(degrees_shown.of(length.of(event.area)), crank_digits))});
    return table;
}

std::vector<Figure> valve_figures(const Solution& solution, const ValveReport& report) {
    const MotionSpec& motion = solution.scene.motion;
    const ShownUnits shown = shown_units(solution.scene);
    const ShownUnit velocity = unit_named<"mm/deg">,
                    acceleration = motion.lift_is_angle ? unit_named<"deg/deg^2"> : unit_named<"mm/deg^2">;
    const auto rate = [&](const char* key, const char* title, double value, std::size_t order) {
        const bool swings = order == 2 && motion.lift_is_angle;
        return Figure{{key, title, order == 1 ? velocity : acceleration},
                      Cell(value).in_words(rate_text(value, order, swings, solution.scene.length_unit))};
    };
    std::vector<Figure> all = {
        {{"lobe_lift", "lift of the follower", motion.lift_is_angle ? degrees_shown : millimetres_shown},
         {motion.lift, static_cast<const ShownUnit&>(shown.motion[0].first)}},
        rate("opening_velocity", "velocity of the opening valve", report.opening_velocity, 1),
        rate("closing_velocity", "velocity of the closing valve", report.closing_velocity, 1),
        rate("opening_acceleration", "acceleration, opening flank", report.opening_acceleration, 2),
        rate("nose_acceleration", "acceleration, nose", report.nose_acceleration, 2),
        rate("closing_acceleration", "acceleration, closing flank", report.closing_acceleration, 2)};
    if (const std::optional<Extremum>& radius = report.nose_radius)
        all.push_back({{"nose_radius", "least radius of the nose", millimetres_shown},
                       {radius->value, shown.length},
                       radius->at,
                       crank_degrees,
                       from_nose(radius->at)});
    if (report.contact_offset)
        all.push_back({{"contact_eccentricity", "contact eccentricity on the tappet", millimetres_shown},
                       {report.contact_offset, shown.length}});
    if (report.lift_off_speed)
        all.push_back({{"lift_off_engine_speed", "the follower lifts off above", rpm_shown},
                       Cell(report.lift_off_speed)
                           .in_words(rpm_shown.text(*report.lift_off_speed) + " of the engine")});
    return all;
}

std::vector<Table> valve_tables(const Solution& solution) {
    if (!solution.scene.motion.valve || !solution.motion) return {};
    const ValveReport report = valve_report(solution);
    std::vector<Table> tables = {valve_events(solution, report), figure_table(solution, report)};
    for (Table& table : tables) table.note_where = Where::reports;
    return tables;
}

}  // namespace camopt
