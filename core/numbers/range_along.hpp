// SPDX-License-Identifier: MIT
// Enclosures of a function of the cam angle over an interval: of its values, first and second derivatives.
//
// Formulas that are generic over the scalar accept it like numbers and return the enclosure of the whole
// formula; maxima are bounded by it instead of sampled. For a single angle the enclosure is as wide as
// rounding.
#pragma once

#include "core/numbers/interval.hpp"

namespace camopt {

struct RangeAlong {
    Interval value, slope, bend;  ///< f, df/dx, d²f/dx²

    RangeAlong() = default;
    RangeAlong(double constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
    RangeAlong(const Interval& f, const Interval& first, const Interval& second)
        : value(f), slope(first), bend(second) {}
};

[[nodiscard]] inline RangeAlong operator-(const RangeAlong& a) {
    return {-a.value, -a.slope, -a.bend};
}
[[nodiscard]] inline RangeAlong operator+(const RangeAlong& a, const RangeAlong& b) {
    using enclosing::partial_sum;
    return {a.value + b.value, partial_sum(a.slope, b.slope), partial_sum(a.bend, b.bend)};
}
[[nodiscard]] inline RangeAlong operator-(const RangeAlong& a, const RangeAlong& b) {
    using enclosing::partial_sum;
    return {a.value - b.value, partial_sum(a.slope, -b.slope), partial_sum(a.bend, -b.bend)};
}
[[nodiscard]] inline RangeAlong operator*(const RangeAlong& a, const RangeAlong& b) {
    using enclosing::partial_product, enclosing::partial_sum;
    const Interval mixed = partial_product(Interval(2.0), partial_product(a.slope, b.slope));
    const Interval bent = partial_sum(partial_product(a.value, b.bend), partial_product(a.bend, b.value));
    return {a.value * b.value,
            partial_sum(partial_product(a.value, b.slope), partial_product(a.slope, b.value)),
            partial_sum(mixed, bent)};
}
[[nodiscard]] inline RangeAlong operator*(double factor, const RangeAlong& a) {
    using enclosing::partial_product;
    const Interval by(factor);
    return {by * a.value, partial_product(by, a.slope), partial_product(by, a.bend)};
}
[[nodiscard]] inline RangeAlong operator*(const RangeAlong& a, double factor) {
    return factor * a;
}
/// f(u): from the ranges of f, f' and f'' over the values of u.
[[nodiscard]] inline RangeAlong composed(const Interval& f, const Interval& first, const Interval& second,
                                         const RangeAlong& u) {
    using enclosing::partial_product, enclosing::partial_square, enclosing::partial_sum;
    return {f, partial_product(first, u.slope),
            partial_sum(partial_product(second, partial_square(u.slope)), partial_product(first, u.bend))};
}
[[nodiscard]] inline RangeAlong operator/(const RangeAlong& a, const RangeAlong& b) {
    const Interval inverse = Interval(1.0) / b.value, squared = square(inverse);
    return a * composed(inverse, -squared, Interval(2.0) * (squared * inverse), b);
}
[[nodiscard]] inline RangeAlong square(const RangeAlong& a) {
    return composed(square(a.value), Interval(2.0) * a.value, Interval(2.0), a);
}
[[nodiscard]] inline RangeAlong squared(const RangeAlong& a) {
    return square(a);
}
[[nodiscard]] inline RangeAlong sqrt(const RangeAlong& a) {
    const Interval root = sqrt(a.value), first = Interval(0.5) / root;
    return composed(root, first, -(Interval(0.5) * first) / a.value, a);
}
[[nodiscard]] inline RangeAlong sin(const RangeAlong& a) {
    const Interval sine = sin(a.value);
    return composed(sine, cos(a.value), -sine, a);
}
[[nodiscard]] inline RangeAlong cos(const RangeAlong& a) {
    const Interval cosine = cos(a.value);
    return composed(cosine, -sin(a.value), -cosine, a);
}

/// A follower's s, s', s'' over an interval of the cam angle.
struct StateAlong {
    RangeAlong s, velocity, acceleration;
};

}  // namespace camopt
