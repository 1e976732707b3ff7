// SPDX-License-Identifier: MIT
#include "objectives/rule_maxima.hpp"

#include "splines/extrema.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace camopt {

namespace {

// Samples of the slope on one piece: a spline's is short and smooth, a law's may be the whole segment.
constexpr int samples_on_spline = 8;
constexpr int samples_on_shape = 32;
// The root of the slope is found to this part of its bracket.
constexpr double root_accuracy = 1e-14;
constexpr int most_root_steps = 80;
// Two candidates closer than this in value at one place are one: the rule does not jump there.
constexpr double same_value = 1e-12;

struct SlopeAt {
    double value = 0.0, slope = 0.0;
};

SlopeAt slope_at(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q, double x, Side side) {
    const MotionPoint point = motion.at(x, side);
    const RuleValue value = rule.evaluate(point, q);
    double slope = value.by_place;
    for (int order = 0; order < 3; ++order) slope += value.gradient[order] * point.derivative[order + 1];
    return {value.value, slope};
}

/// Where the slope falls through zero between `left` (> 0) and `right` (< 0): regula falsi with halved ends
/// (Illinois), bisection where it stalls.
double root_of_slope(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q, double left,
                     double right, double slope_left, double slope_right) {
    const double accuracy = root_accuracy * (right - left);
    for (int step = 0; step < most_root_steps && right - left > accuracy; ++step) {
        double x = right - slope_right * (right - left) / (slope_right - slope_left);
        if (!(x > left && x < right) || step % 8 == 7) x = 0.5 * (left + right);
        if (x <= left || x >= right) break;
        const double slope = slope_at(rule, motion, q, x, Side::right).slope;
        if (slope == 0.0) return x;
        if (slope > 0.0) {
            left = x;
            slope_left = slope;
            slope_right *= 0.5;
        } else {
            right = x;
            slope_right = slope;
            slope_left *= 0.5;
        }
    }
    return 0.5 * (left + right);
}

/// Where the rule may be largest on one piece: its ends from inside and the maxima between, ascending.
std::vector<Extremum> candidates_on_piece(const PointRule& rule, const Motion& motion,
                                          const Eigen::VectorXd& q, double begin, double end, int samples) {
    std::vector<Extremum> found;
    double left = begin;
    SlopeAt at_left = slope_at(rule, motion, q, begin, Side::right);
    found.push_back({at_left.value, begin, Side::right});
    for (int k = 1; k <= samples; ++k) {
        const bool last = k == samples;
        const double right = last ? end : begin + (end - begin) * k / samples;
        const SlopeAt at_right = slope_at(rule, motion, q, right, last ? Side::left : Side::right);
        if (at_left.slope > 0.0 && at_right.slope < 0.0) {
            const double x = root_of_slope(rule, motion, q, left, right, at_left.slope, at_right.slope);
            found.push_back({rule.evaluate(motion.at(x), q).value, x, Side::right});
        }
        if (last) found.push_back({at_right.value, end, Side::left});
        left = right;
        at_left = at_right;
    }
    return found;
}

/// A rule along the pieces of a spline as polynomials in x − begin.
class RuleOnSpline {
 public:
    RuleOnSpline(const PointRule& rule, const Eigen::VectorXd& q) : rule_(rule), q_(q) {
        if (rule.linear()) affine_ = rule.evaluate({0.0, {}}, q);
    }

    /// Empty where it is none.
    [[nodiscard]] Eigen::VectorXd along(const SplineCurve& curve, int segment) const {
        if (!affine_) {
            std::array<Eigen::VectorXd, 4> derivatives;
            for (int order = 0; order < 4; ++order)
                derivatives[order] = curve.derivative_polynomial(segment, order);
            return rule_.along(derivatives, q_);
        }
        Eigen::VectorXd polynomial = Eigen::VectorXd::Zero(curve.degree() + 1);
        polynomial[0] = affine_->value;
        for (int order = 0; order < 4; ++order) {
            if (affine_->gradient[order] == 0.0) continue;
            const Eigen::VectorXd derivative = curve.derivative_polynomial(segment, order);
            polynomial.head(derivative.size()) += affine_->gradient[order] * derivative;
        }
        return polynomial;
    }

 private:
    const PointRule& rule_;
    const Eigen::VectorXd& q_;
    std::optional<RuleValue> affine_;  ///< of a linear rule
};

std::vector<Extremum> candidates_on_spline(const SplineCurve& curve, const Eigen::VectorXd& polynomial,
                                           int segment, double shift) {
    std::vector<Extremum> found = candidates_on_segment(curve.space(), segment, polynomial);
    for (Extremum& candidate : found) candidate.at -= shift;
    return found;
}

/// Keeps the local maxima of ascending candidates; where two pieces meet without a jump they count once.
std::vector<Extremum> maxima_among(const std::vector<Extremum>& candidates) {
    std::vector<Extremum> single;
    for (const Extremum& candidate : candidates) {
        if (!single.empty() && std::abs(single.back().at - candidate.at) <= same_value) {
            const double jump = std::abs(single.back().value - candidate.value);
            if (jump <= same_value * std::max(1.0, std::abs(candidate.value))) continue;
        }
        single.push_back(candidate);
    }
    std::vector<Extremum> maxima;
    for (std::size_t k = 0; k < single.size(); ++k) {
        const bool above_left = k == 0 || single[k].value >= single[k - 1].value;
        const bool above_right = k + 1 == single.size() || single[k].value >= single[k + 1].value;
        if (above_left && above_right) maxima.push_back(single[k]);
    }
    return maxima;
}

void append(std::vector<Extremum>& all, std::vector<Extremum> more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

std::vector<Extremum> rule_maxima(const PlacedRule& rule, const MotionFamily& family,
                                  const MotionChain& motion, const Eigen::VectorXd& q) {
    std::vector<Extremum> candidates;
    const RuleOnSpline on_spline(*rule, q);
    for (const MotionFamily::Piece& piece : family.pieces()) {
        if (rule.stretch >= 0 && rule.stretch != piece.stretch) continue;
        const MotionFamily::Stretch& stretch = family.stretches()[piece.stretch];
        if (stretch.kind == StretchRequest::Kind::dwell) {
            candidates.push_back({rule->evaluate(motion.at(piece.begin), q).value, piece.begin, Side::right});
        } else if (stretch.kind == StretchRequest::Kind::spline) {
            const auto& curve = dynamic_cast<const SplineCurve&>(
                *motion.parts()[static_cast<std::size_t>(piece.stretch)].shape);
            const Eigen::VectorXd polynomial = on_spline.along(curve, piece.segment);
            append(candidates,
                   polynomial.size() > 0
                       ? candidates_on_spline(curve, polynomial, piece.segment, stretch.shift)
                       : candidates_on_piece(*rule, motion, q, piece.begin, piece.end, samples_on_spline));
        } else {
            append(candidates,
                   candidates_on_piece(*rule, motion, q, piece.begin, piece.end, samples_on_shape));
        }
    }
    return maxima_among(candidates);
}

std::vector<Extremum> rule_maxima(const PointRule& rule, const Motion& motion, const Eigen::VectorXd& q) {
    std::vector<Extremum> candidates;
    const std::vector<double> points = motion.breakpoints();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        append(candidates, candidates_on_piece(rule, motion, q, points[i], points[i + 1], samples_on_shape));
    }
    return maxima_among(candidates);
}

Extremum largest_of(const std::vector<Extremum>& maxima) {
    Extremum largest{-infinity, 0.0, Side::right};
    for (const Extremum& maximum : maxima) {
        if (maximum.value > largest.value) largest = maximum;
    }
    return largest;
}

}  // namespace camopt
