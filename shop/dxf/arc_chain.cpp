// SPDX-License-Identifier: MIT
#include "shop/dxf/arc_chain.hpp"

#include "core/errors.hpp"

#include <fmt/format.h>

namespace camopt {

namespace {

using Eigen::Vector2d;

constexpr int fit_samples = 12;       // points a pair is fitted with: two humps an arc, six points on each
constexpr int measured_samples = 40;  // points a pair is measured with in the end
constexpr double fit_margin = 0.93;   // of the tolerance: what more points may find besides
constexpr double least_step = 1e-7;   // of the distance of knots: a pair this short is kept as it is
constexpr double standing_still = 1e-13;  // m, far below any tolerance: a pair this short is a point

/// One stretch between two knots, run through in one direction.
struct Stretch {
    const PlaneCurve& curve;
    double begin = 0.0, end = 0.0;
    double turn = 1.0;  ///< the direction of travel is the normal turned by +90° (1) or −90° (−1)

    [[nodiscard]] DirectedPoint at(double parameter) const {
        const CurvePoint point = curve(parameter);
        return {point.position, turn * Vector2d(-point.normal.y(), point.normal.x())};
    }
};

Stretch make_stretch(const PlaneCurve& curve, double begin, double end) {
    const double middle = 0.5 * (begin + end), step = 1e-3 * (end - begin);
    const Vector2d travel = curve(middle + step).position - curve(middle - step).position;
    const Vector2d normal = curve(middle).normal;
    const bool left = travel.dot(Vector2d(-normal.y(), normal.x())) >= 0.0;
    return {curve, begin, end, left ? 1.0 : -1.0};
}

struct Pair {
    double begin = 0.0, end = 0.0;
    std::array<Arc, 2> arcs;
    double deviation = 0.0;
};

double deviation_of(const PlaneCurve& curve, const Pair& pair, int samples) {
    double worst = 0.0;
    for (int i = 1; i < samples; ++i) {
        const CurvePoint point = curve(pair.begin + (pair.end - pair.begin) * i / samples);
        worst = std::max(worst, distance_along_normal(pair.arcs, point.position, point.normal));
    }
    return worst;
}

/// How far the curve moves from the point where it seems to stand still.
double deviation_from(const PlaneCurve& curve, const Pair& pair) {
    double worst = 0.0;
    for (int i = 1; i < fit_samples; ++i) {
        const double at = pair.begin + (pair.end - pair.begin) * i / fit_samples;
        worst = std::max(worst, (curve(at).position - pair.arcs[0].start.position).norm());
    }
    return worst;
}

double length_of(const Pair& pair) {
    return (pair.arcs[1].end - pair.arcs[0].start.position).norm();
}

Pair fitted_pair(const Stretch& stretch, double begin, double end) {
    Pair pair{begin, end, biarc(stretch.at(begin), stretch.at(end)), 0.0};
    pair.deviation = length_of(pair) > standing_still ? deviation_of(stretch.curve, pair, fit_samples)
                                                      : deviation_from(stretch.curve, pair);
    return pair;
}

/// Pairs from the stretch's begin to its end, each as long as the tolerance lets it be.
class StretchFitter {
 public:
    StretchFitter(const Stretch& stretch, const ArcChainOptions& options)
        : stretch_(stretch),
          target_(fit_margin * options.tolerance),
          longest_(options.longest_step),
          least_(least_step * (stretch.end - stretch.begin)) {}

    [[nodiscard]] std::vector<Pair> fit() const {
        std::vector<Pair> pairs;
        double at = stretch_.begin, step = std::min(longest_, stretch_.end - stretch_.begin);
        while (at < stretch_.end) {
            pairs.push_back(longest_pair(at, step));
            step = pairs.back().end - at;
            at = pairs.back().end;
        }
        return pairs;
    }

 private:
    [[nodiscard]] double reach(double at, double step) const {
        const double rest = stretch_.end - at;
        if (step >= rest) return stretch_.end;
        return step > 0.5 * rest ? at + 0.5 * rest : at + step;  // no crumb is left over at the end
    }
    /// The deviation grows with the third power of the length.
    [[nodiscard]] double rescaled(double step, double deviation) const {
        return step * std::clamp(0.95 * std::cbrt(target_ / std::max(deviation, 1e-300)), 0.1, 2.0);
    }
    [[nodiscard]] Pair longest_pair(double at, double step) const {
        Pair pair = fitted_pair(stretch_, at, reach(at, step));
        while (!(pair.deviation <= target_) && pair.end - at > least_)
            pair = fitted_pair(
                stretch_, at,
                reach(at, std::min(0.9 * (pair.end - at), rescaled(pair.end - at, pair.deviation))));
        while (pair.deviation < 0.5 * target_ && pair.end < stretch_.end) {
            const double longer = std::min(longest_, rescaled(pair.end - at, pair.deviation));
            const Pair next = fitted_pair(stretch_, at, reach(at, longer));
            if (!(next.deviation <= target_) || next.end < pair.end + 0.01 * (pair.end - at)) break;
            pair = next;
        }
        return pair;
    }

    const Stretch& stretch_;
    double target_, longest_, least_;
};

void check_knots(const PlaneCurve& curve, std::span<const double> knots) {
    if (knots.size() < 2) throw InputError("an arc chain needs at least two knots");
    for (std::size_t i = 0; i < knots.size(); ++i) {
        if (i > 0 && !(knots[i] > knots[i - 1]))
            throw InputError(
                fmt::format("the knots of an arc chain ascend, but {} follows {}", knots[i], knots[i - 1]));
        const CurvePoint point = curve(knots[i]);
        if (!point.position.allFinite() || !point.normal.allFinite())
            throw InputError(fmt::format("the curve is not finite at {}", knots[i]));
    }
}

double cross(const Vector2d& a, const Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void ArcChainOptions::validate() const {
    if (!(tolerance > 0.0) || !std::isfinite(tolerance))
        throw InputError(fmt::format("the tolerance of an arc chain is {}, it must be > 0", tolerance));
    if (!(longest_step > 0.0))
        throw InputError(fmt::format("the longest step of an arc chain is {}, it must be > 0", longest_step));
}

ArcChain arc_chain(const PlaneCurve& curve, std::span<const double> knots, bool closed,
                   const ArcChainOptions& options) {
    options.validate();
    check_knots(curve, knots);
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const Stretch stretch = make_stretch(curve, knots[i], knots[i + 1]);
        const std::vector<Pair> some = StretchFitter(stretch, options).fit();
        pairs.insert(pairs.end(), some.begin(), some.end());
    }
    std::erase_if(pairs, [](const Pair& pair) { return length_of(pair) <= standing_still; });
    if (pairs.empty()) throw InputError("the curve of an arc chain is a single point");

    ArcChain chain;
    chain.closed = closed;
    for (const Pair& pair : pairs) {
        chain.deviation = std::max(chain.deviation, deviation_of(curve, pair, measured_samples));
        for (const Arc& arc : pair.arcs) chain.vertices.push_back({arc.start.position, arc.bulge});
    }
    chain.arcs = static_cast<int>(chain.vertices.size());
    const Vector2d first = chain.vertices.front().position, last = pairs.back().arcs[1].end;
    if (!closed)
        chain.vertices.push_back({last, 0.0});
    else if ((last - first).norm() > options.tolerance)
        throw InputError(fmt::format("a closed curve ends {} m from where it begins", (last - first).norm()));
    return chain;
}

double largest_radius(const ArcChain& chain) {
    double radius = 0.0;
    for (const ArcVertex& vertex : chain.vertices) radius = std::max(radius, vertex.position.norm());
    return radius;
}

Arc arc_between(const DirectedPoint& start, const Vector2d& end) {
    const Vector2d chord = end - start.position;
    // The chord turns from the start's direction by half the arc's angle.
    const double half_angle = std::atan2(cross(start.direction, chord), start.direction.dot(chord));
    const double length = chord.norm();
    const double curvature = length > 0.0 ? 2.0 * std::sin(half_angle) / length : 0.0;
    return {start, end, std::tan(0.5 * half_angle), curvature};
}

std::array<Arc, 2> biarc(const DirectedPoint& start, const DirectedPoint& end) {
    const Vector2d v = end.position - start.position;
    const double along = v.dot(start.direction + end.direction), square = v.squaredNorm();
    const double turned = (end.direction - start.direction).squaredNorm();  // 2 (1 − c), without cancellation
    const double control = square / (along + std::sqrt(along * along + turned * square));
    const Vector2d first = start.position + control * start.direction;
    const Vector2d last = end.position - control * end.direction;
    const DirectedPoint joint{0.5 * (first + last), (last - first).normalized()};
    return {arc_between(start, joint.position), arc_between(joint, end.position)};
}

double distance_along_normal(const std::array<Arc, 2>& pair, const Vector2d& point, const Vector2d& normal) {
    const DirectedPoint& joint = pair[1].start;
    const Arc& arc = joint.direction.dot(point - joint.position) < 0.0 ? pair[0] : pair[1];
    // With x along the arc's first direction and y to its left: curvature/2 (x² + y²) = y on its circle.
    const Vector2d from = point - arc.start.position;
    const double a = 0.5 * arc.curvature * normal.squaredNorm();
    const double b = arc.curvature * from.dot(normal) - cross(arc.start.direction, normal);
    const double c = 0.5 * arc.curvature * from.squaredNorm() - cross(arc.start.direction, from);
    const double discriminant = b * b - 4.0 * a * c;
    if (!(discriminant >= 0.0)) return std::numeric_limits<double>::infinity();
    const double denominator = std::abs(b) + std::sqrt(discriminant);
    const double distance = std::abs(2.0 * c / denominator);
    return std::isfinite(distance) ? distance : std::numeric_limits<double>::infinity();
}

}  // namespace camopt
