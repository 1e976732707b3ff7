// SPDX-License-Identifier: MIT
#include "studies/valve/valve_report.hpp"

#include "core/numbers/polynomial.hpp"
#include "studies/delivered/delivered.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

constexpr int search_steps = 60;
constexpr std::array shares_of_speed = {0.5, 0.75, 1.0, 1.1, 1.25};
constexpr double same_height = 1e-9;  // m
constexpr int pair_places = 7200;     // over the cycle of 720 crank degrees, then refined

const ValveSpec& spec_of(const Solution& solution) {
    return *solution.scene.motion.valve;
}

/// Nose in x.
double nose_of(const Solution& solution) {
    return nose_angle(spec_of(solution)) / solution.scene.motion.unit_angle();
}

/// Breakpoints inside of (begin, end), and both of these.
std::vector<double> pieces_between(const Motion& motion, double begin, double end) {
    std::vector<double> all = {begin};
    for (const double point : motion.breakpoints())
        if (point > begin && point < end) all.push_back(point);
    all.push_back(end);
    return all;
}

/// x next to the nose, before (sense −1) or after it, where the valve has this lift.
double place_of_lift(const Solution& solution, double height, int sense) {
    const Motion& motion = *solution.motion;
    const double nose = nose_of(solution);
    std::vector<double> pieces =
        sense < 0 ? pieces_between(motion, motion.begin(), nose) : pieces_between(motion, nose, motion.end());
    if (sense < 0) std::ranges::reverse(pieces);
    const auto above = [&](double x) { return valve_lift_at(solution, x) >= height; };
    for (std::size_t i = 1; i < pieces.size(); ++i)
        if (!above(pieces[i])) {
            const Border border = bisected(above, {pieces[i - 1], pieces[i]}, search_steps);
            return 0.5 * (border.with + border.without);
        }
    return pieces.back();
}

ValveEvent event_at(const Solution& solution, double height) {
    const double begin = place_of_lift(solution, height, -1), end = place_of_lift(solution, height, 1);
    ValveEvent event{height, crank_angle_at(solution, begin), crank_angle_at(solution, end), 0.0};
    const std::vector<double> pieces = pieces_between(*solution.motion, begin, end);
    for (std::size_t i = 1; i < pieces.size(); ++i)
        visit_quadrature(pieces[i - 1], pieces[i], 1,
                         [&](double x, double weight) { event.area += weight * valve_lift_at(solution, x); });
    event.area *= 2.0 * solution.scene.motion.unit_angle();
    return event;
}

/// Largest s'' between two places, of the follower by the cam angle; sense −1: least.
double acceleration_between(const Solution& solution, double begin, double end, double sense = 1.0) {
    const MotionSpec& motion = solution.scene.motion;
    const auto figure = [&](double x, Side side) {
        return sense * solution.motion->at(x, side).derivative[2];
    };
    return sense * largest_along(pieces_between(*solution.motion, begin, end), figure).value * motion.lift /
           (motion.unit_angle() * motion.unit_angle());
}

double valve_velocity_at(const Solution& solution, double x) {
    const MotionSpec& motion = solution.scene.motion;
    return std::abs(solution.motion->at(x).derivative[1]) * spec_of(solution).ratio * motion.lift /
           motion.unit_angle();
}

/// Begin and end of the nose: where the follower is fastest before and after its top.
std::array<double, 2> nose_region(const Solution& solution) {
    const Motion& motion = *solution.motion;
    const double top = nose_of(solution);
    const auto speed = [&](double x, Side side) { return std::abs(motion.at(x, side).derivative[1]); };
    return {largest_along(pieces_between(motion, motion.begin(), top), speed).at,
            largest_along(pieces_between(motion, top, motion.end()), speed).at};
}

/// As the radii of the whole cam (cam_summary.hpp): of a roller's cam from the pitch curve, whose curvature
/// is smooth where a radius is not.
std::optional<Extremum> nose_radius(const Solution& solution, const CamPoints& points) {
    const DrivenMechanism& cam = points.cam();
    const bool pitch = cam.formulas->radius_quantity() == MechanismQuantity::pitch_curvature;
    const auto [begin, end] = nose_region(solution);
    const Extremum sharpest =
        largest_along(pieces_between(points.motion(), begin, end), [&](double x, Side side) {
            const MechanismPoint& point = points.at(points.motion().at(x, side), 0);
            return pitch ? point.pitch_curvature : -point.cam_radius;
        });
    if (pitch && !(sharpest.value > 0.0)) return {};
    const double radius =
        pitch ? 1.0 / sharpest.value - cam.formulas->surface_offset(cam.dimensions, 0) : -sharpest.value;
    return Extremum{radius, crank_angle_at(solution, sharpest.at), sharpest.side};
}

ValveMargin margin_between(const Solution& solution, double cam_speed, double begin, double end) {
    const ForceSpec& forces = *solution.scene.forces;
    const MotionScale scale = motion_scale(solution.scene);
    const auto force = [&](double x, Side side) {
        return forces.force(cam_speed, state_of(solution.motion->at(x, side), scale), scale.unit_angle * x,
                            side);
    };
    const Extremum least = least_along(pieces_between(*solution.motion, begin, end), force);
    FollowerState still = state_of(solution.motion->at(least.at, least.side), scale);
    still.velocity = still.acceleration = 0.0;
    const double pressed = forces.force(0.0, still, scale.unit_angle * least.at, least.side);
    return {least.value, crank_angle_at(solution, least.at), least.value / pressed};
}

void add_margins(ValveReport& report, const Solution& solution) {
    const std::optional<double>& speed = solution.scene.motion.speed;
    if (!solution.scene.forces || !speed) return;
    const auto [begin, end] = nose_region(solution);
    for (const double share : shares_of_speed) {
        const auto margin = [&](double from, double to) {
            return margin_between(solution, share * *speed, from, to);
        };
        const ValveMargin opening = margin(solution.motion->begin(), begin),
                          closing = margin(end, solution.motion->end());
        report.margins.push_back({2.0 * share * *speed, margin(begin, end),
                                  opening.least_force < closing.least_force ? opening : closing});
    }
    if (!solution.cam || !solution.cam->summary.forces) return;
    if (const auto& off = solution.cam->summary.forces->lift_off_speed)
        report.lift_off_speed = 2.0 * off->value;
}

void require_lobe(const Solution& solution, const char* which) {
    const MotionSpec& motion = solution.scene.motion;
    const char* const lacks = !motion.valve               ? "no motion of type \"valve\""
                              : !solution.motion          ? "no motion"
                              : !motion.valve->centerline ? "no motion.centerline"
                                                          : nullptr;
    if (lacks != nullptr)
        throw InputError(fmt::format("{}: found {}; allowed: a valve lobe with a motion and its centerline",
                                     which, lacks));
}

/// A crank angle in [−360°, 360°), the cycle about top dead centre.
double in_cycle(double crank) {
    return crank - 2.0 * units::turn * std::floor(crank / (2.0 * units::turn) + 0.5);
}

/// The largest value over the cycle, and its crank angle.
Extremum largest_over_cycle(const std::function<double(double crank)>& figure) {
    std::vector<double> places;
    for (int i = 0; i <= pair_places; ++i)
        places.push_back(2.0 * units::turn * (static_cast<double>(i) / pair_places - 0.5));
    const double step = places[1] - places[0];
    const double best = *std::ranges::max_element(places, {}, figure);
    const GoldenSection section = golden_maximum(figure, best - step, best + step, search_steps);
    return {section.value(), section.place()};
}

}  // namespace

const ValveEvent& ValveReport::at(double height) const {
    return *std::ranges::min_element(
        events, {}, [&](const ValveEvent& event) { return std::abs(event.height - height); });
}

double valve_lift_at(const Solution& solution, double x) {
    const ValveSpec& valve = spec_of(solution);
    return valve.ratio * solution.scene.motion.lift * solution.motion->at(x).derivative[0] - valve.lash;
}

double crank_angle_at(const Solution& solution, double x) {
    return 2.0 * (x * solution.scene.motion.unit_angle() - nose_angle(spec_of(solution)));
}

double x_of_crank_angle(const Solution& solution, double crank) {
    return (0.5 * crank + nose_angle(spec_of(solution))) / solution.scene.motion.unit_angle();
}

double valve_lift_over_crank(const Solution& solution, double crank) {
    const double from_nose = in_cycle(crank - 2.0 * *spec_of(solution).centerline);
    const Motion& motion = *solution.motion;
    const double x = x_of_crank_angle(solution, from_nose);
    return std::max(0.0, x < motion.begin() || x > motion.end() ? 0.0 : valve_lift_at(solution, x));
}

double valve_clearance(const ValveGap& gap, double intake, double exhaust) {
    const double across = gap.gap - (intake + exhaust) * std::sin(0.5 * gap.included);
    return across < 0.0 ? across : std::hypot(across, (intake - exhaust) * std::cos(0.5 * gap.included));
}

ValveReport valve_report(const Solution& solution) {
    const ValveSpec& valve = spec_of(solution);
    const Motion& motion = *solution.motion;
    ValveReport report;
    std::vector<double> heights = {valve.checking_height, 0.05 * units::inch, 0.2 * units::inch};
    // Heights at which lobes are measured: with feelers of an inch, or of a millimetre.
    if (solution.scene.length_unit == LengthUnit::inch)
        heights.insert(heights.end(), {0.004 * units::inch, 0.006 * units::inch, 0.02 * units::inch});
    else
        heights.insert(heights.end(), {0.1 * units::millimetre, units::millimetre});
    std::ranges::sort(heights);
    const auto same = [](double one, double other) { return std::abs(one - other) < same_height; };
    heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
    for (const double height : heights)
        if (height < valve.lift) report.events.push_back(event_at(solution, height));
    if (!solution.scene.motion.lift_is_angle)  // of a tappet, which has no lash
        for (const double height : {0.02 * units::inch, 0.05 * units::inch})
            if (const double lift = valve.ratio * height - valve.lash; height < solution.scene.motion.lift)
                report.tappet_durations.emplace_back(height, event_at(solution, lift).duration());
    const double nose = nose_of(solution);
    report.opening_velocity = valve_velocity_at(solution, place_of_lift(solution, 0.0, -1));
    report.closing_velocity = valve_velocity_at(solution, place_of_lift(solution, 0.0, 1));
    report.opening_acceleration = acceleration_between(solution, motion.begin(), nose);
    report.closing_acceleration = acceleration_between(solution, nose, motion.end());
    report.nose_acceleration = acceleration_between(solution, motion.begin(), motion.end(), -1.0);
    if (solution.cam) {
        const CamPoints points(solution.cam->cam, drawn_motion(solution), motion_scale(solution.scene));
        report.nose_radius = nose_radius(solution, points);
        if (const auto& offset = solution.cam->summary.contact_offset) report.contact_offset = offset->value;
    }
    add_margins(report, solution);
    return report;
}

ValvePair valve_pair(const Solution& intake, const Solution& exhaust, const std::optional<ValveGap>& gap) {
    require_lobe(intake, "intake");
    require_lobe(exhaust, "exhaust");
    ValvePair pair;
    const double nose_in = 2.0 * *spec_of(intake).centerline, nose_out = 2.0 * *spec_of(exhaust).centerline;
    pair.lobe_separation = 0.5 * std::abs(in_cycle(nose_in - nose_out));
    const ValveReport opening = valve_report(intake), closing = valve_report(exhaust);
    for (const ValveEvent& event : opening.events) {
        const ValveEvent& other = closing.at(event.height);
        if (std::abs(other.height - event.height) < same_height)
            pair.overlaps.push_back(
                {event.height, in_cycle(nose_in + event.opens), in_cycle(nose_out + other.closes)});
    }
    pair.intake_at_tdc = valve_lift_over_crank(intake, 0.0);
    pair.exhaust_at_tdc = valve_lift_over_crank(exhaust, 0.0);
    const Extremum common = largest_over_cycle([&](double crank) {
        return std::min(valve_lift_over_crank(intake, crank), valve_lift_over_crank(exhaust, crank));
    });
    pair.common_lift = common.value;
    pair.common_at = common.at;
    pair.gap = gap;
    if (!gap) return pair;
    const Extremum closest = largest_over_cycle([&](double crank) {
        return -valve_clearance(*gap, valve_lift_over_crank(intake, crank),
                                valve_lift_over_crank(exhaust, crank));
    });
    pair.clearance = -closest.value;
    pair.clearance_at = closest.at;
    return pair;
}

}  // namespace camopt
