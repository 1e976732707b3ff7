// SPDX-License-Identifier: MIT
#include "benchmarks/papers/guide.hpp"
#include "benchmarks/papers/paper_000_parts.hpp"
#include "benchmarks/papers/wished_guide.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "studies/solve/solve.hpp"

#include <fmt/format.h>

namespace camopt::feeding_paper {

namespace {

using units::inch;
constexpr int guide_nodes = 64;
constexpr int segments = 24;                                     // of the motion spline
constexpr double wide_from = 3.0 * inch, wide_to = 13.9 * inch;  // chosen

FeederWish wish(double from, double to) {
    const G1GuideDimensions arcs = forward_guide();
    FeederWish wish;
    wish.linkage = linkage();
    wish.stroke = roller_law().strokes()[0];
    wish.from = from;
    wish.to = to;
    wish.lower = feeder_motion(wish.linkage, {}).feeder.s;
    wish.upper = feeder_motion(wish.linkage, {-arcs.end_angle, 0.0, 0.0}).feeder.s;
    wish.guide_begin = arcs.begin;
    wish.guide_end = arcs.end;
    return wish;
}

Scene scene_of_weights(double velocity, double acceleration, double jerk) {
    Scene scene;
    scene.title = "Feeder of an inverse cam";
    scene.spline.segments = segments;
    scene.objective.velocity = velocity;
    scene.objective.acceleration = acceleration;
    scene.objective.jerk = jerk;
    return scene;
}

/// A guide with a name, what it was made for, and how well that is proved.
struct Candidate {
    std::string name, verdict;
    Guide guide;
    std::optional<double> deviation;  ///< of the feeder from its wish, m
};

PaperTable candidate_table(const std::vector<Candidate>& candidates) {
    PaperTable table{"guides",
                     "Guides for the same stroke of the feeder, compared with that of lines and arcs",
                     "Feeder peaks with the paper's roller, forward and return on the same guide (the "
                     "recovered one of the forward stroke, and guides from the wished motion of the feeder "
                     "backwards). Step: jump of the feeder's acceleration at a joint, where the jerk is "
                     "infinite; ours have none. Same path: the feeder moves while the roller is where it "
                     "moves on lines and arcs; long path: while it goes from 3 to 13.9 in (chosen).",
                     {{"guide", "guide", ""},
                      {"velocity_in_s", "Y′ forward", "in/s", 4},
                      {"acceleration_in_s2", "Y″ forward", "in/s²", 5},
                      {"step_in_s2", "step of Y″", "in/s²", 4},
                      {"jerk_in_s3", "Y‴ between steps", "in/s³", 3},
                      {"return_velocity_in_s", "Y′ return", "in/s", 4},
                      {"return_acceleration_in_s2", "Y″ return", "in/s²", 5},
                      {"pressure_angle_deg", "largest µ", "deg", 4},
                      {"least_radius_in", "least radius", "in", 4},
                      {"deviation_in", "feeder off its wish", "in", 2},
                      {"verdict", "motion", ""}},
                     {}};
    for (const Candidate& one : candidates) {
        const GuideFigures f = guide_figures(one.guide, linkage(), roller_law());
        const auto inches = [](double metres) { return metres / inch; };
        std::optional<double> deviation;
        if (one.deviation) deviation = *one.deviation / inch;
        // A spline guide has no step: what is left of one is round-off.
        const double step =
            f.forward.acceleration_step > 1e-6 * f.forward.acceleration ? f.forward.acceleration_step : 0;
        table.rows.push_back({one.name, inches(f.forward.velocity), inches(f.forward.acceleration),
                              inches(step), inches(f.forward.jerk), inches(f.back.velocity),
                              inches(f.back.acceleration), f.pressure_angle / units::degree,
                              inches(f.least_radius), cell_of(deviation), one.verdict});
    }
    return table;
}

PaperTable node_table(const FeederWish& wish, const Motion& motion) {
    PaperTable table{
        "guide_nodes",
        "Best guide: how many nodes it takes",
        "Largest distance of the feeder from the wished motion, guide as a quintic spline through so many "
        "nodes; breakpoints of the motion are nodes too.",
        {{"nodes", "nodes wanted", ""}, {"deviation_in", "feeder off its wish", "in", 3}},
        {}};
    for (const int nodes : {8, 16, 32, 64, 128, 256})
        table.rows.push_back({static_cast<double>(nodes),
                              feeder_deviation(wished_guide(wish, motion, nodes), wish, motion) / inch});
    return table;
}

/// A quantity of the forward stroke over the roller's place, with both sides of every joint.
template <class Quantity>
PaperSeries over_distance(const Candidate& one, const Quantity& quantity) {
    constexpr int points = 200;
    PaperSeries series{one.name, {}, {}};
    const RollerStroke stroke = roller_law().strokes()[0];
    const auto& joints = one.guide.joints();
    const double last = state_of(stroke, stroke.end).distance;
    for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
        const double from = joints[i], to = std::min(joints[i + 1], last);
        for (int k = 0; k <= points && from < to; ++k) {
            const double distance = k == points ? to : from + (to - from) * k / points;
            RollerState roller = state_of(stroke, time_at(stroke, distance));
            roller.distance = distance;
            const InverseState state =
                inverse_state(one.guide, linkage(), roller, k == 0 ? Side::right : Side::left);
            series.x.push_back(distance / inch);
            series.y.push_back(quantity(state));
        }
    }
    return series;
}

void add_figures(PaperReport& report, const std::vector<Candidate>& candidates) {
    PaperFigure shape{"guides_shape", "Guides in the body's frame", "x [in]", "y [in]", {}};
    PaperFigure acceleration{
        "guides_acceleration", "Acceleration of the feeder, forward stroke", "L [in]", "Y″ [in/s²]", {}};
    PaperFigure curvature{"guides_curvature", "Curvature of the guides", "L [in]", "curvature [1/in]", {}};
    PaperFigure pressure{"guides_pressure_angle", "Pressure angle of the guides", "L [in]", "µ [deg]", {}};
    for (const Candidate& one : candidates) {
        PaperSeries line{one.name, {}, {}};
        for (const Eigen::Vector2d& point : guide_points(one.guide, 300).points) {
            line.x.push_back(point.x() / inch);
            line.y.push_back(point.y() / inch);
        }
        shape.series.push_back(std::move(line));
        acceleration.series.push_back(
            over_distance(one, [](const InverseState& s) { return s.feeder.feeder.acceleration / inch; }));
        curvature.series.push_back(
            over_distance(one, [](const InverseState& s) { return s.curvature * inch; }));
        pressure.series.push_back(
            over_distance(one, [](const InverseState& s) { return s.pressure_angle / units::degree; }));
    }
    for (PaperFigure* figure : {&shape, &acceleration, &curvature, &pressure})
        report.figures.push_back(std::move(*figure));
}

}  // namespace

void add_guides(PaperReport& report, const SolveControl& control, const PaperProgress& finished) {
    const Guide arcs = make_g1_guide(forward_guide());
    const FeederWish same = wish(arcs.joints()[1], arcs.joints()[3]), wide = wish(wide_from, wide_to);
    std::vector<Candidate> candidates, drawn;
    candidates.push_back({"lines and arcs", "", arcs, {}});
    drawn.push_back(candidates.back());
    const auto add = [&](const std::string& name, const std::string& verdict, const FeederWish& to,
                         const Motion& motion) {
        Guide guide = wished_guide(to, motion, guide_nodes);
        const double deviation = feeder_deviation(guide, to, motion);
        candidates.push_back({name, verdict, std::move(guide), deviation});
    };
    for (const char* key : {"modified_sine", "polynomial_4567"}) {
        const auto law = make_law(key);
        add(law->title() + ", same path", "law", same, *law);
    }
    struct Weights {
        const char* name;
        double velocity, acceleration, jerk;
    };
    for (const Weights& w :
         {Weights{"best spline 0.4 0.4 0.2", 0.4, 0.4, 0.2}, {"best spline 0.2 0.6 0.2", 0.2, 0.6, 0.2}}) {
        const Solution solution = solve(scene_of_weights(w.velocity, w.acceleration, w.jerk), control);
        if (control.stopped()) return;
        if (solution.certificate.verdict != Verdict::optimal)
            report.faults.push_back(fmt::format("the motion of {} is not proved optimal", w.name));
        if (!solution.curve) continue;
        const std::string verdict = fmt::format("{}, gap {:.1e}", name_of(solution.certificate.verdict),
                                                solution.certificate.gap.value_or(std::nan("")));
        add(std::string(w.name) + ", same path", verdict, same, *solution.curve);
        if (drawn.size() == 1) {
            drawn.push_back(candidates.back());
            report.tables.push_back(node_table(same, *solution.curve));
        }
        add(std::string(w.name) + ", long path", verdict, wide, *solution.curve);
        if (drawn.size() == 2) drawn.push_back(candidates.back());
        if (finished) finished(w.name);
    }
    report.tables.push_back(candidate_table(candidates));
    add_figures(report, drawn);
}

}  // namespace camopt::feeding_paper
