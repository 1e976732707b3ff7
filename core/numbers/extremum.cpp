// SPDX-License-Identifier: MIT
#include "core/numbers/extremum.hpp"

namespace camopt {

namespace {

// Samples between two breakpoints of the motion; cells where the figure may exceed the best sample are
// refined.
constexpr int samples = 24;
constexpr int golden_sections = 40;  // to 4e-9 of two samples; finite differences refine further
constexpr int newton_steps = 3;
constexpr double step_of_bracket = 0.01;  // for differences of fourth order
// Between two samples a figure may exceed them by this many of its second differences. A parabola needs an
// eighth of one.
constexpr double mistrust = 4.0;
constexpr int most_halvings = 10;
// Of the figure: round-off in second differences.
constexpr double search_rounding = 1e-13;

/// Newton steps on the slope, both derivatives by differences, where the figure is smooth there.
double polished(const FigureAlong& figure, double place, double left, double right) {
    const double step = step_of_bracket * (right - left);
    const auto at = [&](int steps) { return figure(place + steps * step, Side::right); };
    for (int i = 0; i < newton_steps; ++i) {
        if (place - 2.0 * step < left || place + 2.0 * step > right) return place;
        const double inner = at(1) + at(-1), outer = at(2) + at(-2);
        const double slope = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12.0 * step);
        const double bend = (16.0 * inner - outer - 30.0 * at(0)) / (12.0 * step * step);
        if (!(bend < 0.0)) return place;
        place -= std::clamp(slope / bend, -step, step);
    }
    return std::clamp(place, left, right);
}

/// Golden sections: the location to the square root of round-off, the value to round-off; then Newton for the
/// location.
Extremum refined(const FigureAlong& figure, double left, double right) {
    // From right to left: of equal values the first is kept.
    const auto at = [&](double mirrored) { return figure(-mirrored, Side::right); };
    const GoldenSection top = golden_maximum(at, -right, -left, golden_sections,
                                             [](const GoldenSection& now) { return !(now.high > now.low); });
    const double place = polished(figure, -top.place(), left, right);
    const bool as_high = figure(place, Side::right) >= top.value() - search_rounding * std::abs(top.value());
    return {top.value(), as_high ? place : -top.place()};
}

class Search {
 public:
    Search(const FigureAlong& figure, double begin) : figure_(figure), best_{-infinity, begin} {}

    /// Consecutive; samples + 1 make a piece.
    void add(const Extremum& sample) {
        samples_.push_back(sample);
        see(sample);
    }
    [[nodiscard]] Extremum finish() {
        constexpr std::size_t size = samples + 1;
        for (std::size_t first = 0; first + size <= samples_.size(); first += size) {
            const Piece piece(&samples_[first], size);
            for (int k = 1; k < samples; ++k)
                if (is_top(piece, k)) golden_top(piece[k - 1].at, piece[k + 1].at);
            for (int k = 0; k < samples; ++k)
                if (promises(piece, k)) dig(piece[k], piece[k + 1], 0);
        }
        return best_;
    }

 private:
    using Piece = std::span<const Extremum>;

    void see(const Extremum& found) {
        if (found.value > best_.value) best_ = found;
    }
    void golden_top(double left, double right) {
        if (best_.value < infinity) see(refined(figure_, left, right));
    }
    /// The second difference at sample k; at an end that of its neighbour.
    [[nodiscard]] static double bend(Piece piece, int k) {
        const int middle = std::clamp(k, 1, samples - 1);
        return std::abs(piece[middle - 1].value - 2.0 * piece[middle].value + piece[middle + 1].value);
    }
    [[nodiscard]] bool is_top(Piece piece, int k) const {
        const double value = piece[k].value;
        return value >= piece[k - 1].value && value >= piece[k + 1].value &&
               value + mistrust * bend(piece, k) >= best_.value && bend(piece, k) > 0.0;
    }
    [[nodiscard]] bool promises(Piece piece, int k) const {
        const double largest = std::max(piece[k].value, piece[k + 1].value);
        const double rise = mistrust * std::max(bend(piece, k), bend(piece, k + 1));
        return largest + rise > best_.value;
    }
    void dig(const Extremum& left, const Extremum& right, int halvings) {
        const double x = 0.5 * (left.at + right.at);
        const Extremum middle{figure_(x, Side::right), x};
        see(middle);
        const double bend = std::abs(left.value - 2.0 * middle.value + right.value);
        const double largest = std::max({left.value, middle.value, right.value});
        if (!std::isfinite(bend)) return;  // undefined there, or infinite
        if (largest + mistrust * bend <= best_.value || bend <= search_rounding * std::abs(best_.value))
            return;
        if (halvings == most_halvings) return golden_top(left.at, right.at);
        dig(left, middle, halvings + 1);
        dig(middle, right, halvings + 1);
    }

    const FigureAlong& figure_;
    Extremum best_;
    std::vector<Extremum> samples_;
};

}  // namespace

std::vector<SamplePlace> sample_places(const std::vector<double>& points) {
    std::vector<SamplePlace> places;
    places.reserve((points.size() - 1) * (samples + 1));
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double begin = points[i], end = points[i + 1];
        for (int k = 0; k < samples; ++k)
            places.push_back({begin + k * (end - begin) / samples, Side::right});
        places.push_back({end, Side::left});
    }
    return places;
}

Extremum largest_along(const std::vector<double>& points, const FigureAlong& figure,
                       const FigureAtSample& at_sample) {
    const std::vector<SamplePlace> places = sample_places(points);
    Search search(figure, points.front());
    for (std::size_t k = 0; k < places.size(); ++k) search.add({at_sample(k), places[k].at, places[k].side});
    return search.finish();
}

Extremum largest_along(const std::vector<double>& points, const FigureAlong& figure) {
    const std::vector<SamplePlace> places = sample_places(points);
    return largest_along(points, figure, [&](std::size_t k) { return figure(places[k].at, places[k].side); });
}

Extremum least_along(const std::vector<double>& breakpoints, const FigureAlong& figure) {
    Extremum found = largest_along(breakpoints, [&](double x, Side side) { return -figure(x, side); });
    found.value = -found.value;
    return found;
}

}  // namespace camopt
