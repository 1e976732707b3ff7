// SPDX-License-Identifier: MIT
#include "studies/delivered/cam_summary.hpp"

#include "objectives/rules/cam_limits.hpp"
#include "studies/delivered/driven_mechanism.hpp"

namespace camopt {

namespace {

// Private to studies/delivered: figures of a cam of any kind, and their extremes over the motion and over all
// stations.

/// A point of the cam and the state of the output that made it.
struct CamPlace {
    MechanismPoint point;
    FollowerState state;
};
using CamPlaceFigure = std::function<double(const CamPlace&)>;

/// Keeps references to the cam and the motion. What its figures share, the points of the cam at the samples
/// that they all look at first, is made once.
class CamTurn {
 public:
    CamTurn(const DrivenMechanism& cam, const Motion& motion, const MotionScale& scale)
        : cam_(cam),
          motion_(motion),
          scale_(scale),
          points_(motion.breakpoints()),
          at_samples_(static_cast<std::size_t>(cam.formulas->stations())) {}

    [[nodiscard]] Extremum largest(const CamPlaceFigure& figure) const {
        std::optional<Extremum> best;
        for (int station = 0; station < cam_.formulas->stations(); ++station) {
            const Extremum one = largest(figure, station);
            if (!best || one.value > best->value) best = one;
        }
        return *best;
    }
    [[nodiscard]] Extremum largest(const CamPlaceFigure& figure, int station) const {
        const auto along = [&](double x, Side side) { return figure(place(motion_.at(x, side), station)); };
        const std::vector<CamPlace>& known = at_samples(station);
        if (known.empty()) return largest_along(points_, along);
        return largest_along(points_, along, [&](std::size_t k) { return figure(known[k]); });
    }
    [[nodiscard]] Extremum least(const CamPlaceFigure& figure, int station) const {
        Extremum found = largest([&](const CamPlace& place) { return -figure(place); }, station);
        found.value = -found.value;
        return found;
    }
    [[nodiscard]] Extremum least(const CamPlaceFigure& figure) const {
        Extremum found = largest([&](const CamPlace& place) { return -figure(place); });
        found.value = -found.value;
        return found;
    }
    /// |φ| with s' = 0 put in, without its rounding.
    [[nodiscard]] double pressure_angle_at_rest(double x) const {
        double largest = 0.0;
        for (int station = 0; station < cam_.formulas->stations(); ++station)
            largest = std::max(largest, pressure_angle_at_rest(x, station));
        return largest;
    }

 private:
    [[nodiscard]] double pressure_angle_at_rest(double x, int station) const {
        FollowerState state = state_of(motion_at(motion_, x), scale_);
        state.velocity = 0.0;
        const double theta = scale_.unit_angle * x;
        return std::abs(cam_.formulas->point(theta, {cam_.dimensions, state}, station).pressure_angle);
    }
    [[nodiscard]] CamPlace place(const MotionPoint& motion, int station) const {
        return {mechanism_point(cam_, motion, scale_, station), state_of(motion, scale_)};
    }

    /// Empty where there are too many to keep.
    [[nodiscard]] const std::vector<CamPlace>& at_samples(int station) const {
        constexpr std::size_t most_kept = 50000;  // some 10 MB
        std::vector<CamPlace>& known = at_samples_[static_cast<std::size_t>(station)];
        if (!known.empty()) return known;
        const std::vector<SamplePlace> places = sample_places(points_);
        if (places.size() > most_kept) return known;
        known.reserve(places.size());
        for (const SamplePlace& at : places) known.push_back(place(motion_.at(at.at, at.side), station));
        return known;
    }

    const DrivenMechanism& cam_;
    const Motion& motion_;
    MotionScale scale_;
    std::vector<double> points_;
    mutable std::vector<std::vector<CamPlace>> at_samples_;  ///< of every station, once asked for
};

// Private to studies/delivered: the figures that only a follower which touches its cam has: the pressure
// angle by strokes, whether it can touch at all, what it carries.

// Of the mean velocity: what is slower rests.
constexpr double at_rest = 1e-9;

struct ForcedMotion {
    const ForceSpec& forces;
    double speed = 0.0;
};

/// None where neither is there.
std::optional<CamExtreme> larger(const std::optional<CamExtreme>& one,
                                 const std::optional<CamExtreme>& other) {
    if (!one || !other) return one ? one : other;
    return one->value >= other->value ? one : other;
}

void keep_least(std::optional<CamExtreme>& least, const std::optional<CamExtreme>& other) {
    if (other && (!least || other->value < least->value)) least = other;
}

/// Where one station carries: 0 elsewhere. The largest of those of a side.
void add_side_loads(SideSummary& side, int station, const DrivenMechanism& cam, const CamTurn& turn,
                    const ForcedMotion& forced) {
    const auto normal = [&](const CamPlace& place) {
        const double force = forced.forces.force(forced.speed, place.state, place.point.theta);
        return std::max(0.0, normal_force(cam, place.state, force, station));
    };
    side.normal_force = larger(side.normal_force, turn.largest(normal, station));
    if (!has_hertz_pressure(*cam.formulas, forced.forces)) return;
    const CamExtreme pressure = turn.largest(
        [&](const CamPlace& place) {
            return hertz_pressure(cam, forced.forces, place.point, normal(place), station);
        },
        station);
    side.hertz_pressure = larger(side.hertz_pressure, pressure);
}

/// The larger of the two sides, each of which carries a part of the turn.
void set_largest_loads(ForceSummary& summary, const std::vector<SideSummary>& sides) {
    for (const SideSummary& side : sides) {
        summary.normal_force = larger(summary.normal_force, side.normal_force);
        summary.hertz_pressure = larger(summary.hertz_pressure, side.hertz_pressure);
    }
}

/// The force is a ω² + b ω + c, so c u² + b u + a = 0 for u = 1/ω, whose largest value is that of the lowest
/// ω.
std::optional<CamExtreme> lift_off_speed(const CamTurn& turn, const ForcedMotion& forced) {
    constexpr double fastest = 10.0;  // times the scene's speed
    CamExtreme longest = turn.largest([&](const CamPlace& place) {
        const auto force = [&](double speed) {
            return forced.forces.force(speed, place.state, place.point.theta);
        };
        const double c = force(0.0), forwards = force(1.0), backwards = force(-1.0);
        if (!(c > 0.0)) return infinity;
        const double a = 0.5 * (forwards + backwards) - c, b = 0.5 * (forwards - backwards);
        const double square = b * b - 4.0 * a * c;
        return square < 0.0 ? 0.0 : std::max(0.0, (std::sqrt(square) - b) / (2.0 * c));
    });
    if (!std::isfinite(longest.value) || !(longest.value * fastest * forced.speed > 1.0)) return {};
    longest.value = 1.0 / longest.value;
    return longest;
}

ForceSummary force_summary(const DrivenMechanism& cam, const CamTurn& turn, const ForcedMotion& forced,
                           CamSummary& of) {
    const std::optional<double>& no_contact = of.no_contact;
    const ForceSpec& forces = forced.forces;
    const auto force = [&](const CamPlace& place) {
        return forces.force(forced.speed, place.state, place.point.theta);
    };
    const auto normal = [&](const CamPlace& place) { return normal_force(cam, place.state, force(place)); };
    ForceSummary summary;
    summary.least_force = turn.least(force);
    summary.largest_force = turn.largest(force);
    summary.torque =
        turn.largest([&](const CamPlace& place) { return std::abs(force(place) * place.state.velocity); });
    if (const std::optional<double> slide = cam.formulas->slide(cam.dimensions))
        summary.driving_force = CamExtreme{summary.torque.value / *slide, summary.torque.at};
    const bool presses = has_hertz_pressure(*cam.formulas, forces);
    if (no_contact) {
        // Formulas would go on with a negative radius or lever; there is no pressure to speak of.
        summary.normal_force = CamExtreme{infinity, *no_contact};
        if (presses) summary.hertz_pressure = summary.normal_force;
        for (SideSummary& side : of.sides) {
            side.normal_force = summary.normal_force;
            side.hertz_pressure = summary.hertz_pressure;
        }
        return summary;
    }
    if (!of.sides.empty()) {
        for (int station = 0; station < cam.formulas->stations(); ++station)
            add_side_loads(of.sides.at(static_cast<std::size_t>(cam.formulas->side_of(station))), station,
                           cam, turn, forced);
        set_largest_loads(summary, of.sides);
        return summary;
    }
    summary.normal_force = turn.largest(normal);
    if (!presses) return summary;
    summary.hertz_pressure = turn.largest(
        [&](const CamPlace& place) { return hertz_pressure(cam, forces, place.point, normal(place)); });
    if (of.cusp()) summary.hertz_pressure = CamExtreme{infinity, of.regularity.at};
    return summary;
}

/// Where 1 + σψ' of an oscillating flat face is least; sense: σ.
CamExtreme least_turning(double sense, const CamTurn& turn) {
    return turn.least([sense](const CamPlace& place) { return 1.0 + sense * place.state.velocity; });
}

/// A face that turns back has no radius and no place of contact there: the formulas pass through infinity.
void set_turning_back(CamSummary& summary, const CamExtreme& turning) {
    summary.regularity = turning;
    summary.convex_radius = CamExtreme{-infinity, turning.at};
    summary.contact_offset = CamExtreme{infinity, turning.at};
}

std::optional<double> place_without_contact(const DrivenMechanism& cam, const CamTurn& turn,
                                            const CamSummary& summary) {
    using enum MechanismQuantity;
    if (summary.undercut()) return summary.regularity.at;
    for (int side = 0; side < cam.formulas->stations(); ++side) {
        const CamExtreme height = turn.least(
            [&](const CamPlace& place) {
                const MechanismState state{cam.dimensions, place.state};
                return cam.formulas->quantity(pressure_denominator, state, side, {}).value;
            },
            side);
        if (!(height.value > 0.0)) return height.at;
    }
    return {};
}

CamExtreme rest_pressure(const CamTurn& turn, const Scene& scene) {
    CamExtreme worst;
    for (const double x : rest_places(scene)) {
        const double angle = turn.pressure_angle_at_rest(x);
        if (angle > worst.value) worst = {angle, x};
    }
    return worst;
}

void add_stroke_figures(CamSummary& summary, const DirectCam& direct, const CamTurn& turn,
                        const Scene& scene) {
    const auto angle = [](const CamPlace& place) { return std::abs(place.point.pressure_angle); };
    const double still = at_rest * scene.motion.lift / scene.motion.unit_angle();
    summary.rise_pressure_angle = turn.largest(
        [&](const CamPlace& place) { return place.state.velocity > still ? angle(place) : 0.0; });
    summary.return_pressure_angle = turn.largest(
        [&](const CamPlace& place) { return place.state.velocity < -still ? angle(place) : 0.0; });
    summary.rest_pressure_angle = rest_pressure(turn, scene);
    if (const double sense = direct.face_turn(); sense != 0.0) {
        const CamExtreme turning = least_turning(sense, turn);
        if (!(turning.value > 0.0)) set_turning_back(summary, turning);
    }
}

/// The flanks of a three-dimensional cam: the worst of each along its roller.
void add_flanks(CamSummary& summary, const DrivenMechanism& cam, const CamTurn& turn) {
    const CamMechanism& formulas = *cam.formulas;
    for (int i = 0; i < formulas.sides(); ++i) {
        SideSummary side;
        side.name = formulas.side_name(i);
        std::optional<CamExtreme> margin;
        for (int station = 0; station < formulas.stations(); ++station) {
            if (formulas.side_of(station) != i) continue;
            const CamExtreme angle = turn.largest(
                [](const CamPlace& place) { return std::abs(place.point.pressure_angle); }, station);
            side.pressure_angle = *larger(side.pressure_angle, angle);
            keep_least(margin,
                       turn.least([](const CamPlace& place) { return place.point.regularity; }, station));
        }
        side.regularity = margin.value();
        summary.sides.push_back(std::move(side));
    }
}

/// Of a cam that carries the load; nothing to do for another. The summary has what every cam has.
void add_follower_figures(CamSummary& summary, const DrivenMechanism& cam, const CamTurn& turn,
                          const Scene& scene) {
    if (!cam.formulas->carries_load()) return;
    const bool loaded = scene.forces && scene.motion.speed;
    if (const DirectCam* const direct = cam.formulas->direct())
        add_stroke_figures(summary, *direct, turn, scene);
    else if (loaded)
        add_flanks(summary, cam, turn);
    else
        return;
    summary.no_contact = place_without_contact(cam, turn, summary);
    if (!loaded) return;
    const CamSummary without_loads = summary;
    for (const LoadSpeed& speed : scene.load_speeds()) {
        if (!speed.is_speed) continue;
        if (!summary.forces) {
            const ForcedMotion forced{*scene.forces, speed.speed};
            summary.forces = force_summary(cam, turn, forced, summary);
            if (summary.sides.empty()) summary.forces->lift_off_speed = lift_off_speed(turn, forced);
            continue;
        }
        CamSummary other = without_loads;
        other.forces = force_summary(cam, turn, {*scene.forces, speed.speed}, other);
        summary.other_loads.emplace_back(speed.words, *other.forces);
    }
}

/// Radii of the cam follow from the pitch curve's: the curvature is smooth where a radius is not.
SideSummary side_summary(const DrivenMechanism& cam, const CamTurn& turn, int station) {
    SideSummary side;
    side.name = cam.formulas->station_name(station);
    if (cam.formulas->stations() > 1) {
        side.pressure_angle =
            turn.largest([](const CamPlace& place) { return std::abs(place.point.pressure_angle); }, station);
        side.regularity = turn.least([](const CamPlace& place) { return place.point.regularity; }, station);
    }
    const double offset = cam.formulas->surface_offset(cam.dimensions, station);
    const auto curvature = [](const CamPlace& place) { return place.point.pitch_curvature; };
    const CamExtreme sharpest = turn.largest(curvature, station), hollow = turn.least(curvature, station);
    if (sharpest.value > 0.0) side.convex_radius = CamExtreme{1.0 / sharpest.value - offset, sharpest.at};
    if (hollow.value < 0.0) side.concave_radius = CamExtreme{offset - 1.0 / hollow.value, hollow.at};
    return side;
}

void add_radii_of_pitch(CamSummary& summary, const DrivenMechanism& cam, const CamTurn& turn) {
    const int stations = cam.formulas->stations();
    for (int station = 0; station < stations; ++station) {
        SideSummary side = side_summary(cam, turn, station);
        keep_least(summary.convex_radius, side.convex_radius);
        keep_least(summary.concave_radius, side.concave_radius);
        if (stations > 1) summary.sides.push_back(std::move(side));
    }
}

void add_radii_of_face(CamSummary& summary, const CamTurn& turn) {
    summary.convex_radius = turn.least([](const CamPlace& place) { return place.point.cam_radius; });
    summary.contact_offset =
        turn.largest([](const CamPlace& place) { return std::abs(place.point.contact_offset); });
}

/// A limit of 0 is met to the tolerance of the solve, and figures come from a search of their own: a
/// regularity this close to 0 is 0, and with it the radius.
constexpr double cusp_rounding = 1e-8;

void round_cusp(CamExtreme& regularity, std::optional<CamExtreme>& radius) {
    if (!(std::abs(regularity.value) <= cusp_rounding)) return;
    regularity.value = 0.0;
    if (radius) radius->value = 0.0;
}

CamSummary summary_of(const DrivenMechanism& cam, const CamTurn& turn) {
    CamSummary summary;
    summary.pressure_angle =
        turn.largest([](const CamPlace& place) { return std::abs(place.point.pressure_angle); });
    summary.regularity = turn.least([](const CamPlace& place) { return place.point.regularity; });
    if (const auto radii = cam.formulas->radius_quantity()) {
        if (*radii == MechanismQuantity::pitch_curvature)
            add_radii_of_pitch(summary, cam, turn);
        else
            add_radii_of_face(summary, turn);
        const std::optional<double> base = cam.formulas->base_radius(cam.dimensions);
        summary.base_radius =
            base ? *base : turn.least([](const CamPlace& place) { return place.point.contact.norm(); }).value;
    }
    round_cusp(summary.regularity, summary.convex_radius);
    for (SideSummary& side : summary.sides) round_cusp(side.regularity, side.convex_radius);
    return summary;
}

/// The pressure angle that the general limit compares with: of the whole cam, or of the stroke that has no
/// own limit, and always where the follower rests.
std::optional<CamExtreme> general_pressure_angle(const LimitSpec& limits, const CamSummary& summary) {
    const bool rise = limits.rise_pressure_angle.has_value(), back = limits.return_pressure_angle.has_value();
    if (!rise && !back) return summary.pressure_angle;
    if (rise && back) return summary.rest_pressure_angle;
    return larger(rise ? summary.return_pressure_angle : summary.rise_pressure_angle,
                  summary.rest_pressure_angle);
}

std::optional<CamExtreme>& at(LimitedFigures& figures, LimitedFigure which) {
    return figures[static_cast<std::size_t>(which)];
}

void add_limited(SideSummary& side) {
    using enum LimitedFigure;
    for (const LimitedFigure stroke : {pressure_angle, rise_pressure_angle, return_pressure_angle})
        at(side.limited, stroke) = side.pressure_angle;
    at(side.limited, convex_radius) = side.convex_radius;
    at(side.limited, concave_radius) = side.concave_radius;
    at(side.limited, regularity) = side.regularity;
    at(side.limited, hertz_pressure) = side.hertz_pressure;
}

/// Of the force on the cam; where both sides carry, of its magnitude.
CamExtreme largest_load(const ForceSummary& forces, const CamSummary& summary) {
    const CamExtreme &most = forces.largest_force, &least = forces.least_force;
    if (summary.sides.empty() || most.value >= -least.value) return most;
    return {-least.value, least.at};
}

/// What each limit of the scene compares with.
void add_limited(CamSummary& summary, const LimitSpec& limits) {
    using enum LimitedFigure;
    constexpr CamExtreme nowhere{infinity, 0.0};  // a radius that no part of the cam has
    LimitedFigures& all = summary.limited;
    at(all, pressure_angle) = general_pressure_angle(limits, summary);
    at(all, rise_pressure_angle) = larger(summary.rise_pressure_angle, summary.rest_pressure_angle);
    at(all, return_pressure_angle) = larger(summary.return_pressure_angle, summary.rest_pressure_angle);
    at(all, convex_radius) = summary.convex_radius.value_or(nowhere);
    at(all, concave_radius) = summary.concave_radius.value_or(nowhere);
    at(all, regularity) = summary.regularity;
    if (const std::optional<ForceSummary>& forces = summary.forces) {
        at(all, contact_force) = forces->least_force;
        at(all, contact_force_most) = largest_load(*forces, summary);
        at(all, torque) = forces->torque;
        at(all, hertz_pressure) = forces->hertz_pressure;
        for (const auto& [speed, other] : summary.other_loads) {
            if (other.least_force.value < at(all, contact_force)->value)
                at(all, contact_force) = other.least_force;
            at(all, contact_force_most) = larger(at(all, contact_force_most), largest_load(other, summary));
            at(all, torque) = larger(at(all, torque), other.torque);
            at(all, hertz_pressure) = larger(at(all, hertz_pressure), other.hertz_pressure);
        }
    }
    for (SideSummary& side : summary.sides) add_limited(side);
}

}  // namespace

CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const MotionScale& scale) {
    return summary_of(cam, CamTurn(cam, motion, scale));
}

CamSummary cam_summary(const DrivenMechanism& cam, const Motion& motion, const Scene& scene) {
    const CamTurn turn(cam, motion, {scene.motion.lift, scene.motion.unit_angle()});
    CamSummary summary = summary_of(cam, turn);
    add_follower_figures(summary, cam, turn, scene);
    add_limited(summary, scene.limits);
    return summary;
}

}  // namespace camopt
