// SPDX-License-Identifier: MIT
// The exact maxima of clearances: one polynomial between merged breakpoints; where an axis follows a law,
// subdivision with f(u) ≤ max(f(a), f(b)) + (b − a)²/8 · max(−f'') on [a, b].
#include "core/numbers/polynomial.hpp"
#include "objectives/machine/machine_problem.hpp"

namespace camopt {

namespace {

// Of a maximum where an axis follows a law, relative to the clearance's scale: a tenth of the tightest usual
// tolerance.
constexpr double enclosed_accuracy = 1e-10;
constexpr int most_parts = 20000;
constexpr double farthest_below = 1e6;  // no clearance is that far from its bound

/// p(origin + u · width) by u.
Eigen::VectorXd expanded(Eigen::VectorXd p, double origin, double width) {
    const Eigen::Index size = p.size();
    for (Eigen::Index k = 0; k + 1 < size; ++k)  // Taylor shift by repeated synthetic division
        for (Eigen::Index m = size - 2; m >= k; --m) p[m] += origin * p[m + 1];
    double power = 1.0;
    for (Eigen::Index m = 0; m < size; ++m, power *= width) p[m] *= power;
    return p;
}

/// A law on the way: factor · y(x0 + u · width).
struct Law {
    const ChainPart* part;
    double factor, x0, width;
};

/// f(u) = polynomial + Σ laws on u in [0, 1].
struct Along {
    Eigen::VectorXd polynomial = Eigen::VectorXd::Zero(1);
    std::vector<Law> laws;

    void add(const Eigen::VectorXd& more) {
        if (more.size() > polynomial.size())
            polynomial.conservativeResizeLike(Eigen::VectorXd::Zero(more.size()));
        polynomial.head(more.size()) += more;
    }
    /// Enclosures of f and f'' on [a, b]; wide where a law has none.
    [[nodiscard]] std::pair<Interval, Interval> ranges(double a, double b) const {
        const Interval u(a, b);
        Interval value(0.0), bend(0.0);
        const Eigen::VectorXd second = differentiated(differentiated(polynomial));
        for (Eigen::Index m = polynomial.size() - 1; m >= 0; --m) value = value * u + Interval(polynomial[m]);
        for (Eigen::Index m = second.size() - 1; m >= 0; --m) bend = bend * u + Interval(second[m]);
        for (const Law& law : laws) {
            const auto own = ranges_of(*law.part, {law.x0 + a * law.width, law.x0 + b * law.width});
            if (!own) return {Interval::everything(), Interval::everything()};
            value = value + Interval(law.factor) * (*own)[0];
            bend = bend + Interval(law.factor * law.width * law.width) * (*own)[2];
        }
        return {value, bend};
    }
    [[nodiscard]] double at(double u) const {
        double value = evaluate_polynomial(polynomial, u);
        for (const Law& law : laws) {
            const Motion& shape = *law.part->shape;
            const double own = (law.x0 + u * law.width - law.part->x0) / law.part->x_scale;
            value += law.factor *
                     (law.part->y0 + law.part->y_scale *
                                         shape.at(std::clamp(own, shape.begin(), shape.end())).derivative[0]);
        }
        return value;
    }
};

std::optional<Extremum> maximum_with_laws(const Along& along, double floor) {
    struct Part {
        double a, b, at_a, at_b;
    };
    std::vector<Part> open = {{0.0, 1.0, along.at(0.0), along.at(1.0)}};
    Extremum best = open.front().at_a >= open.front().at_b ? Extremum{open.front().at_a, 0.0}
                                                           : Extremum{open.front().at_b, 1.0};
    for (int k = 0; k < most_parts && !open.empty(); ++k) {
        const Part part = open.back();
        open.pop_back();
        const auto [value, bend] = along.ranges(part.a, part.b);
        const double width = part.b - part.a;
        const double most = std::min(
            value.upper, std::max(part.at_a, part.at_b) + 0.125 * width * width * std::max(0.0, -bend.lower));
        if (most <= std::max(best.value, floor) + enclosed_accuracy) continue;
        const double middle = 0.5 * (part.a + part.b), at = along.at(middle);
        if (at > best.value) best = {at, middle};
        open.push_back({part.a, middle, part.at_a, at});
        open.push_back({middle, part.b, at, part.at_b});
    }
    return best.value > floor ? std::optional(best) : std::nullopt;
}

}  // namespace

void MachineProblem::merge_breaks(Clear& clear) const {
    const double from = clear.rule.from, until = from + clear.length;
    clear.breaks = {from, until};
    if (falls_back(clear) && from < units::turn && units::turn < until) clear.breaks.push_back(units::turn);
    for (const int index : clear.rule.axes) {
        const Block& block = blocks_[index];
        for (const MotionFamily::Piece& piece : block.problem->model().design.pieces()) {
            double angle = block.spec.phase + piece.begin * block.spec.unit_angle;
            angle -= units::turn * std::floor((angle - from) / units::turn);
            while (angle < until) {
                if (angle > from) clear.breaks.push_back(angle);
                angle += units::turn;
            }
        }
    }
    std::ranges::sort(clear.breaks);
    std::vector<double> single = {from};
    for (const double angle : clear.breaks)
        if (angle > single.back() + same_angle && angle < until - same_angle) single.push_back(angle);
    single.push_back(until);
    clear.breaks = std::move(single);
}

std::vector<Extremum> MachineProblem::maxima_of(const Clear& clear, const std::vector<MotionChain>& motions,
                                                double floor) const {
    const double least = std::max(floor, -farthest_below);
    std::vector<Extremum> all;
    for (std::size_t i = 0; i + 1 < clear.breaks.size(); ++i) {
        const double begin = clear.breaks[i], width = clear.breaks[i + 1] - begin;
        Along along;
        along.polynomial[0] = -clear.rule.bound / clear.rule.scale;
        for (std::size_t k = 0; k < clear.rule.axes.size(); ++k) {
            const int index = clear.rule.axes[k];
            const Block& block = blocks_[index];
            const MotionFamily& design = block.problem->model().design;
            const double factor = clear.rule.weight(k, block.spec.lift);
            const double wide = width / block.spec.unit_angle;
            const auto [middle, advanced] = axis_place(index, begin + 0.5 * width);
            const double x0 = middle - 0.5 * wide;
            along.polynomial[0] += factor * advanced;
            const auto& piece =
                design.pieces()[static_cast<std::size_t>(design.piece_of(middle, Side::right))];
            const auto stretch = static_cast<std::size_t>(piece.stretch);
            const ChainPart& part = motions[index].parts()[stretch];
            if (!part.shape) {
                along.add(Eigen::VectorXd::Constant(1, factor * part.y0));
            } else if (piece.segment >= 0) {
                const auto& curve = dynamic_cast<const SplineCurve&>(*part.shape);
                const double origin = curve.space().breakpoints()[piece.segment];
                const double local = x0 + design.stretches()[stretch].shift - origin;
                along.add(factor * expanded(curve.derivative_polynomial(piece.segment, 0), local, wide));
            } else {
                along.laws.push_back({&part, factor, x0, wide});
            }
        }
        const std::optional<Extremum> maximum =
            along.laws.empty() ? maximum_above(along.polynomial, least) : maximum_with_laws(along, least);
        if (!maximum) continue;
        const bool fallen = std::abs(begin - units::turn) <= same_angle && falls_back(clear);
        const double at = begin + std::max(maximum->at * width, fallen ? after_fall : 0.0);
        // At a joint of two stretches it is one maximum; where the next one ascends further it is none.
        if (!fallen && !all.empty() && maximum->at == 0.0 && at - all.back().at <= same_angle) {
            all.back().value = std::max(all.back().value, maximum->value);
            continue;
        }
        if (!fallen && !all.empty() && maximum->at > 0.0 && begin - all.back().at <= same_angle &&
            maximum->value > all.back().value)
            all.pop_back();
        else if (!fallen && maximum->at == 0.0 && i > 0)
            continue;  // the stretch before it descends to here from a larger one
        all.push_back({maximum->value, at});
    }
    return all;
}

}  // namespace camopt
