// SPDX-License-Identifier: MIT
// Interval arithmetic: [lower, upper] encloses every value that a formula takes while its variables run over
// their intervals.
//
// Every result is widened by more than its rounding error (least_widening of its size), so enclosures hold in
// double arithmetic without changing the rounding mode. Division by an interval that contains 0 and the root
// of one that contains a negative number give (-infinity, infinity).
#pragma once

#include "core/base/standard.hpp"

namespace camopt {

struct Interval {
    double lower = 0.0, upper = 0.0;

    Interval() = default;
    Interval(double value) : lower(value), upper(value) {}  // NOLINT(google-explicit-constructor)
    Interval(double low, double high) : lower(low), upper(high) {}

    [[nodiscard]] double width() const { return upper - lower; }
    [[nodiscard]] bool holds(double value) const { return lower <= value && value <= upper; }
    [[nodiscard]] static Interval everything() {
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    }
};

namespace enclosing {

// Four roundings of a double: library sines and roots are accurate to one or two.
inline constexpr double least_widening = 4.0 * std::numeric_limits<double>::epsilon();

/// `low` and `high` were computed with one rounding each.
[[nodiscard]] inline Interval widened(double low, double high) {
    if (std::isnan(low) || std::isnan(high)) return Interval::everything();
    constexpr double tiny = std::numeric_limits<double>::min();
    return {low - least_widening * std::abs(low) - tiny, high + least_widening * std::abs(high) + tiny};
}

}  // namespace enclosing

[[nodiscard]] inline Interval operator-(const Interval& a) {
    return {-a.upper, -a.lower};
}
[[nodiscard]] inline Interval operator+(const Interval& a, const Interval& b) {
    return enclosing::widened(a.lower + b.lower, a.upper + b.upper);
}
[[nodiscard]] inline Interval operator-(const Interval& a, const Interval& b) {
    return enclosing::widened(a.lower - b.upper, a.upper - b.lower);
}
[[nodiscard]] inline Interval operator*(const Interval& a, const Interval& b) {
    const double p = a.lower * b.lower, q = a.lower * b.upper, r = a.upper * b.lower, s = a.upper * b.upper;
    if (std::isnan(p) || std::isnan(q) || std::isnan(r) || std::isnan(s)) return Interval::everything();
    return enclosing::widened(std::min(std::min(p, q), std::min(r, s)),
                              std::max(std::max(p, q), std::max(r, s)));
}
[[nodiscard]] inline Interval operator/(const Interval& a, const Interval& b) {
    if (b.holds(0.0)) return Interval::everything();
    return a * enclosing::widened(1.0 / b.upper, 1.0 / b.lower);
}
/// Never below 0, which the product of a with itself would allow (dependency problem).
[[nodiscard]] inline Interval square(const Interval& a) {
    const double p = a.lower * a.lower, q = a.upper * a.upper;
    const Interval result = enclosing::widened(a.holds(0.0) ? 0.0 : std::min(p, q), std::max(p, q));
    return {std::max(0.0, result.lower), result.upper};
}
[[nodiscard]] inline Interval sqrt(const Interval& a) {
    if (!(a.lower >= 0.0)) return Interval::everything();
    const Interval result = enclosing::widened(std::sqrt(a.lower), std::sqrt(a.upper));
    return {std::max(0.0, result.lower), result.upper};
}
[[nodiscard]] inline Interval cos(const Interval& a) {
    constexpr double pi = std::numbers::pi;
    // Angles of a mechanism; beyond a few revolutions the multiples of pi are not accurate enough.
    constexpr double farthest = 100.0;
    if (!(a.width() < 2.0 * pi) || std::abs(a.lower) > farthest || std::abs(a.upper) > farthest)
        return {-1.0, 1.0};
    const double at_lower = std::cos(a.lower), at_upper = std::cos(a.upper);
    double least = std::min(at_lower, at_upper), most = std::max(at_lower, at_upper);
    // Include an extreme at k pi slightly too early rather than too late.
    constexpr double near = 1e-12;
    for (double k = std::ceil((a.lower - near) / pi); k * pi <= a.upper + near; ++k)
        (std::fmod(std::abs(k), 2.0) == 0.0 ? most : least) = std::fmod(std::abs(k), 2.0) == 0.0 ? 1.0 : -1.0;
    const Interval result = enclosing::widened(least, most);
    return {std::max(-1.0, result.lower), std::min(1.0, result.upper)};
}
[[nodiscard]] inline Interval sin(const Interval& a) {
    return cos(a - Interval(0.5 * std::numbers::pi));
}

namespace enclosing {

[[nodiscard]] inline bool is_zero(const Interval& a) {
    return a.lower == 0.0 && a.upper == 0.0;
}
/// Most partials of most formulas are 0 and remain 0.
[[nodiscard]] inline Interval partial_product(const Interval& a, const Interval& b) {
    return is_zero(a) || is_zero(b) ? Interval(0.0) : a * b;
}
[[nodiscard]] inline Interval partial_square(const Interval& a) {
    return is_zero(a) ? Interval(0.0) : square(a);
}
[[nodiscard]] inline Interval partial_sum(const Interval& a, const Interval& b) {
    return is_zero(a) ? b : is_zero(b) ? a : a + b;
}

}  // namespace enclosing

/// The intersection, known to be nonempty.
[[nodiscard]] inline Interval common(const Interval& a, const Interval& b) {
    return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

// The square in formulas that are generic over the scalar: an enclosure of it is never below 0, unlike that
// of a product with itself (enclosures.hpp).

template <class T>
[[nodiscard]] T squared(const T& a) {
    return T(a * a);
}

}  // namespace camopt
