// SPDX-License-Identifier: MIT
#include "studies/extremes_along.hpp"

#include <limits>

namespace camopt {

namespace {

// Samples between two breakpoints of the motion; the best of them is then refined.
constexpr int samples = 24;
constexpr int refinements = 60;
constexpr double golden = 0.38196601125010515;

/// Golden section: a place to the root of rounding, a value to rounding.
CamExtreme refined(const FigureAlong& figure, double left, double right) {
    double a = left + golden * (right - left), b = right - golden * (right - left);
    double at_a = figure(a, Side::right), at_b = figure(b, Side::right);
    for (int k = 0; k < refinements && right - left > 0.0; ++k) {
        if (at_a >= at_b) {
            right = b;
            b = a;
            at_b = at_a;
            a = left + golden * (right - left);
            at_a = figure(a, Side::right);
        } else {
            left = a;
            a = b;
            at_a = at_b;
            b = right - golden * (right - left);
            at_b = figure(b, Side::right);
        }
    }
    return at_a >= at_b ? CamExtreme{at_a, a} : CamExtreme{at_b, b};
}

}  // namespace

CamExtreme largest_along(const std::vector<double>& points, const FigureAlong& figure) {
    CamExtreme best{-std::numeric_limits<double>::infinity(), points.front()};
    const auto see = [&](double value, double at) {
        if (value > best.value) best = {value, at};
    };
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double width = (points[i + 1] - points[i]) / samples;
        std::vector<double> values;
        for (int k = 0; k <= samples; ++k) {
            const double x = k == samples ? points[i + 1] : points[i] + k * width;
            values.push_back(figure(x, k == samples ? Side::left : Side::right));
            see(values.back(), x);
        }
        const auto refine = [&](int from, int to) {
            const CamExtreme top = refined(figure, points[i] + from * width, points[i] + to * width);
            see(top.value, top.at);
        };
        for (int k = 1; k < samples; ++k)
            if (values[k] >= values[k - 1] && values[k] >= values[k + 1]) refine(k - 1, k + 1);
        // The maximum may hide beside an end.
        for (const int k : {0, samples - 1}) refine(k, k + 1);
    }
    return best;
}

CamExtreme least_along(const std::vector<double>& breakpoints, const FigureAlong& figure) {
    CamExtreme found = largest_along(breakpoints, [&](double x, Side side) { return -figure(x, side); });
    found.value = -found.value;
    return found;
}

}  // namespace camopt
