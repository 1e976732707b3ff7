// SPDX-License-Identifier: MIT
// What an elastic follower makes of a rise: one mass without a return spring, at one speed.
#include "benchmarks/trains/exact_chain.hpp"
#include "tests/soak/figures/motion_figures.hpp"

#include <cmath>

namespace camopt::soak {

namespace {

constexpr int places_a_piece = 64;

/// y'' by powers of x from the begin of each piece on, and what y' jumps by between two: rounding, which a
/// stiff train makes much of.
std::vector<trains::InputPiece> input_pieces(const Motion& motion) {
    std::vector<trains::InputPiece> pieces;
    long double before = 0;
    for (const Piece& piece : motion.pieces) {
        const Polynomial velocity = derivative_of(piece.y);
        const long double width = piece.end - piece.begin;
        trains::InputPiece input{static_cast<double>(width), {}, 0.0};
        for (const long double power : derivative_of(velocity))
            input.powers.push_back(static_cast<double>(power));
        input.kick = static_cast<double>(velocity.front() - before);
        before = value_at(velocity, width);
        pieces.push_back(std::move(input));
    }
    // The last jump: the motion ends at rest.
    pieces.push_back({0.0, {0.0}, static_cast<double>(-before)});
    return pieces;
}

}  // namespace

TrainFigures train_figures(const SceneNumbers& scene, const Motion& motion) {
    const Train& train = scene.train.value();
    // Time is x: T seconds are 1.
    const double seconds = motion.unit_angle / scene.speed;
    const double stiffness = train.stiffness * seconds * seconds, damping = train.damping * seconds;
    trains::Chain chain;
    chain.masses = {{train.mass, stiffness, damping}};
    chain.frequency = std::sqrt(stiffness / train.mass);
    chain.size = 1.0 / (chain.frequency * chain.frequency);
    const trains::ExactResponse found = exact_response(chain, input_pieces(motion), places_a_piece);
    TrainFigures figures;
    const double ratio = damping / (2.0 * chain.frequency * train.mass);
    if (ratio < 1.0)
        figures.residual = chain.size * std::hypot(found.output, (found.rate + ratio * found.output) /
                                                                     std::sqrt(1.0 - ratio * ratio));
    figures.least_force = train.preload - motion.lift * chain.size * found.largest_pull / (seconds * seconds);
    return figures;
}

}  // namespace camopt::soak
