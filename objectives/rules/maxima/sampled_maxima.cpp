// SPDX-License-Identifier: MIT
// Maxima of a rule on one piece by samples of its value and slope. Between two samples the cubic Hermite
// interpolant replaces the rule; where it fails at the middle, the stretch is bisected.
#include "objectives/rules/maxima/rule_maxima.hpp"

namespace camopt::piece_maxima {

namespace {

// The root of the slope is found to this part of its bracket.
constexpr double root_accuracy = 1e-14;
constexpr int most_root_steps = 80;
// A cubic with an error of this part of the rule's scale at the middle is rejected …
constexpr double close = 1e-3;
// … unless it lies this many times its error below 0 and below the ends, where the rule is irrelevant.
constexpr double mistrust = 8.0;
constexpr int most_halvings = 8;

// Effort for a motion that satisfies its limits: a dozen evaluations per piece are usual, some pieces take
// hundreds.
constexpr int usual_enclosures = 2000, enclosures_of_a_piece = 200;
constexpr int usual_evaluations = 4000, evaluations_of_a_piece = 100;

struct ValueAndSlope {
    double value = 0.0, slope = 0.0;
};

/// Of a motion, which has three derivatives: by a difference inside the piece, exact where the third is
/// quadratic.
double fourth_derivative(const Motion& motion, const Stretch& piece, double x) {
    constexpr double step = 1e-4;  // of the piece
    const double reach = step * (piece.end - piece.begin);
    const double begin = std::max(piece.begin, x - reach), end = std::min(piece.end, x + reach);
    return (motion.at(end, Side::left).derivative[3] - motion.at(begin, Side::right).derivative[3]) /
           (end - begin);
}

/// Along x, as the rule changes with the motion.
ValueAndSlope value_and_slope(const Subject& subject, const Stretch& piece, double x) {
    const MotionPoint point = subject.motion.at(x, x == piece.end ? Side::left : Side::right);
    const RuleValue value = subject.rule.evaluate(point, subject.q);
    double slope = value.by_place;
    for (int order = 0; order < 3; ++order) slope += value.gradient[order] * point.derivative[order + 1];
    if (value.gradient[3] != 0.0) slope += value.gradient[3] * fourth_derivative(subject.motion, piece, x);
    return {value.value, slope};
}

struct Sample {
    double x = 0.0;
    ValueAndSlope at;
};

class Sampler {
 public:
    Sampler(const Subject& subject, const Stretch& piece, Effort& effort)
        : subject_(subject), piece_(piece), effort_(effort) {
        const ValueAndSlope begin = at(piece.begin).at, end = at(piece.end).at;
        matters_ = std::min(0.0, std::max(begin.value, end.value));
    }

    [[nodiscard]] Sample at(double x) const {
        --effort_.evaluations;
        return {x, value_and_slope(subject_, piece_, x)};
    }
    [[nodiscard]] bool tired() const { return effort_.evaluations <= 0; }
    /// Samples after `left` up to and including `right`, as dense as the rule is narrow.
    void refine(const Sample& left, const Sample& right, int halvings, std::vector<Sample>& samples) const {
        const double width = right.x - left.x;
        const Sample middle = at(left.x + 0.5 * width);
        const double cubic =
            0.5 * (left.at.value + right.at.value) + 0.125 * width * (left.at.slope - right.at.slope);
        const double tilt =
            1.5 * (right.at.value - left.at.value) / width - 0.25 * (left.at.slope + right.at.slope);
        const double error =
            std::abs(middle.at.value - cubic) + 0.25 * width * std::abs(middle.at.slope - tilt);
        const double top = std::max({left.at.value, middle.at.value, right.at.value});
        const bool dull = top + mistrust * error < matters_;
        if (dull || error <= close * subject_.rule.scale() || halvings == most_halvings || tired()) {
            samples.push_back(middle);
            samples.push_back(right);
            return;
        }
        refine(left, middle, halvings + 1, samples);
        refine(middle, right, halvings + 1, samples);
    }

 private:
    const Subject& subject_;
    const Stretch& piece_;
    Effort& effort_;
    double matters_ = 0.0;
};

}  // namespace

/// Regula falsi with halved ends (Illinois), bisection where it stalls.
double root_of_slope(const std::function<double(double x)>& slope, const Stretch& between,
                     const std::array<double, 2>& slopes) {
    auto [left, right] = between;
    auto [slope_left, slope_right] = slopes;
    const double accuracy = root_accuracy * (right - left);
    for (int step = 0; step < most_root_steps && right - left > accuracy; ++step) {
        double x = right - slope_right * (right - left) / (slope_right - slope_left);
        if (!(x > left && x < right) || step % 8 == 7) x = 0.5 * (left + right);
        if (x <= left || x >= right) break;
        const double here = slope(x);
        if (here == 0.0) return x;
        if (here > 0.0) {
            left = x;
            slope_left = here;
            slope_right *= 0.5;
        } else {
            right = x;
            slope_right = here;
            slope_left *= 0.5;
        }
    }
    return 0.5 * (left + right);
}

Effort Effort::of(std::size_t pieces) {
    const auto count = static_cast<int>(pieces);
    return {usual_enclosures + enclosures_of_a_piece * count,
            usual_evaluations + evaluations_of_a_piece * count};
}

std::vector<Extremum> sampled(const Subject& subject, const Stretch& piece, int least_samples,
                              Effort& effort) {
    const Sampler sampler(subject, piece, effort);
    std::vector<Sample> samples = {sampler.at(piece.begin)};
    const int stretches = std::max(1, least_samples / 2);  // each is also tested at its middle
    for (int k = 1; k <= stretches; ++k) {
        const double x = k == stretches ? piece.end : piece.begin + (piece.end - piece.begin) * k / stretches;
        sampler.refine(Sample(samples.back()), sampler.at(x), 0, samples);
    }
    std::vector<Extremum> found = {{samples.front().at.value, piece.begin, Side::right}};
    const auto slope = [&](double x) { return sampler.at(x).at.slope; };
    for (std::size_t k = 1; k < samples.size(); ++k) {
        const Sample &left = samples[k - 1], &right = samples[k];
        // A sample exactly at the maximum: of a symmetric motion the middle is.
        if (left.at.slope == 0.0 && k > 1) found.push_back({left.at.value, left.x, Side::right});
        if (left.at.slope > 0.0 && right.at.slope < 0.0) {
            if (sampler.tired()) {
                const Sample& higher = left.at.value > right.at.value ? left : right;
                found.push_back({higher.at.value, higher.x, Side::right});
                continue;
            }
            const double x = root_of_slope(slope, {left.x, right.x}, {left.at.slope, right.at.slope});
            found.push_back({subject.value(x, Side::right), x, Side::right});
        }
    }
    found.push_back({samples.back().at.value, piece.end, Side::left});
    return found;
}

}  // namespace camopt::piece_maxima
