// SPDX-License-Identifier: MIT
#include "objectives/spring_rules.hpp"

#include "core/numbers/polynomial.hpp"

#include <fmt/format.h>

namespace camopt {
namespace {

// Of a piece with one formula, and of a radian of kθ. A part of the width w then adds an error of at most
// 4e-13 w |d¹⁰(y cos kθ)| w¹⁰ (five-point Gauss-Legendre), together below 1e-12 lifts, even where one quintic
// segment is a whole stroke.
constexpr int least_parts = 8, parts_of_radian = 2;

/// Calls visit(x, c, s): (1/π) ∫ f cos kθ dθ = Σ c f(x), and s with sin.
template <class Visit>
void visit_harmonic(const std::vector<double>& breakpoints, const MotionSpec& spec, int order,
                    Visit&& visit) {
    const double unit = spec.unit_angle(), wave = order * unit;
    for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
        const double width = breakpoints[i + 1] - breakpoints[i];
        const int parts = std::max(least_parts, static_cast<int>(std::ceil(parts_of_radian * wave * width)));
        visit_quadrature(breakpoints[i], breakpoints[i + 1], parts, [&](double x, double weight) {
            const double factor = unit / std::numbers::pi * weight;
            visit(x, factor * std::cos(wave * x), factor * std::sin(wave * x));
        });
    }
}

/// a_k and b_k.
std::array<double, 2> harmonic_of(const MotionSpec& spec, const Motion& motion, int order) {
    std::array<double, 2> parts{};
    visit_harmonic(motion.breakpoints(), spec, order, [&](double x, double cosine, double sine) {
        const double y = motion.at(x).derivative[0];
        parts[0] += cosine * y;
        parts[1] += sine * y;
    });
    return parts;
}

/// The same by the entries of the family.
std::array<AffineRow, 2> harmonic_rows(const MotionSpec& spec, const MotionFamily& family, int order) {
    std::vector<double> breakpoints;
    for (const MotionFamily::Piece& piece : family.pieces()) breakpoints.push_back(piece.begin);
    breakpoints.push_back(family.end());
    AffineRow none{0.0, {}, std::vector<double>(static_cast<std::size_t>(family.size()), 0.0)};
    for (int j = 0; j < family.size(); ++j) none.columns.push_back(j);
    std::array<AffineRow, 2> rows = {none, none};
    visit_harmonic(breakpoints, spec, order, [&](double x, double cosine, double sine) {
        const AffineRow y = family.functional(x, 0);
        for (std::size_t part = 0; part < 2; ++part) {
            const double factor = part == 0 ? cosine : sine;
            rows[part].offset += factor * y.offset;
            for (std::size_t k = 0; k < y.columns.size(); ++k)
                rows[part].weights[y.columns[k]] += factor * y.weights[k];
        }
    });
    return rows;
}

constexpr int first_directions = 8;

/// (a_k cos φ + b_k sin φ) / level − 1 <= 0, for the motions of this family. setting: φ.
WholeMotionRule harmonic_rule(const Scene& scene, const MotionFamily& family, int order) {
    const WrittenLimit& limit = *scene.limits.spring_harmonic;
    const double level = limit.value / scene.motion.lift;
    WholeMotionRule::Parts parts;
    parts.maxima = [spec = scene.motion, order, level](const Motion& motion, double) {
        const auto [cosine, sine] = harmonic_of(spec, motion, order);
        const double value = std::hypot(cosine, sine) / level - 1.0;
        return std::vector<WholeMotionRule::Place>{{{value, motion.begin()}, {std::atan2(sine, cosine)}}};
    };
    parts.row = [rows = harmonic_rows(scene.motion, family, order), level](const MotionFamily&, double, Side,
                                                                           WholeMotionRule::Setting setting) {
        const AffineRow row = combined({-1.0, {}, {}}, std::cos(setting[0]) / level, rows[0]);
        return combined(row, std::sin(setting[0]) / level, rows[1]);
    };
    parts.first.clear();
    for (int k = 0; k < first_directions; ++k)
        parts.first.push_back({{0.0, 0.0}, {units::turn * k / first_directions}});
    parts.remark = [order](WholeMotionRule::Setting) { return fmt::format("harmonic {}", order); };
    parts.which = [order](WholeMotionRule::Setting) {
        return std::map<std::string, double>{{"harmonic", order}};
    };
    return {{limit.key, 0, true, true}, std::move(parts)};
}

}  // namespace

std::array<int, 2> limited_harmonics(const Scene& scene) {
    if (scene.limits.spring_harmonics[0] > 0) return scene.limits.spring_harmonics;
    const int nearest = scene.nearest_harmonic();
    return {std::max(1, nearest - 1), nearest + 1};
}

double harmonic_amplitude(const MotionSpec& spec, const Motion& motion, int order) {
    const auto [cosine, sine] = harmonic_of(spec, motion, order);
    return std::hypot(cosine, sine);
}

void add_spring_rules(CamModel& model, const Scene& scene) {
    if (!scene.limits.spring_harmonic) return;
    const auto [first, last] = limited_harmonics(scene);
    for (int order = first; order <= last; ++order)
        model.rules.emplace_back(
            std::make_shared<const WholeMotionRule>(harmonic_rule(scene, model.cam_family(), order)));
}

}  // namespace camopt
