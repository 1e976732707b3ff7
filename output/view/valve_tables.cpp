// SPDX-License-Identifier: MIT
#include "output/view/valve_tables.hpp"

#include "output/view/shown_units.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

const ShownUnit crank_shown{"crank deg", units::degree};

std::string event_text(const ValveSpec& valve, double from_nose) {
    if (valve.centerline) return dead_centre_text(2.0 * *valve.centerline + from_nose);
    return fmt::format("{} {} the nose", short_text(std::abs(degrees_shown.of(from_nose))),
                       from_nose < 0.0 ? "before" : "after");
}

/// By the cam angle, in both systems of units: "0.0203 mm/deg² (0.000799 in/deg²)".
std::string both_texts(double value, int order, bool swings) {
    const double per_degree = std::pow(units::degree, order);
    const char* const power = order == 1 ? "" : "²";
    if (swings) return ShownUnit{fmt::format("deg/deg{}", power), units::degree / per_degree}.text(value, 5);
    return fmt::format(
        "{} ({})", ShownUnit{fmt::format("mm/deg{}", power), units::millimetre / per_degree}.text(value, 5),
        ShownUnit{fmt::format("in/deg{}", power), units::inch / per_degree}.text(value, 5));
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
        table.rows.push_back({length.text(event.height), event_text(valve, event.opens),
                              event_text(valve, event.closes),
                              short_text(crank_shown.of(event.duration()), 7),
                              short_text(crank_shown.of(length.of(event.area)), 7)});
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
    add("velocity of the opening valve", both_texts(report.opening_velocity, 1, false));
    add("velocity of the closing valve", both_texts(report.closing_velocity, 1, false));
    add("acceleration, opening flank", both_texts(report.opening_acceleration, 2, swings));
    add("acceleration, nose", both_texts(report.nose_acceleration, 2, swings));
    add("acceleration, closing flank", both_texts(report.closing_acceleration, 2, swings));
    if (report.nose_radius) add("nose radius", shown.length.text(*report.nose_radius));
    if (report.contact_offset)
        add("contact eccentricity on the tappet", shown.length.text(*report.contact_offset));
    for (const ValveMargin& margin : report.margins)
        add(fmt::format("least force on the cam at {}", rpm_shown.text(margin.engine_speed)),
            fmt::format("{} at {} crank deg from the nose, {} % of the spring's",
                        shown.load.text(margin.least_force, 5), short_text(degrees_shown.of(margin.at), 4),
                        short_text(100.0 * margin.share, 3)));
    if (report.lift_off_speed)
        add("the follower lifts off above", rpm_shown.text(*report.lift_off_speed) + " of the engine");
    return table;
}

}  // namespace

std::string dead_centre_text(double crank) {
    const double degrees = degrees_shown.of(crank), half_turns = std::round(degrees / 180.0);
    const double from = degrees - 180.0 * half_turns;
    const bool top = std::abs(std::fmod(half_turns, 2.0)) < 0.5;
    return fmt::format("{} {}{}", short_text(std::abs(from)), from < 0.0 ? "B" : "A", top ? "TDC" : "BDC");
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

std::string valve_pair_text(const ValvePair& pair, LengthUnit unit) {
    const ShownUnit length{name_of(unit), metres_of(unit)};
    TextTable table{{{"valve lift"}, {"intake opens"}, {"exhaust closes"}, {"overlap (crank deg)"}}, {}};
    for (const ValvePair::Overlap& overlap : pair.overlaps)
        table.rows.push_back({length.text(overlap.height), dead_centre_text(overlap.opens),
                              dead_centre_text(overlap.closes),
                              overlap.duration() > 0.0 ? short_text(degrees_shown.of(overlap.duration()), 7)
                                                       : std::string("none")});
    std::string text =
        fmt::format("Lobe separation {} cam deg.\n\n{}\nLifts at top dead centre: intake {}, exhaust {}.\n",
                    short_text(degrees_shown.of(pair.lobe_separation), 7), aligned_text(table),
                    length.text(pair.intake_at_tdc, 5), length.text(pair.exhaust_at_tdc, 5));
    text += pair.common_lift > 0.0
                ? fmt::format("Both valves are open {} or more at {}.\n", length.text(pair.common_lift, 5),
                              dead_centre_text(pair.common_at))
                : std::string("Both valves are never open at once.\n");
    if (pair.clearance)
        text += fmt::format("Least clearance between the valves: {} at {}{}.\n",
                            length.text(*pair.clearance, 5), dead_centre_text(*pair.clearance_at),
                            *pair.clearance > 0.0 ? "" : ": THE VALVES TOUCH");
    return text;
}

}  // namespace camopt
