// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_000_parts.hpp"
#include "core/units.hpp"
#include "profiles/inverse/inverse_spec.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

namespace camopt::feeding_paper {

namespace {

using units::inch;

struct Weights {
    double velocity, acceleration, jerk;
};
constexpr Weights even{0.4, 0.4, 0.2}, smooth{0.2, 0.6, 0.2};
constexpr double wide_from = 3.0 * inch, wide_to = 13.9 * inch;  // chosen

/// The machine of the forward stroke without its guide: the feeder rises while the roller goes from one
/// distance to another.
Scene machine_scene(double from, double to, const Weights& weights) {
    constexpr int segments = 24;
    Scene scene = forward_stroke().solution().scene;
    scene.measured.reset();
    scene.cam->pieces.clear();
    scene.cam->set(name_of_number(InverseNumber::roller_from), from);
    const RollerStroke roller = stroke_of(scene.cam->middle());
    scene.motion.rise = time_at(roller, to);
    scene.spline = {};
    scene.spline.segments = segments;
    scene.objective.velocity = weights.velocity;
    scene.objective.acceleration = weights.acceleration;
    scene.objective.jerk = weights.jerk;
    return scene;
}

/// A guide with a name, and the motion that it makes.
struct Candidate {
    std::string name, verdict;
    DrivenMechanism cam;
    MotionScale scale;
    std::shared_ptr<const MotionChain> motion;
    double speed = 0.0;
};

struct Place {
    double distance = 0.0;  ///< of the roller
    FollowerState feeder;   ///< by time
    double pressure_angle = 0.0, curvature = 0.0;
};

Place place_at(const Candidate& one, double x, Side side) {
    const MotionPoint at = one.motion->at(x, side);
    const MechanismPoint point = mechanism_point(one.cam, at, one.scale);
    const FollowerState state = state_of(at, one.scale);
    return {state_of(stroke_of(one.cam.dimensions), one.scale.unit_angle * x).distance,
            {state.s, state.velocity * one.speed, state.acceleration * one.speed * one.speed},
            point.pressure_angle,
            point.pitch_curvature};
}

/// Places of the stroke in order, at each breakpoint of the motion from both sides.
std::vector<Place> places_of(const Candidate& one) {
    constexpr int points = 2000;
    const std::vector<double> breaks = one.motion->breakpoints();
    std::vector<Place> places;
    for (const double x : even_places(breaks, points)) {
        const bool joint = std::ranges::binary_search(breaks, x);
        if (joint && x > breaks.front()) places.push_back(place_at(one, x, Side::left));
        if (!joint || x < breaks.back()) places.push_back(place_at(one, x, Side::right));
    }
    return places;
}

/// Largest magnitudes along a guide.
struct GuideFigures {
    double velocity = 0.0, acceleration = 0.0, step = 0.0, pressure_angle = 0.0, curvature = 0.0;
};

GuideFigures figures_of(const std::vector<Place>& places) {
    constexpr double rounding = 1e-6;  // of the largest acceleration: a smaller step is none
    GuideFigures most;
    const Place* before = nullptr;
    for (const Place& place : places) {
        most.velocity = std::max(most.velocity, std::abs(place.feeder.velocity));
        most.acceleration = std::max(most.acceleration, std::abs(place.feeder.acceleration));
        most.pressure_angle = std::max(most.pressure_angle, std::abs(place.pressure_angle));
        most.curvature = std::max(most.curvature, std::abs(place.curvature));
        if (before != nullptr && before->distance == place.distance)
            most.step =
                std::max(most.step, std::abs(place.feeder.acceleration - before->feeder.acceleration));
        before = &place;
    }
    if (most.step <= rounding * most.acceleration) most.step = 0.0;
    return most;
}

PaperTable candidate_table(const std::vector<Candidate>& candidates) {
    PaperTable table{
        "guides",
        "Guides for the same stroke of the feeder, compared with that of lines and arcs",
        "Feeder peaks with the paper's roller, forward stroke: the given guide, and laws and optima "
        "in the same machine without it. Step: jump of the feeder's acceleration at a joint, where "
        "the jerk is infinite; ours have none. Same path: the feeder moves while the roller is "
        "where it moves on lines and arcs; long path: while it goes from 3 to 13.9 in (chosen). "
        "On the return the velocities are 1.58, the accelerations 2.4964 times as large.",
        {{"guide", "guide", ""},
         {"velocity_in_s", "Y′", "in/s", 4},
         {"acceleration_in_s2", "Y″", "in/s²", 5},
         {"step_in_s2", "step of Y″", "in/s²", 4},
         {"pressure_angle_deg", "largest µ", "deg", 4},
         {"least_radius_in", "least radius", "in", 4},
         {"verdict", "motion", ""}},
        {}};
    for (const Candidate& one : candidates) {
        const GuideFigures f = figures_of(places_of(one));
        table.rows.push_back({one.name, f.velocity / inch, f.acceleration / inch, f.step / inch,
                              f.pressure_angle / units::degree, 1.0 / (f.curvature * inch), one.verdict});
    }
    return table;
}

void add_figures(PaperReport& report, const std::vector<Candidate>& candidates) {
    PaperFigure shape{"guides_shape", "Guides in the body's frame", "x [in]", "y [in]", {}};
    PaperFigure acceleration{
        "guides_acceleration", "Acceleration of the feeder, forward stroke", "L [in]", "Y″ [in/s²]", {}};
    PaperFigure curvature{"guides_curvature", "Curvature of the guides", "L [in]", "curvature [1/in]", {}};
    PaperFigure pressure{"guides_pressure_angle", "Pressure angle of the guides", "L [in]", "µ [deg]", {}};
    const auto add = [](PaperFigure& figure, const Candidate& one, const std::vector<Place>& places,
                        const std::function<double(const Place&)>& quantity) {
        PaperSeries series{one.name, {}, {}};
        for (const Place& place : places) {
            series.x.push_back(place.distance / inch);
            series.y.push_back(quantity(place));
        }
        figure.series.push_back(std::move(series));
    };
    for (const Candidate& one : candidates) {
        const std::vector<Place> places = places_of(one);
        PaperSeries line{one.name, {}, {}};
        for (const MechanismPoint& point : mechanism_profile(one.cam, *one.motion, one.scale, 300).points) {
            line.x.push_back(point.pitch.x() / inch);
            line.y.push_back(point.pitch.y() / inch);
        }
        shape.series.push_back(std::move(line));
        add(acceleration, one, places, [](const Place& place) { return place.feeder.acceleration / inch; });
        add(curvature, one, places, [](const Place& place) { return place.curvature * inch; });
        add(pressure, one, places, [](const Place& place) { return place.pressure_angle / units::degree; });
    }
    for (PaperFigure* figure : {&shape, &acceleration, &curvature, &pressure})
        report.figures.push_back(std::move(*figure));
}

Candidate candidate_of(const std::string& name, const Scene& scene,
                       std::shared_ptr<const MotionChain> motion) {
    return {name,
            "",
            {scene.cam->formulas(), scene.cam->middle()},
            {scene.motion.lift, scene.motion.unit_angle()},
            std::move(motion),
            scene.motion.speed.value()};
}

}  // namespace

void add_guides(PaperReport& report, const SolveControl& control, const PaperProgress& finished) {
    const Solution& given = forward_stroke().solution();
    const RollerStroke roller = stroke_of(given.cam->cam.dimensions);
    const std::vector<double>& breaks = given.scene.measured->breaks;
    const double same_from = state_of(roller, breaks.front()).distance,
                 same_to = state_of(roller, breaks.back()).distance;
    std::vector<Candidate> candidates, drawn;
    candidates.push_back(candidate_of("lines and arcs", given.scene, given.motion));
    candidates.back().verdict = "given";
    drawn.push_back(candidates.back());
    const auto add_optimum = [&](const std::string& name, const Scene& scene, const Solution& solution) {
        if (solution.certificate.verdict != Verdict::optimal)
            report.faults.push_back(fmt::format("the motion of {} is not proved optimal", name));
        if (!solution.motion) return;
        candidates.push_back(candidate_of(name, scene, solution.motion));
        candidates.back().verdict = fmt::format("{}, gap {:.1e}", name_of(solution.certificate.verdict),
                                                solution.certificate.gap.value_or(std::nan("")));
        if (finished) finished(name);
    };
    const Scene same = machine_scene(same_from, same_to, even);
    const Comparison comparison = compare(same, control);
    for (const char* key : {"modified_sine", "polynomial_4567"}) {
        const auto row = std::ranges::find(comparison.rows, key, &ComparisonRow::key);
        if (row == comparison.rows.end()) continue;
        candidates.push_back(candidate_of(row->title + ", same path", same, row->motion));
        candidates.back().verdict = "law";
    }
    add_optimum("best spline 0.4 0.4 0.2, same path", same, comparison.optimum);
    if (control.stopped()) return;
    drawn.push_back(candidates.back());
    const auto solve_for = [&](const std::string& name, double from, double to, const Weights& weights) {
        const Scene scene = machine_scene(from, to, weights);
        add_optimum(name, scene, solve(scene, control));
    };
    solve_for("best spline 0.4 0.4 0.2, long path", wide_from, wide_to, even);
    drawn.push_back(candidates.back());
    solve_for("best spline 0.2 0.6 0.2, same path", same_from, same_to, smooth);
    solve_for("best spline 0.2 0.6 0.2, long path", wide_from, wide_to, smooth);
    report.tables.push_back(candidate_table(candidates));
    add_figures(report, drawn);
}

}  // namespace camopt::feeding_paper
