// SPDX-License-Identifier: MIT
#include "benchmarks/papers/paper_000_parts.hpp"
#include "benchmarks/papers/papers.hpp"

namespace camopt {

namespace {

std::vector<std::string> assumptions() {
    return {
        "Dimensions of guide and rocker: recovered from Table 1 or chosen (table below); the figures that "
        "would show them are not in our copy.",
        "The rocker is one member of a family that fits Table 1 equally well: L1 = 15 in, pin 9 deg above "
        "the body's x axis.",
        "Radius of the roller: 0.5 in.",
        "Long path of the best guide: the roller from 3 to 13.9 in.",
    };
}

std::vector<std::string> notes() {
    return {
        "Roller, recovered: forward L = 1.5 + 500 t² up to 0.158 s; the return is a deceleration, L = 1.5 + "
        "1248.2 (0.258 − t)². Accelerated from rest, as the text can be read, it would be at 13.483 in "
        "where Table 1 prints 9.488.",
        "Forward rows of Table 1 are samples i · 0.00158 s, rounded to 0.001 s.",
        "Eq. 4: L is L′ (a dot is missing). Eq. 5: θ² is θ′². Eq. 8 cites (1) and means (7). Eq. 10: the "
        "radicand D² − E² + F² is D² + E² − F²; (9) has it right. Eq. 12: the last term L′² u sin θ is L′². "
        "Eq. 14: P′x lacks its minus. Eq. 17: needs the four-quadrant arc tangent, counted on without "
        "steps. Eq. 20: the second term of φ″ needs θ″, and the left side of the second line is L2″.",
        "Eq. 3 is right but singular at C = A. Eqs. 2 to 12 and 13 to 23 use one letter for two angles: the "
        "polar angle ψ of the guide, and the angle θ = −ψ of the cam.",
        "Where the guide goes from line to arc its curvature jumps, and with it θ″ and the feeder's "
        "acceleration: the "
        "jerk is infinite there. No number of nodes makes central differences converge across such a jump.",
        "Both strokes start and end at rest at the same place with a constant acceleration, so on one guide "
        "the return is the forward motion run backwards, 1.58 times as fast: velocities times 1.58, "
        "accelerations times 2.4964. The best guide of one stroke is the best of both.",
        "All of it follows from scenes/given_guide_forward.toml and given_guide_return.toml; the best "
        "motions "
        "are proved optimal among cubic splines of 24 segments for the weights of "
        "velocity, acceleration and jerk named (divided by the modified sine's peaks); the guide follows "
        "from the motion in closed form.",
    };
}

}  // namespace

PaperReport paper_000(const SolveControl& control, const PaperProgress& finished) {
    PaperReport report;
    report.id = "000";
    report.title = "Curvilinear inverse cam and feeder";
    report.source =
        "J.-H. Shin, Y.-H. Choi, C.-S. Rho, \"Kinematic Analysis and Simulation of an Automatic Feeding "
        "Mechanism subjected by A Curvilinear Inverse Cam (I)\"";
    report.introduction =
        "A roller runs to and fro on a line and pushes, in a curved guide, a swinging body; its pin swings "
        "a slotted rocker, which moves the feeder. θ: angle of the body, Y: place of the feeder, L: roller "
        "from the body's pivot, µ: pressure angle of the roller in the guide; ′ is by time.";
    report.assumptions = assumptions();
    report.tables = feeding_paper::printed_tables();
    report.figures = feeding_paper::printed_figures();
    if (finished) finished("Table 1");
    feeding_paper::add_checks(report);
    if (finished) finished("forward simulation");
    feeding_paper::add_guides(report, control, finished);
    report.notes = notes();
    return report;
}

}  // namespace camopt
