// SPDX-License-Identifier: MIT
#include "report/solve/cam_remarks.hpp"

#include "core/text/list_text.hpp"
#include "report/view/cam_presentation.hpp"
#include "report/view/cam_words.hpp"
#include "report/view/key_words.hpp"
#include "scene/cam_flanks.hpp"
#include "scene/limit_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace camopt {

namespace {

constexpr int check_digits = 2;
// Of the prime radius, of a linkage's lift: what an undercut cam is off is far more.
constexpr double moves_as_designed = 1e-4;
constexpr double at_end_of_range = 1e-6;  // of the range: a dimension stands at its end
constexpr double least_rest = 1e-9;       // rad
constexpr double raised_follower = 1e-3;  // lifts: below it a spring has nothing to press with

std::string undercut_remark(const Solution& solution) {
    const CamMechanism& cam = *solution.cam->cam.formulas;
    const CamSummary& summary = solution.cam->summary;
    if (cam.contact() == ContactKind::edge) return "No undercut: a knife edge follows any pitch curve.";
    const std::string limit =
        limit_row(cam.radius_quantity() ? LimitedFigure::convex_radius : LimitedFigure::regularity)
            .first_key();
    const std::string where = degrees_at(solution, summary.regularity.at);
    if (summary.cusp())
        return fmt::format(
            "A CUSP at {} deg: the radius of the cam is 0 there, the limit of undercut; a limit {} above 0 "
            "rounds it.",
            where, limit);
    if (!summary.undercut()) return "No undercut: the cam has neither a cusp nor a loop.";
    return fmt::format("UNDERCUT at {} deg: {}; a limit {} of 0 or more prevents undercut.", where,
                       presentation_of(solution.cam->cam).undercut(cam), limit);
}

/// Of a disk cam.
std::string dimensions_at_their_ends(const Solution& solution) {
    if (solution.cam->cam.formulas->direct() == nullptr) return {};
    const CamSpec& cam = solution.scene.cam.value();
    std::string text;
    const auto add = [&](std::string_view name, double value, double least, double most) {
        const double near = at_end_of_range * (most - least);
        const bool low = value <= least + near, high = value >= most - near;
        if (low || high)
            append_item(text,
                        fmt::format("the {} is the {} allowed", words_of(name), low ? "least" : "largest"));
    };
    for (std::size_t i = 0; i < cam.dimensions.size(); ++i) {
        const Dimension& range = cam.dimensions[i].value;
        if (range.is_variable())
            add(cam.dimensions[i].name, solution.cam->cam.dimensions[i], range.low, range.high);
    }
    for (const SpringNumber& number : spring_numbers)
        if (const std::optional<ForceSpec>& forces = solution.scene.forces;
            forces && (*forces).*number.range) {
            const auto [least, most] = *((*forces).*number.range);
            add(std::string_view(number.key).substr(std::string_view("forces.").size()),
                (*forces).*number.number, least, most);
        }
    return text;
}

std::string limited_remark(const Solution& solution) {
    std::string limits;
    for (const ConstraintReport& row : solution.constraints)
        if (row.active)
            append_item(limits, fmt::format("the {} at {} deg", key_words(row.key).words,
                                            degrees_at(solution, row.at)));
    if (const std::string ends = dimensions_at_their_ends(solution); !ends.empty())
        append_item(limits, ends, "; ");
    if (limits.empty()) return "No limit is active.";
    return fmt::format("{} limits: {}.",
                       solution.certificate.verdict == Verdict::infeasible ? "Active or violated" : "Active",
                       limits);
}

/// "on this rise", "on the return": the stroke that decides, and where it lies where there may be several.
std::string deciding_stroke(const Solution& solution, const SmallestCamReport& smallest) {
    const MotionType type = solution.scene.motion.type;
    if (type == MotionType::drd) return "on this rise";
    std::string which = smallest.rises ? "on the rise" : "on the return";
    if (type == MotionType::rr) return which;
    return which + " " + stretch_words(solution.scene.motion, smallest.begin, smallest.end);
}

std::string smallest_remark(const Solution& solution, const SmallestCamReport& smallest) {
    const ShownUnits shown = shown_units(solution.scene);
    return fmt::format(
        "Smallest possible cam: for a pressure angle of {} every motion needs a prime radius of at least {} "
        "{}; this cam has {}.",
        shown.angle.text(smallest.pressure_angle), shown.length.text(smallest.prime_radius),
        deciding_stroke(solution, smallest), shown.length.text(smallest.given));
}

/// Of a disk cam.
std::string rest_of_the_turn(const Solution& solution) {
    if (solution.cam->cam.formulas->direct() == nullptr) return {};
    const MotionSpec& motion = solution.scene.motion;
    const double angle = motion.length() * motion.unit_angle();
    const double rest = units::turn - angle;
    if (rest <= least_rest) return {};
    if (motion.type == MotionType::rr)
        return fmt::format("The motion takes {} deg; the other {} deg of the cam are a dwell on its base.",
                           short_text(degrees_shown.of(angle)), short_text(degrees_shown.of(rest)));
    if (presentation_of(solution.cam->cam).picture.outline == CamOutline::plate)
        return fmt::format(
            "The profile is that of the motion, {} deg of the cycle; the plate is drawn with the dwells on "
            "either side.",
            short_text(degrees_shown.of(angle)));
    return fmt::format(
        "The profile is the sector of the motion, {} deg; the rest of the revolution is left open.",
        short_text(degrees_shown.of(angle)));
}

/// Of an inverse cam whose roller has its own time for the way back.
std::string return_remark(const Solution& solution) {
    const DrivenMechanism& cam = solution.cam->cam;
    const std::optional<RollerGuide> guide = cam.formulas->guide(cam.dimensions);
    if (!guide || !guide->return_rate) return {};
    const double rate = *guide->return_rate;
    const ShownUnits shown = shown_units(solution.scene);
    const Peaks& peaks = solution.motion_peaks;
    return fmt::format(
        "On the way back the roller is {} times as fast and the output runs this curve backwards: velocity "
        "{} at "
        "most, acceleration {}, jerk {}.",
        short_text(rate, 6), shown.motion[1].first.normalised_text(rate * peaks.velocity.value),
        shown.motion[2].first.normalised_text(rate * rate * peaks.acceleration.value),
        shown.motion[3].first.normalised_text(rate * rate * rate * peaks.jerk.value));
}

constexpr int force_samples = 3600;  // over the motion, for changes of sign
constexpr int force_bisections = 50;
constexpr double no_force = 1e-9;       // of the largest
constexpr double just_reached = 1e-7;   // of the largest: a limit of 0 is met to the tolerance of the solve
constexpr std::size_t most_places = 8;  // that a sentence names

/// Where the force on the follower changes its sign: x, ascending. A force that is rounding has none.
struct ForceChanges {
    bool positive = true;  ///< before the first
    std::vector<double> places;
};
ForceChanges force_changes(const Solution& solution) {
    const Motion& motion = *solution.motion;
    const ForceSummary& forces = *solution.cam->summary.forces;
    const MotionScale scale{solution.scene.motion.lift, solution.scene.motion.unit_angle()};
    const auto force = [&](double x) {
        const FollowerState state =
            state_of(motion.at(x, x < motion.end() ? Side::right : Side::left), scale);
        return solution.scene.forces->force(*solution.scene.motion.speed, state, scale.unit_angle * x);
    };
    const double none =
        no_force * std::max(std::abs(forces.least_force.value), std::abs(forces.largest_force.value));
    ForceChanges changes;
    const double length = motion.end() - motion.begin();
    std::optional<double> last;  // where it was something
    for (int i = 0; i <= force_samples; ++i) {
        const double here = motion.begin() + length * i / force_samples;
        if (std::abs(force(here)) <= none) continue;
        if (!last) changes.positive = force(here) > 0.0;
        const bool before = last && force(*last) > 0.0;
        if (last && before != (force(here) > 0.0))
            changes.places.push_back(bisected([&](double x) { return (force(x) > 0.0) == before; },
                                              {*last, here}, force_bisections)
                                         .without);
        last = here;
    }
    return changes;
}

/// "at 142.661 deg and returns at 217.339 deg"
std::string lift_off_words(const Solution& solution) {
    auto [pressed, places] = force_changes(solution);
    if (places.empty() && pressed) places.assign(2, solution.cam->summary.forces->least_force.at);
    // Lifted where a periodic motion begins: it leaves before the end.
    if (!pressed && solution.scene.motion.periodic() && !places.empty() && places.size() % 2 == 0)
        std::rotate(places.begin(), places.begin() + 1, places.end());
    else if (!pressed)
        places.insert(places.begin(), solution.motion->begin());
    if (places.size() % 2 != 0) places.push_back(solution.motion->end());
    std::string text;
    for (std::size_t i = 0; i < std::min(places.size(), most_places); i += 2)
        append_item(text, fmt::format("at {} deg and returns at {} deg", degrees_at(solution, places[i], 6),
                                      degrees_at(solution, places[i + 1], 6)));
    return text + (places.size() > most_places ? ", …" : "");
}

/// Of a cam that drives both ways: where the roller goes from one side to the other.
std::string crossover_remark(const Solution& solution) {
    const std::vector<SideSummary>& sides = solution.cam->summary.sides;
    const std::vector<double> places = force_changes(solution).places;
    if (places.empty())
        return fmt::format("The force on the follower never changes its sign: the {} carries all of it.",
                           sides[solution.cam->summary.forces->least_force.value >= 0.0 ? 0 : 1].name);
    std::string text = listed(std::span(places).first(std::min(places.size(), most_places)), ", ",
                              [&](double x) { return degrees_at(solution, x); });
    if (places.size() > most_places) append_item(text, "…");
    return fmt::format(
        "The load changes between {} and {} {} times in the motion, at {} deg: the play between "
        "them causes impacts there.",
        sides[0].name, sides[1].name, places.size(), text);
}

std::string lift_off_remark(const Solution& solution, const ForceSummary& forces) {
    if (!solution.cam->summary.sides.empty()) return crossover_remark(solution);
    const double none =
        just_reached * std::max(std::abs(forces.least_force.value), std::abs(forces.largest_force.value));
    if (forces.least_force.value > none) return {};
    if (forces.least_force.value >= -none)
        return fmt::format("The force on the cam just reaches 0 at {} deg: contact has no margin.",
                           degrees_at(solution, forces.least_force.at));
    // Where the follower is down a stiffer spring presses no harder.
    const bool raised = solution.motion->at(forces.least_force.at).derivative[0] > raised_follower;
    return fmt::format("The follower LIFTS OFF the cam {}: it needs {}more preload.",
                       lift_off_words(solution), raised ? "a stiffer spring or " : "");
}

std::string check_remark(const Solution& solution, const ForwardCheckReport& check) {
    const CamPresentation& presentation = presentation_of(solution.cam->cam);
    const std::string where = degrees_at(solution, check.at);
    if (!std::isfinite(check.deviation))
        return fmt::format("Forward check: at {} deg no point was found where the {} touches the cam.", where,
                           presentation.touching);
    const std::string found =
        fmt::format("{} {}",
                    check.relative <= moves_as_designed ? "moves as designed within"
                                                        : "DEPARTS from the designed motion by",
                    shown_units(solution.scene).motion[0].first.text(check.deviation, check_digits));
    return fmt::format(
        "Forward check by points alone: {}.",
        presentation.check(solution.cam->cam,
                           {check.points, found, short_text(check.relative, check_digits), where}));
}

/// Of a cam that drives both ways.
std::string play_remark(const Solution& solution, const ForwardCheckReport::Play& play) {
    const ShownUnits shown = shown_units(solution.scene);
    if (!std::isfinite(play.least)) return {};
    const std::string range = fmt::format(
        "{} (at {} deg) to {} (at {} deg)", shown.motion[0].first.text(play.least, check_digits),
        degrees_at(solution, play.least_at), shown.motion[0].first.text(play.largest, check_digits),
        degrees_at(solution, play.largest_at));
    const DrivenMechanism& cam = solution.cam->cam;
    const double roller = cam.dimensions[cam.formulas->roller_radius()];
    const double clearance = 2.0 * (cam.formulas->surface_offset(cam.dimensions, 0) - roller);
    if (!cam.formulas->radius_quantity())
        return fmt::format("Lost motion of the follower between the flanks, {} of clearance: {}.",
                           shown.length.text(clearance), range);
    if (!play.least_groove_width)
        return fmt::format("Both rollers at once: the sum of the gaps at both disks is {}.", range);
    const bool fits = *play.least_groove_width >= 2.0 * roller * (1.0 - moves_as_designed);
    return fmt::format(
        "The groove is {} wide where it is narrowest, the roller {}: it {}. Play of the follower, "
        "{} of clearance: {}.",
        shown.length.text(*play.least_groove_width, 7), shown.length.text(2.0 * roller),
        fits ? "fits everywhere" : "DOES NOT FIT", shown.length.text(clearance), range);
}

}  // namespace

std::vector<std::string> cam_remarks(const Solution& solution) {
    const CamReport& cam = *solution.cam;
    std::vector<std::string> all = {undercut_remark(solution), limited_remark(solution)};
    if (cam.smallest) all.push_back(smallest_remark(solution, *cam.smallest));
    all.push_back(rest_of_the_turn(solution));
    all.push_back(return_remark(solution));
    if (cam.summary.forces) all.push_back(lift_off_remark(solution, *cam.summary.forces));
    if (cam.forward_check) all.push_back(check_remark(solution, *cam.forward_check));
    if (cam.forward_check && cam.forward_check->play)
        all.push_back(play_remark(solution, *cam.forward_check->play));
    std::erase(all, std::string{});
    return all;
}

}  // namespace camopt
