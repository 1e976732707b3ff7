// SPDX-License-Identifier: MIT
#include "benchmarks/stability/train_audit.hpp"

#include "core/errors.hpp"

#include <cmath>

namespace camopt::stability {

namespace {

constexpr int places_a_piece = 64;

/// y'' by powers of x from the begin of each piece on, and what y' jumps by between two: rounding, which a
/// stiff train makes much of.
std::vector<trains::InputPiece> input_pieces(const SplineCurve& curve) {
    std::vector<trains::InputPiece> pieces;
    long double before = 0;
    for (int segment = 0; segment < curve.segments(); ++segment) {
        trains::InputPiece piece{
            curve.space().breakpoints()[segment + 1] - curve.space().breakpoints()[segment], {}, 0.0};
        const auto coefficient = [&](int k) { return static_cast<long double>(curve.pieces()(k, segment)); };
        for (int k = 2; k <= curve.degree(); ++k)
            piece.powers.push_back(k * (k - 1) * curve.pieces()(k, segment));
        piece.kick = static_cast<double>(coefficient(1) - before);
        before = 0;
        for (int k = curve.degree(); k >= 1; --k) before = before * piece.width + k * coefficient(k);
        pieces.push_back(std::move(piece));
    }
    // The last jump: the motion ends at rest.
    pieces.push_back({0.0, {0.0}, static_cast<double>(-before)});
    return pieces;
}

}  // namespace

TrainAudit train_audit(const Solution& solution) {
    const Scene& scene = solution.scene;
    const DynamicsSpec& spec = scene.dynamics.value();
    if (!spec.stages.empty() || spec.return_stiffness > 0.0 || spec.speed_range || !solution.curve)
        throw InputError("audit: found a train or a motion not known here; allowed: one mass, one spline");
    // Time is x: T seconds are 1.
    const double seconds = scene.motion.unit_angle() / scene.motion.speed.value();
    const TrainStage output = spec.output();
    trains::Chain chain;
    const double stiffness = output.stiffness * seconds * seconds, damping = output.damping * seconds;
    chain.masses = {{output.mass, stiffness, damping}};
    chain.frequency = std::sqrt(stiffness / output.mass);
    chain.size = 1.0 / (chain.frequency * chain.frequency);
    const trains::ExactResponse found = exact_response(chain, input_pieces(*solution.curve), places_a_piece);
    TrainAudit report;
    const double ratio = damping / (2.0 * chain.frequency * output.mass);
    if (ratio < 1.0)
        report.residual = chain.size * std::hypot(found.output, (found.rate + ratio * found.output) /
                                                                    std::sqrt(1.0 - ratio * ratio));
    report.least_force =
        spec.preload - scene.motion.lift * chain.size * found.largest_pull / (seconds * seconds);
    return report;
}

}  // namespace camopt::stability
