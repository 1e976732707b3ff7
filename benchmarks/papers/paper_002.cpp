// SPDX-License-Identifier: MIT
#include "benchmarks/papers/papers.hpp"
#include "benchmarks/papers/spatial_tables.hpp"
#include "core/units.hpp"
#include "motions/laws/law_catalogue.hpp"
#include "studies/spatial/spatial_forward_check.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using namespace spatial_tables;
using units::degree;
using units::millimetre;

using units::turn;
constexpr double index_angle = turn / 7.0;
// Printed by the paper.
constexpr double printed_roller_radius_mm = 31.75, printed_roller_length_mm = 38.1,
                 printed_index_radius_mm = 164.0, printed_index_deg = 51.43, printed_rpm = 140.0,
                 printed_points = 3200.0, printed_frames = 2000.0;
// Chosen, where the paper gives nothing.
constexpr double center_distance_mm = 150.0;

Example paper_cup_machine() {
    Example example;
    SpatialCam& cam = example.cam;
    cam.follower = SpatialFollower::barrel;
    cam[SpatialDimension::roller_radius] = printed_roller_radius_mm * millimetre;
    cam[SpatialDimension::arm_length] = printed_index_radius_mm * millimetre;
    cam[SpatialDimension::center_distance] = center_distance_mm * millimetre;
    // Halfway between the roller's places at mid-stroke and at its ends.
    cam[SpatialDimension::lateral_offset] =
        0.5 * printed_index_radius_mm * (1.0 + std::cos(0.5 * index_angle)) * millimetre;
    cam.start = -0.5 * index_angle;
    cam.roller_length = printed_roller_length_mm * millimetre;
    example.motion = modified_sine_rise({0.0, 200.0 * degree, 160.0 * degree, index_angle, turn});
    example.input_speed = printed_rpm * turn / 60.0;
    return example;
}

PaperTable given_table(const Example& example, double turned, std::size_t points) {
    const double speed = example.input_speed;
    const Peaks law = make_law("modified_sine")->peaks();
    const double rate = speed / (160.0 * degree);
    const double peak_velocity = index_angle * rate * law.velocity.value;
    const double peak_acceleration = index_angle * rate * rate * law.acceleration.value;
    return comparison_table(
        "given", "What the paper gives, and what follows",
        {{"index turns in one revolution", "deg", printed_index_deg, turned / degree,
          "ours: driven by the points of the flanks, both dwells included"},
         {"index turns in one revolution, in turns", "", 1.0 / 7.0, turned / turn, ""},
         {"roller radius", "mm", printed_roller_radius_mm, printed_roller_radius_mm, "2.5 in diameter"},
         {"roller length", "mm", printed_roller_length_mm, printed_roller_length_mm, "1.5 in"},
         {"index radius", "mm", printed_index_radius_mm, printed_index_radius_mm, ""},
         {"speed", "rad/s", {}, speed, "140 rpm"},
         {"points of the profile", "", printed_points, static_cast<double>(points), "printed: about 3200"},
         {"camera frames a revolution", "", {}, printed_frames * 60.0 / printed_rpm, "2000 frames/s"},
         {"time of the index", "s", {}, 160.0 / 360.0 * 60.0 / printed_rpm, ""},
         {"peak velocity of the index", "rad/s", {}, peak_velocity, ""},
         {"peak acceleration of the index", "rad/s²", {}, peak_acceleration, ""}});
}

/// S(T) as printed in (5) to (7), and as it must read.
struct ModifiedSine {
    double ramp = 0.125;
    double peak =
        1.0 / (2.0 * ramp / std::numbers::pi + (2.0 - 8.0 * ramp) / (std::numbers::pi * std::numbers::pi));
    double quarter = 4.0 * ramp * ramp * peak / (std::numbers::pi * std::numbers::pi);
    double middle = std::pow((1.0 - 2.0 * ramp) / std::numbers::pi, 2) * peak;
    double speed = 2.0 * ramp * peak / std::numbers::pi;
    double first = 2.0 * ramp * ramp * peak / std::numbers::pi - quarter;

    [[nodiscard]] double wave(double t) const {
        const double pi = std::numbers::pi;
        if (t <= ramp) return -quarter * std::sin(pi * t / (2.0 * ramp));
        if (t <= 1.0 - ramp) return middle * (1.0 - std::cos(pi * (t - ramp) / (1.0 - 2.0 * ramp)));
        return quarter * (std::cos(pi * (t - 1.0 + ramp) / (2.0 * ramp)) - 1.0);
    }
    [[nodiscard]] double printed(double t) const {
        if (t <= ramp) return ramp * speed * t + wave(t);
        if (t <= 1.0 - ramp) return speed * (t - 1.0 - ramp) + first + wave(t);
        return speed * (t - ramp) + first + wave(t);
    }
    [[nodiscard]] double corrected(double t) const {
        if (t <= ramp) return speed * t + wave(t);
        if (t <= 1.0 - ramp) return speed * (t - ramp) + first + wave(t);
        return speed * (t - 1.0 + ramp) + 1.0 - first + wave(t);
    }
};

PaperTable law_table(const Example& example) {
    PaperTable table{"modified_sine",
                     "Equations (5) to (7): the modified sine as printed and as it must read",
                     "Read literally the three formulas do not join and end far from 1.",
                     {{"t", "T", "", 6},
                      {"printed", "printed", "", 6},
                      {"corrected", "corrected", "", 9},
                      {"catalogue", "law of the catalogue", "", 9}},
                     {}};
    const ModifiedSine law;
    for (const double t : {0.0, 0.0625, 0.125, 0.25, 0.5, 0.75, 0.875, 0.9375, 1.0}) {
        const double theta = (200.0 + 160.0 * t) * degree;
        table.rows.push_back(
            {t, law.printed(t), law.corrected(t), example.motion.state(theta).s / index_angle});
    }
    return table;
}

PaperTable points_table(const Example& example) {
    PaperTable table{
        "points_280",
        "Points of the flanks at cam angle 280 deg",
        "θ_r: the paper's contact angle on the roller, atan2(−σ ρ cos a, −σ (r_i a' − ρ sin a)).",
        {{"height_mm", "height", "mm", 5},
         {"flank", "flank", ""},
         {"theta_r_rad", "θ_r", "rad", 12},
         {"x_mm", "x", "mm", 12},
         {"y_mm", "y", "mm", 12},
         {"z_mm", "z", "mm", 12},
         {"tan_phi", "tan φ", "", 12},
         {"g", "g", "", 12}},
        {}};
    const double theta = 280.0 * degree;
    const SpatialCam& cam = example.cam;
    const FollowerState state = example.motion.state(theta);
    const double a = cam.start + state.s;
    for (const int flank : {1, -1})
        for (const double height : {0.0, cam.roller_length}) {
            const SpatialPoint point = spatial_point(cam, theta, state, {height, flank});
            const double rho = cam[SpatialDimension::center_distance] - height;
            const double contact =
                std::atan2(-flank * rho * std::cos(a),
                           -flank * (cam[SpatialDimension::arm_length] * state.velocity - rho * std::sin(a)));
            table.rows.push_back({height / millimetre, std::string(flank > 0 ? "+" : "-"), contact,
                                  point.contact.x() / millimetre, point.contact.y() / millimetre,
                                  point.contact.z() / millimetre, std::tan(point.pressure_angle),
                                  point.undercut});
        }
    return table;
}

/// What the index turns in one revolution, from inside one dwell to inside the next, driven by the points of
/// the flanks; beside it, how far it is from the designed motion all along.
struct Revolution {
    double travel = 0.0;
    PaperFigure motion, error;
};

Revolution one_revolution(const Example& example) {
    Example longer = example;
    longer.motion =
        modified_sine_rise({-20.0 * degree, 200.0 * degree, 160.0 * degree, index_angle, 400.0 * degree});
    const FlankGrid grid =
        flank_grid(longer.cam, longer.motion, FlankSampling{.sections = 2, .angles = 1601});
    FlankContact contact(longer.cam, sections_of(grid).back(), grid.breaks, 0.0);
    PaperSeries designed{"entered motion", {}, {}}, driven{"driven by the flank's points", {}, {}, true},
        error{"difference", {}, {}};
    Revolution result;
    for (int i = 0; i <= 360; ++i) {
        const double theta = i * degree;
        const double found = contact.at(theta).s, wanted = longer.motion.state(theta).s;
        designed.x.push_back(i);
        designed.y.push_back(wanted / degree);
        if (i % 10 == 0) {
            driven.x.push_back(i);
            driven.y.push_back(found / degree);
        }
        error.x.push_back(i);
        error.y.push_back(found - wanted);
        result.travel = found - driven.y.front() * degree;
    }
    result.motion = {
        "figure_12", "Fig. 12: rotation of the index", "cam angle, deg", "index, deg", {designed, driven}};
    result.error = {"figure_12_error", "Error of the index's rotation", "cam angle, deg", "rad", {error}};
    return result;
}

std::vector<std::string> errata() {
    return {
        "(5): the linear term is 2 T_a A_m/π · T, printed with T_a².",
        "(6): V_a(T − T_a), printed V_a(T − 1 − T_a).",
        "(7): V_a(T − 1 + T_a) + S_b, printed V_a(T − T_a) + S_a; as printed S(1) = 0.3699.",
        "(5) to (7) define S; printed is S_a on their left sides.",
        "(8), (9): the translation is counted twice, and its order contradicts Table 2. (10) needs "
        "(−l1, l3, −l2) and h along −y; it is right with θ_3 read as θ_i.",
        "(11) to (13) are right. θ_r goes into (10), not into (1).",
        "(14) to (23): read as tan θ_r = ρ cos a/(r_i a' − ρ sin a) their structure is right. What stands "
        "for ρ, h_r + h_ri cos 2θ_1, must be the constant l3 − h: one sign in the y row of (10) makes "
        "exactly that cos 2θ_1. The radius in them is the index's, not the roller's."};
}

}  // namespace

PaperReport paper_002_as_printed(const PaperProgress& finished) {
    const Example example = paper_cup_machine();
    PaperReport report;
    report.id = "002";
    report.title = "Barrel cam of a machine that makes paper cups";
    report.source =
        "W. H. Kim, T. W. Park, \"Development of Program for Designing Barrel Cam of Machine Making Paper "
        "Cups\", 2011";
    report.introduction =
        "A barrel cam turns an index of seven rollers by one seventh of a turn in 160 deg of each revolution "
        "and holds it for 200 deg. The paper's check is a simulation of the machine; ours is a contact "
        "simulation that knows nothing but points of the flanks.";
    report.assumptions = {
        "l2 = 0",
        fmt::format("l1 = r_i (1 + cos(π/7))/2 = {:.6f} mm: the least lateral offset over the stroke, "
                    "8.1206 mm",
                    example.cam[SpatialDimension::lateral_offset] / millimetre),
        "l3 = 150 mm: the smallest multiple of 5 mm with a pressure angle of at most 40 deg in mid-stroke at "
        "the roller's tip",
        "roller 0 runs from −π/7 to +π/7; sections from h = 0 to 38.1 mm; the cam turns counterclockwise"};
    const FlankGrid cloud =
        flank_grid(example.cam, example.motion, FlankSampling{.sections = 8, .angles = 201});
    const Revolution revolution = one_revolution(example);
    report.tables = {given_table(example, revolution.travel, 2 * cloud.flanks[0].points.size()),
                     law_table(example),
                     pressure_table(example),
                     undercut_table(example),
                     points_table(example),
                     forward_table(example, {201, 401, 1601, 6401}, finished)};
    report.figures = {displacement_figure(example, "figure_2", "Fig. 2: displacement of the index"),
                      unrolled_figure(example, "figure_6", "Fig. 6: flanks of one roller's track, unrolled"),
                      pressure_figure(example),
                      undercut_figure(example),
                      revolution.motion,
                      revolution.error};
    report.notes = errata();
    report.notes.push_back(fmt::format(
        "The flanks by envelope (the paper's method) and by relative velocity differ by at most {:.1e} mm.",
        method_difference_mm(example)));
    if (!(std::abs(revolution.travel - index_angle) < 1e-9))
        report.faults.emplace_back("the flanks do not turn the index by one seventh of a turn");
    return report;
}

PaperReport paper_002(const SolveControl& control, const PaperProgress& finished) {
    PaperReport report = paper_002_as_printed(finished);
    BarrelOptima optima = barrel_optima(paper_cup_machine(), control, finished);
    report.tables.push_back(std::move(optima.table));
    report.figures.push_back(std::move(optima.figure));
    report.faults.insert(report.faults.end(), optima.faults.begin(), optima.faults.end());
    return report;
}

}  // namespace camopt
