// SPDX-License-Identifier: MIT
#include "tests/soak/figures/motion_figures.hpp"

#include "tests/soak/figures/law.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::soak {

namespace {

/// Below it, in lifts, a displacement is rounding: the segment stands, and the lift measures it.
constexpr long double standstill = 1e-9L;

/// ∫ p² over [0, width].
long double energy(const Polynomial& polynomial, long double width) {
    const Polynomial square = product_of(polynomial, polynomial);
    long double sum = 0;
    long double power = width;
    for (std::size_t k = 0; k < square.size(); ++k, power *= width)
        sum += square[k] * power / static_cast<long double>(k + 1);
    return sum;
}

/// Peaks of a law stretch by its own measure are those of the law; in units of x they are scaled.
void add_law(const Piece& piece, MotionFigures& figures) {
    if (piece.begin > piece.law_begin) return;  // once a stretch
    const std::map<std::string, double> law = law_figures(piece.law);
    long double factor = std::abs(piece.law_to - piece.law_from);
    for (std::size_t order = 1; order <= 3; ++order) {
        factor /= piece.law_end - piece.law_begin;
        figures.by_x[static_cast<std::size_t>(piece.stretch)][order] = factor * law.at(peak_names[order]);
    }
}

void add_rounding(const Piece& piece, MotionFigures& figures) {
    constexpr long double digits = 256 * 0x1.0p-53L;  // roundings of control points of a few lifts
    const auto degree = static_cast<long double>(piece.y.size() - 1);
    long double worth = digits;
    for (long double& rounding : figures.rounding) {
        rounding = std::max(rounding, worth);
        worth *= 2 * degree / (piece.end - piece.begin);
    }
}

}  // namespace

MotionFigures figures_of(const Motion& motion) {
    MotionFigures figures;
    figures.of_stretch.resize(motion.stretches.size());
    figures.by_x.resize(motion.stretches.size());
    std::array<long double, 4> energies{};
    for (const Piece& piece : motion.pieces) {
        if (!piece.law.empty()) {
            add_law(piece, figures);
            continue;
        }
        if (!motion.exact) add_rounding(piece, figures);
        const auto index = static_cast<std::size_t>(piece.stretch);
        const Stretch& stretch = motion.stretches[index];
        const bool whole = motion.stretches.size() == 1;
        const bool joined = stretch.stroke_angle > 0;
        const long double angle = whole ? 1 : joined ? stretch.stroke_angle : stretch.end - stretch.begin;
        const long double rise = whole          ? 1
                                 : joined       ? stretch.stroke_rise
                                 : stretch.free ? 1
                                                : std::abs(stretch.to - stretch.from);
        const long double width = piece.end - piece.begin;
        std::array<Polynomial, 4> derivative;
        derivative[0] = piece.y;
        long double factor = rise > standstill ? 1 / rise : 1;
        long double torque = factor * factor;
        for (std::size_t order = 1; order <= 3; ++order) {
            derivative[order] = derivative_of(derivative[order - 1]);
            const long double peak = largest_magnitude(derivative[order], 0, width);
            factor *= angle;
            figures.by_x[index][order] = std::max(figures.by_x[index][order], peak);
            figures.of_stretch[index][order] = std::max(figures.of_stretch[index][order], factor * peak);
            if (stretch.kind == "spline") figures.peak[order] = std::max(figures.peak[order], factor * peak);
            energies[order] += energy(derivative[order], width);
        }
        torque *= angle * angle * angle;
        if (stretch.kind == "spline")
            figures.torque =
                std::max(figures.torque,
                         torque * largest_magnitude(product_of(derivative[1], derivative[2]), 0, width));
    }
    const long double length = motion.pieces.back().end - motion.pieces.front().begin;
    for (std::size_t order = 1; order <= 3; ++order) {
        figures.rms[order] = std::sqrt(energies[order] / length);
        for (const auto& peaks : figures.by_x)
            figures.whole[order] = std::max(figures.whole[order], peaks[order]);
    }
    return figures;
}

long double objective_of(const SceneNumbers& scene, const MotionFigures& figures,
                         const std::map<std::string, double>& dimensions) {
    std::map<std::string, double> reference = scene.references;
    if (!scene.reference_law.empty()) reference = law_figures(scene.reference_law);
    const std::map<std::string, long double> terms = {{"velocity", figures.peak[1]},
                                                      {"acceleration", figures.peak[2]},
                                                      {"jerk", figures.peak[3]},
                                                      {"torque", figures.torque},
                                                      {"rms_acceleration", figures.rms[2]},
                                                      {"rms_jerk", figures.rms[3]},
                                                      {"residual", figures.train.residual}};
    long double sum = 0;
    for (const auto& [name, weight] : scene.weights) {
        if (const auto term = terms.find(name); term != terms.end()) {
            sum += weight * term->second / reference.at(name);
        } else if (const auto dimension = dimensions.find(name); dimension != dimensions.end()) {
            // A variable centre distance counts by the middle of its range: it cannot be its own measure.
            const double by =
                scene.swings ? scene.lift * scene.dimensions.at("center_distance").middle() : scene.lift;
            sum += weight * std::abs(dimension->second) / by;
        }
    }
    return sum;
}

}  // namespace camopt::soak
