// SPDX-License-Identifier: MIT
#include "objectives/spring_rules.hpp"

#include "core/numbers/polynomial.hpp"
#include "objectives/rules/energy_rule.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// Of a piece with one formula, and of a radian of kθ. A part of the width w then adds an error of at most
// 4e-13 w |d¹⁰(y cos kθ)| w¹⁰ (five-point Gauss-Legendre), together below 1e-12 lifts, even where one quintic
// segment is a whole stroke.
constexpr int least_parts = 8, parts_of_radian = 2;

/// kθ at x = 1.
double wave_number(const MotionSpec& spec, int order) {
    return order * spec.unit_angle();
}

/// Calls visit(x, c, s): ∫ f cos(wave x) dx = Σ c f(x), ∫ f sin(wave x) dx = Σ s f(x).
template <class Visit>
void visit_harmonic(const std::vector<double>& breakpoints, double wave, Visit&& visit) {
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        const double begin = breakpoints[i], end = breakpoints[i + 1];
        const int parts =
            std::max(least_parts, static_cast<int>(std::ceil(parts_of_radian * wave * (end - begin))));
        visit_quadrature(begin, end, parts, [&](double x, double weight) {
            visit(x, weight * std::cos(wave * x), weight * std::sin(wave * x));
        });
    }
}

/// c_k² / level².
QuadraticForm harmonic_form(const MotionSpec& spec, const MotionFamily& family, int order, double level) {
    std::vector<double> breakpoints;
    for (const MotionFamily::Piece& piece : family.pieces()) breakpoints.push_back(piece.begin);
    breakpoints.push_back(family.end());
    AffineRow whole;
    for (int j = 0; j < family.size(); ++j) whole.columns.push_back(j);
    whole.weights.assign(whole.columns.size(), 0.0);
    std::array<AffineRow, 2> rows = {whole, whole};
    const double unit = spec.unit_angle() / (std::numbers::pi * level);
    visit_harmonic(breakpoints, wave_number(spec, order), [&](double x, double cosine, double sine) {
        const AffineRow y = family.functional(x, 0);
        for (const std::size_t part : {0U, 1U}) {
            const double factor = unit * (part == 0 ? cosine : sine);
            rows[part].offset += factor * y.offset;
            for (std::size_t k = 0; k < y.columns.size(); ++k)
                rows[part].weights[static_cast<std::size_t>(y.columns[k])] += factor * y.weights[k];
        }
    });
    EnergySum sum(family.size());
    for (const AffineRow& row : rows) sum.add(row, 1.0);
    return sum.form(1.0);
}

}  // namespace

std::array<int, 2> limited_harmonics(const Scene& scene) {
    if (scene.limits.spring_harmonics[0] > 0) return scene.limits.spring_harmonics;
    const int nearest = scene.nearest_harmonic();
    return {std::max(1, nearest - 1), nearest + 1};
}

double harmonic_amplitude(const MotionSpec& spec, const Motion& motion, int order) {
    double cosine = 0.0, sine = 0.0;
    visit_harmonic(motion.breakpoints(), wave_number(spec, order), [&](double x, double c, double s) {
        const double y = motion.at(x).derivative[0];
        cosine += c * y;
        sine += s * y;
    });
    return spec.unit_angle() / std::numbers::pi * std::hypot(cosine, sine);
}

void add_spring_rules(CamModel& model, const Scene& scene) {
    const std::optional<WrittenLimit>& limit = scene.limits.spring_harmonic;
    if (!limit) return;
    const auto [first, last] = limited_harmonics(scene);
    for (int order = first; order <= last; ++order) {
        EnergyRule::Energy energy{[spec = scene.motion, order](const Motion& motion) {
                                      return harmonic_amplitude(spec, motion, order);
                                  },
                                  [spec = scene.motion, order](const MotionFamily& family, double level) {
                                      return harmonic_form(spec, family, order, level);
                                  }};
        model.rules.emplace_back(std::make_shared<const EnergyRule>(limit->key, std::move(energy),
                                                                    limit->value / scene.motion.lift, -1,
                                                                    fmt::format("harmonic {}", order)));
    }
}

}  // namespace camopt
