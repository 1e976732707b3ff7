// SPDX-License-Identifier: MIT
#include "tests/soak/figures/law.hpp"

#include "tests/soak/figures/golden_section.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

namespace camopt::soak {

namespace {

constexpr double pi = std::numbers::pi;
using State = std::array<double, 4>;

State cycloidal(double t) {
    const double w = 2 * pi;
    return {t - std::sin(w * t) / w, 1 - std::cos(w * t), w * std::sin(w * t), w * w * std::cos(w * t)};
}

/// Sum of a_k t^k with its derivatives.
State polynomial(const std::array<double, 8>& a, double t) {
    State state{};
    for (int k = 0; k < 8; ++k) {
        double factor = a[static_cast<std::size_t>(k)];
        for (int order = 0; order < 4 && order <= k; ++order) {
            state[static_cast<std::size_t>(order)] += factor * std::pow(t, k - order);
            factor *= k - order;
        }
    }
    return state;
}

/// Neklutin's ramps of 1/8: acceleration A sin(4πt) up to 1/8, a half wave three times as long between.
State modified_sine(double t, bool from_left) {
    const double a = 4 * pi * pi / (4 + pi);  // 5.52796
    const double w = 4 * pi;
    const double v = w / 3;
    const bool first = from_left ? t <= 0.125 : t < 0.125;
    const bool middle = from_left ? t <= 0.875 : t < 0.875;
    if (first)
        return {a / w * t - a / (w * w) * std::sin(w * t), a / w * (1 - std::cos(w * t)), a * std::sin(w * t),
                a * w * std::cos(w * t)};
    if (middle) {
        const double u = v * t + pi / 3;  // π/2 at 1/8, 3π/2 at 7/8
        const double speed = a / w;       // at 1/8
        const double start = a / w / 8 - a / (w * w);
        return {start + speed * (t - 0.125) - a / (v * v) * (std::sin(u) - 1), speed - a / v * std::cos(u),
                a * std::sin(u), a * v * std::cos(u)};
    }
    const State mirrored = modified_sine(1 - t, !from_left);
    return {1 - mirrored[0], mirrored[1], -mirrored[2], mirrored[3]};
}

/// The largest |f| on [0, 1]: a fine grid that holds the eighths, then golden section about its best places.
double largest(const std::function<double(double, bool)>& f) {
    constexpr int cells = 4096;
    double best = 0.0;
    int at = 0;
    for (int k = 0; k <= cells; ++k) {
        for (const bool left : {true, false}) {
            const double value = std::abs(f(static_cast<double>(k) / cells, left));
            if (value > best) at = k;
            best = std::max(best, value);
        }
    }
    const double low = std::max(0, at - 1) / static_cast<double>(cells);
    const double high = std::min(cells, at + 1) / static_cast<double>(cells);
    return std::max(best, highest_between(low, high, [&](double t) { return std::abs(f(t, false)); }));
}

double root_mean_square(const std::string& law, std::size_t order) {
    // Simpson on cells that end where the law's pieces do.
    constexpr int cells = 4096;
    double sum = 0.0;
    const auto square = [&](double t, bool left) { return std::pow(law_at(law, t, left)[order], 2); };
    for (int k = 0; k < cells; ++k) {
        const double begin = static_cast<double>(k) / cells;
        const double end = static_cast<double>(k + 1) / cells;
        sum += square(begin, false) + 4 * square((begin + end) / 2, false) + square(end, true);
    }
    return std::sqrt(sum / (6.0 * cells));
}

std::map<std::string, double> found_figures(const std::string& law) {
    const auto order = [&](std::size_t r) {
        return largest([&law, r](double t, bool left) { return law_at(law, t, left)[r]; });
    };
    return {{"velocity", order(1)},
            {"acceleration", order(2)},
            {"jerk", order(3)},
            {"torque", largest([&law](double t, bool left) {
                 const State state = law_at(law, t, left);
                 return state[1] * state[2];
             })},
            {"rms_acceleration", root_mean_square(law, 2)},
            {"rms_jerk", root_mean_square(law, 3)}};
}

}  // namespace

const std::vector<std::string>& known_laws() {
    static const std::vector<std::string> laws = {"modified_sine", "cycloidal", "polynomial_345",
                                                  "polynomial_4567"};
    return laws;
}

std::array<double, 4> law_at(const std::string& law, double t, bool from_left) {
    if (law == "cycloidal") return cycloidal(t);
    if (law == "modified_sine") return modified_sine(t, from_left);
    if (law == "polynomial_345") return polynomial({0, 0, 0, 10, -15, 6, 0, 0}, t);
    if (law == "polynomial_4567") return polynomial({0, 0, 0, 0, 35, -84, 70, -20}, t);
    throw std::runtime_error("the soak trials do not know the law " + law);
}

const std::map<std::string, double>& law_figures(const std::string& law) {
    static std::map<std::string, std::map<std::string, double>> known;  // they take milliseconds
    auto& figures = known[law];
    if (figures.empty()) figures = found_figures(law);
    return figures;
}

}  // namespace camopt::soak
