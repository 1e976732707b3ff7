// SPDX-License-Identifier: MIT
// Branch and bound along one piece by interval subdivision. A stretch has no relevant maximum if the
// enclosure of the rule lies below the floor, if that of its slope excludes 0, or if that of its second
// derivative is positive; it has at most one if that is negative. Otherwise it is bisected. After many
// bisections value and slope are also enclosed by mean-value forms.
#include "objectives/rules/maxima/rule_maxima.hpp"

namespace camopt::piece_maxima {

namespace {

// Halvings of one piece. Smooth rules need about ten; beyond this the rule is singular, and samples are used.
constexpr int most_stretches = 2000;
// After so many a rule is probably near a limit everywhere, and mean-value forms are used too.
constexpr int usual_stretches = 16;
// A stretch narrower than this part of its piece is a point.
constexpr double narrowest = 1e-12;
// Round-off of a polynomial's values, relative to its terms: each is shifted and added degree times.
constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
constexpr int most_degree = 7;

/// Enclosures of y and its first four derivatives over begin + [left, right].
std::array<Interval, 5> derivative_ranges(const Eigen::VectorXd& y, double left, double right) {
    const double middle = 0.5 * (left + right), half = 0.5 * (right - left);
    const auto degree = static_cast<int>(y.size()) - 1;
    // Taylor coefficients about the middle, and the magnitudes of their summands.
    std::array<double, most_degree + 1> taylor{}, size{};
    for (int k = 0; k <= degree; ++k) {
        taylor[k] = y[k];
        size[k] = std::abs(y[k]);
    }
    for (int i = 0; i < degree; ++i) {
        for (int k = degree - 1; k >= i; --k) {
            const auto at = static_cast<std::size_t>(k);
            taylor[at] += middle * taylor[at + 1];
            size[at] += std::abs(middle) * size[at + 1];
        }
    }
    std::array<Interval, 5> ranges;
    for (int order = 0; order < 5; ++order) {
        double low = 0.0, high = 0.0, sizes = 0.0, power = 1.0;
        for (int k = order; k <= degree; ++k) {
            double factor = 1.0;
            for (int j = 0; j < order; ++j) factor *= k - j;
            const double term = factor * taylor[k] * power;
            sizes += factor * size[k] * power;
            power *= half;
            const bool even = (k - order) % 2 == 0;
            low += k == order ? term : even ? std::min(0.0, term) : -std::abs(term);
            high += k == order ? term : even ? std::max(0.0, term) : std::abs(term);
        }
        ranges[order] = {low - rounding * sizes, high + rounding * sizes};
    }
    return ranges;
}

class Search {
 public:
    Search(const Subject& subject, const SmoothPiece& piece, double floor, double accuracy, Effort& effort)
        : subject_(subject), piece_(piece), floor_(floor), accuracy_(accuracy), effort_(effort) {}

    /// False if it gave up.
    [[nodiscard]] bool run() {
        const double length = piece_.piece.end - piece_.piece.begin;
        std::vector<Stretch> open = {{0.0, length}};
        for (int count = 0; !open.empty(); ++count) {
            if (count == most_stretches || effort_.enclosures <= 0) return false;
            --effort_.enclosures;
            const Stretch stretch = open.back();
            open.pop_back();
            const RangeAlong range = over(stretch.begin, stretch.end);
            if (std::isnan(range.value.lower) || std::isnan(range.value.upper)) return false;
            if (range.value.upper <= floor_) continue;
            if (range.slope.lower > 0.0 || range.slope.upper < 0.0 || range.bend.lower > 0.0) continue;
            if (range.bend.upper < 0.0) {
                add_top(stretch);
                continue;
            }
            const double middle = 0.5 * (stretch.begin + stretch.end);
            bool flat = range.value.width() <= accuracy_;
            if (!flat && count > usual_stretches) {
                const Closer closer = from_middle(stretch, range);
                if (closer.most <= floor_ || closer.rises || closer.falls) continue;
                flat = closer.above_middle <= accuracy_;
            }
            if (flat || stretch.end - stretch.begin <= narrowest * length) {
                add(middle);
                continue;
            }
            open.push_back({middle, stretch.end});
            open.push_back({stretch.begin, middle});
        }
        return true;
    }
    [[nodiscard]] std::vector<Extremum> take() { return std::move(found_); }

 private:
    [[nodiscard]] RangeAlong over(double left, double right) const {
        const Interval x = Interval(piece_.piece.begin) + Interval(left, right);
        const std::array<Interval, 5> y =
            piece_.part ? *ranges_of(*piece_.part, x) : derivative_ranges(piece_.y, left, right);
        return *subject_.rule.range_along(x, y, subject_.q);
    }
    /// Mean-value form: the value at the middle with enclosures of slope and second derivative. A nearly
    /// active rule has small slope and curvature, so that a stretch a thousand times as long has the same
    /// accuracy.
    struct Closer {
        double most = 0.0, above_middle = 0.0;
        bool rises = false, falls = false;
    };
    [[nodiscard]] Closer from_middle(const Stretch& stretch, const RangeAlong& range) const {
        const double middle = 0.5 * (stretch.begin + stretch.end);
        const double half = 0.5 * (stretch.end - stretch.begin);
        const RangeAlong here = over(middle, middle);
        const double steepest = std::max(std::abs(here.slope.lower), std::abs(here.slope.upper));
        const double bend = std::max(std::abs(range.bend.lower), std::abs(range.bend.upper));
        const double rise = half * (steepest + 0.5 * half * std::max(0.0, range.bend.upper));
        return {here.value.upper + rise, here.value.width() + rise, here.slope.lower > half * bend,
                here.slope.upper < -half * bend};
    }
    [[nodiscard]] double slope(double t) const {
        const Interval range = over(t, t).slope;
        return 0.5 * (range.lower + range.upper);
    }
    void add(double t) {
        const double x = piece_.piece.begin + t;
        found_.push_back({subject_.value(x, Side::right), x, Side::right});
    }
    /// Of a stretch on which the rule is concave.
    void add_top(const Stretch& stretch) {
        const std::array<double, 2> slopes = {slope(stretch.begin), slope(stretch.end)};
        if (slopes[0] > 0.0 && slopes[1] < 0.0)
            add(root_of_slope([this](double t) { return slope(t); }, stretch, slopes));
        // A maximum on the border of two stretches has a slope of 0, to round-off, in both.
        else if (slopes[0] >= 0.0)
            add(stretch.end);
        else
            add(stretch.begin);
    }

    const Subject& subject_;
    const SmoothPiece& piece_;
    double floor_ = 0.0, accuracy_ = 0.0;
    Effort& effort_;
    std::vector<Extremum> found_;
};

}  // namespace

std::optional<std::array<Interval, 5>> ranges_on(const SmoothPiece& piece, const Interval& x) {
    if (piece.part) return ranges_of(*piece.part, x);
    if (piece.y.size() > most_degree + 1) return {};
    return derivative_ranges(piece.y, x.lower - piece.piece.begin, x.upper - piece.piece.begin);
}

std::optional<std::vector<Extremum>> enclosed(const Subject& subject, const SmoothPiece& piece, double floor,
                                              double accuracy, Effort& effort) {
    if (effort.enclosures <= 0 || piece.y.size() > most_degree + 1) return {};
    const Interval begin = piece.piece.begin;
    std::optional<std::array<Interval, 5>> y;
    y = piece.part ? ranges_of(*piece.part, begin) : derivative_ranges(piece.y, 0.0, 0.0);
    if (!y || !subject.rule.range_along(begin, *y, subject.q)) return {};
    Search search(subject, piece, floor, accuracy, effort);
    if (!search.run()) return {};
    return search.take();
}

}  // namespace camopt::piece_maxima
