// SPDX-License-Identifier: MIT
#include "studies/delivered/extremes_along.hpp"

#include "core/infinity.hpp"
#include "core/numbers/scalar_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace camopt {

namespace {

// Samples between two breakpoints of the motion; where the figure may be larger than the best of them it is
// looked at closer.
constexpr int samples = 24;
constexpr int refinements = 60;
// Between two samples a figure may rise above them by this many of its second differences there. A parabola
// needs an eighth of one.
constexpr double mistrust = 4.0;
constexpr int most_halvings = 10;
// Of the figure: second differences of rounding.
constexpr double search_rounding = 1e-13;

/// Golden section: a place to the root of rounding, a value to rounding.
CamExtreme refined(const FigureAlong& figure, double left, double right) {
    // From right to left: of equal values the first is taken.
    const auto at = [&](double mirrored) { return figure(-mirrored, Side::right); };
    const GoldenSection top = golden_maximum(at, -right, -left, refinements,
                                             [](const GoldenSection& now) { return !(now.high > now.low); });
    return {top.value(), -top.place()};
}

struct Sample {
    double at = 0.0, value = 0.0;
};

class Search {
 public:
    Search(const FigureAlong& figure, double begin) : figure_(figure), best_{-infinity, begin} {}

    void add_piece(double begin, double end) {
        std::vector<Sample> piece;
        for (int k = 0; k <= samples; ++k) {
            const bool last = k == samples;
            const double x = last ? end : begin + k * (end - begin) / samples;
            piece.push_back({x, figure_(x, last ? Side::left : Side::right)});
            see({piece.back().value, x});
        }
        pieces_.push_back(std::move(piece));
    }
    [[nodiscard]] CamExtreme finish() {
        for (const std::vector<Sample>& piece : pieces_) {
            for (int k = 1; k < samples; ++k)
                if (is_top(piece, k)) golden_top(piece[k - 1].at, piece[k + 1].at);
            for (int k = 0; k < samples; ++k)
                if (promises(piece, k)) dig(piece[k], piece[k + 1], 0);
        }
        return best_;
    }

 private:
    void see(const CamExtreme& found) {
        if (found.value > best_.value) best_ = found;
    }
    void golden_top(double left, double right) {
        if (best_.value < infinity) see(refined(figure_, left, right));
    }
    /// The bend at sample k, of an end that of its neighbour.
    [[nodiscard]] static double bend(const std::vector<Sample>& piece, int k) {
        const int middle = std::clamp(k, 1, samples - 1);
        return std::abs(piece[middle - 1].value - 2.0 * piece[middle].value + piece[middle + 1].value);
    }
    [[nodiscard]] bool is_top(const std::vector<Sample>& piece, int k) const {
        const double value = piece[k].value;
        return value >= piece[k - 1].value && value >= piece[k + 1].value &&
               value + mistrust * bend(piece, k) >= best_.value && bend(piece, k) > 0.0;
    }
    [[nodiscard]] bool promises(const std::vector<Sample>& piece, int k) const {
        const double largest = std::max(piece[k].value, piece[k + 1].value);
        const double rise = mistrust * std::max(bend(piece, k), bend(piece, k + 1));
        return largest + rise > best_.value;
    }
    void dig(const Sample& left, const Sample& right, int halvings) {
        const double x = 0.5 * (left.at + right.at);
        const Sample middle{x, figure_(x, Side::right)};
        see({middle.value, x});
        const double bend = std::abs(left.value - 2.0 * middle.value + right.value);
        const double largest = std::max({left.value, middle.value, right.value});
        if (!std::isfinite(bend)) return;  // nothing to say there, or as large as can be
        if (largest + mistrust * bend <= best_.value || bend <= search_rounding * std::abs(best_.value))
            return;
        if (halvings == most_halvings) return golden_top(left.at, right.at);
        dig(left, middle, halvings + 1);
        dig(middle, right, halvings + 1);
    }

    const FigureAlong& figure_;
    CamExtreme best_;
    std::vector<std::vector<Sample>> pieces_;
};

}  // namespace

CamExtreme largest_along(const std::vector<double>& points, const FigureAlong& figure) {
    Search search(figure, points.front());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) search.add_piece(points[i], points[i + 1]);
    return search.finish();
}

CamExtreme least_along(const std::vector<double>& breakpoints, const FigureAlong& figure) {
    CamExtreme found = largest_along(breakpoints, [&](double x, Side side) { return -figure(x, side); });
    found.value = -found.value;
    return found;
}

}  // namespace camopt
