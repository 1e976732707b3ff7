// SPDX-License-Identifier: MIT
#include "output/view/valve_tables.hpp"

#include "output/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

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
    const auto text = [&](const auto& units) { return ShownUnit(units.at(order - 1)).text(value, 5); };
    if (swings) return text(degrees);
    if (unit == LengthUnit::inch) return text(inches);
    return fmt::format("{} ({})", text(millimetres), text(inches));
}

TextTable event_table(const Solution& solution, const ValveReport& report) {
    const ValveSpec& valve = *solution.scene.motion.valve;
    const ShownUnit length = shown_units(solution.scene).length;
    TextTable table{{{"valve lift"},
                     {"opens"},
                     {"closes"},
                     {"duration (crank deg)"},
                     {fmt::format("area ({} · crank deg)", length.name)}},
                    {}};
    for (const ValveEvent& event : report.events)
        table.rows.push_back({length.asked_text(event.height), event_text(valve, event.opens),
                              event_text(valve, event.closes),
                              short_text(degrees_shown.of(event.duration()), 7),
                              short_text(degrees_shown.of(length.of(event.area)), 7)});
    return table;
}

TextTable figure_table(const Solution& solution, const ValveReport& report) {
    const MotionSpec& motion = solution.scene.motion;
    const ShownUnits shown = shown_units(solution.scene);
    const bool swings = motion.lift_is_angle;
    TextTable table{{{"the lobe", true}, {"value", true}}, {}};
    const auto add = [&](std::string name, std::string value) {
        table.rows.push_back({std::move(name), std::move(value)});
    };
    add("lift of the follower", shown.motion[0].first.text(motion.lift));
    add("velocity of the opening valve",
        rate_text(report.opening_velocity, 1, false, solution.scene.length_unit));
    add("velocity of the closing valve",
        rate_text(report.closing_velocity, 1, false, solution.scene.length_unit));
    add("acceleration, opening flank",
        rate_text(report.opening_acceleration, 2, swings, solution.scene.length_unit));
    add("acceleration, nose", rate_text(report.nose_acceleration, 2, swings, solution.scene.length_unit));
    add("acceleration, closing flank",
        rate_text(report.closing_acceleration, 2, swings, solution.scene.length_unit));
    for (const auto& [height, duration] : report.tappet_durations)
        add(fmt::format("duration at {} of the tappet", shown.length.asked_text(height)),
            short_text(degrees_shown.of(duration), 7) + " crank deg");
    const auto from_nose = [](double crank) {
        return short_text(degrees_shown.of(crank), 4) + " crank deg from the nose";
    };
    if (report.nose_radius)
        add("least radius of the nose", fmt::format("{} at {}", shown.length.text(report.nose_radius->value),
                                                    from_nose(report.nose_radius->at)));
    if (report.contact_offset)
        add("contact eccentricity on the tappet", shown.length.text(*report.contact_offset));
    for (const ValveMargins& margins : report.margins)
        for (const auto& [part, margin] :
             {std::pair("nose", &margins.nose), std::pair("flank", &margins.flank)})
            add(fmt::format("least force at {}, {}", rpm_shown.text(margins.engine_speed), part),
                fmt::format("{} at {}, {} % of the spring's", shown.load.text(margin->least_force, 5),
                            from_nose(margin->at), short_text(100.0 * margin->share, 3)));
    if (report.lift_off_speed)
        add("the follower lifts off above", rpm_shown.text(*report.lift_off_speed) + " of the engine");
    return table;
}

}  // namespace

std::string dead_centre_text(double crank) {
    return stroke_text(crank, static_cast<int>(std::lround(degrees_shown.of(crank) / 180.0)));
}

std::vector<ViewTable> valve_tables(const Solution& solution) {
    if (!solution.scene.motion.valve || !solution.motion) return {};
    const ValveReport report = valve_report(solution);
    return {
        {"valve", "Valve events", event_table(solution, report),
         "The area is that under the valve's lift between the two events. Crank degrees, two for one of the "
         "cam; B, A: before, after; TDC, BDC: top, bottom dead centre."},
        {"valve_figures", "The lobe", figure_table(solution, report),
         "Velocities and accelerations by the cam angle; accelerations of the follower."}};
}

}  // namespace camopt
