// SPDX-License-Identifier: MIT
// Enclosures of functions with their first and second derivatives: along a stretch of cam angle, and over a
// box of several variables.
//
// Formulas that are generic over the scalar accept them like numbers and return the enclosure of the whole
// formula. For a single point an enclosure is as wide as rounding.
#pragma once

#include "core/numbers/interval.hpp"

namespace camopt {

// Enclosures of a function of the cam angle over an interval: of its values, first and second derivatives.
//
// Formulas that are generic over the scalar accept it like numbers and return the enclosure of the whole
// formula; maxima are bounded by it instead of sampled. For a single angle the enclosure is as wide as
// rounding.

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

// Enclosures of a function of several variables over a box: of its values, first and second partials.
//
// Formulas that are generic over the scalar accept it like numbers and return the enclosure of the whole
// formula with its partials; they give linear underestimators of the formula
// (objectives/boxes/rule_over_box.hpp). For a single point the enclosure is as wide as rounding.

class RangeOver {
 public:
    /// Largest number of variables: y to y''' and the variable dimensions of a cam.
    static constexpr int most = 10;

    Interval value;

    RangeOver() = default;
    RangeOver(double constant) : value(constant) {}           // NOLINT(google-explicit-constructor)
    RangeOver(const Interval& constant) : value(constant) {}  // NOLINT(google-explicit-constructor)
    /// factor times the variable `index`, which lies in `values`.
    [[nodiscard]] static RangeOver variable(const Interval& values, int index, double factor = 1.0) {
        RangeOver result;
        result.value = Interval(factor) * values;
        result.grow(index + 1);
        result.first(index) = factor;
        return result;
    }

    /// Partials by variables from here on are 0.
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] Interval& first(int i) { return first_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] const Interval& first(int i) const { return first_[static_cast<std::size_t>(i)]; }
    /// By i and j in either order.
    [[nodiscard]] Interval& second(int i, int j) { return second_[place(i, j)]; }
    [[nodiscard]] const Interval& second(int i, int j) const { return second_[place(i, j)]; }
    /// Partials up to `size`, the new ones 0.
    void grow(int size) {
        for (int i = size_; i < size; ++i) {
            first(i) = 0.0;
            for (int j = 0; j <= i; ++j) second(i, j) = 0.0;
        }
        size_ = std::max(size_, size);
    }

 private:
    [[nodiscard]] static std::size_t place(int i, int j) {
        const auto high = static_cast<std::size_t>(std::max(i, j)),
                   low = static_cast<std::size_t>(std::min(i, j));
        return high * (high + 1) / 2 + low;
    }
    int size_ = 0;
    std::array<Interval, most> first_;
    std::array<Interval, most*(most + 1) / 2> second_;
};

/// f(u): from the ranges of f, f' and f'' over the values of u.
[[nodiscard]] inline RangeOver composed(const Interval& f, const Interval& first, const Interval& second,
                                        const RangeOver& u) {
    using enclosing::partial_product, enclosing::partial_sum;
    RangeOver result(f);
    result.grow(u.size());
    for (int i = 0; i < u.size(); ++i) {
        result.first(i) = partial_product(first, u.first(i));
        for (int j = 0; j <= i; ++j) {
            const Interval slopes =
                i == j ? enclosing::partial_square(u.first(i)) : partial_product(u.first(i), u.first(j));
            result.second(i, j) =
                partial_sum(partial_product(second, slopes), partial_product(first, u.second(i, j)));
        }
    }
    return result;
}
[[nodiscard]] inline RangeOver operator*(double factor, const RangeOver& a) {
    const Interval by(factor);
    return composed(by * a.value, by, 0.0, a);
}
[[nodiscard]] inline RangeOver operator*(const RangeOver& a, double factor) {
    return factor * a;
}
[[nodiscard]] inline RangeOver operator-(const RangeOver& a) {
    return composed(-a.value, -1.0, 0.0, a);
}
[[nodiscard]] inline RangeOver operator+(const RangeOver& a, const RangeOver& b) {
    using enclosing::partial_sum;
    const bool longer = a.size() >= b.size();
    RangeOver result = longer ? a : b;
    const RangeOver& other = longer ? b : a;
    result.value = a.value + b.value;
    for (int i = 0; i < other.size(); ++i) {
        result.first(i) = partial_sum(result.first(i), other.first(i));
        for (int j = 0; j <= i; ++j)
            result.second(i, j) = partial_sum(result.second(i, j), other.second(i, j));
    }
    return result;
}
[[nodiscard]] inline RangeOver operator-(const RangeOver& a, const RangeOver& b) {
    return a + -b;
}
[[nodiscard]] inline RangeOver operator*(const RangeOver& left, const RangeOver& right) {
    using enclosing::partial_product, enclosing::partial_sum;
    RangeOver a = left, b = right;
    a.grow(b.size());
    b.grow(a.size());
    RangeOver result(a.value * b.value);
    result.grow(a.size());
    for (int i = 0; i < a.size(); ++i) {
        result.first(i) =
            partial_sum(partial_product(a.value, b.first(i)), partial_product(a.first(i), b.value));
        for (int j = 0; j <= i; ++j) {
            const Interval mixed =
                partial_sum(partial_product(a.first(i), b.first(j)), partial_product(a.first(j), b.first(i)));
            const Interval bent = partial_sum(partial_product(a.value, b.second(i, j)),
                                              partial_product(a.second(i, j), b.value));
            result.second(i, j) = partial_sum(mixed, bent);
        }
    }
    return result;
}
[[nodiscard]] inline RangeOver operator/(const RangeOver& a, const RangeOver& b) {
    const Interval inverse = Interval(1.0) / b.value, squared = square(inverse);
    return a * composed(inverse, -squared, Interval(2.0) * (squared * inverse), b);
}
[[nodiscard]] inline RangeOver square(const RangeOver& a) {
    return composed(square(a.value), Interval(2.0) * a.value, Interval(2.0), a);
}
[[nodiscard]] inline RangeOver squared(const RangeOver& a) {
    return square(a);
}
[[nodiscard]] inline RangeOver sqrt(const RangeOver& a) {
    const Interval root = sqrt(a.value), first = Interval(0.5) / root;
    return composed(root, first, -(Interval(0.5) * first) / a.value, a);
}
/// (√a)³; its second derivative is bounded wherever a is away from 0.
[[nodiscard]] inline RangeOver cube_of_root(const RangeOver& a) {
    const Interval root = sqrt(a.value);
    return composed(a.value * root, Interval(1.5) * root, Interval(0.75) / root, a);
}
[[nodiscard]] inline RangeOver sin(const RangeOver& a) {
    const Interval sine = sin(a.value);
    return composed(sine, cos(a.value), -sine, a);
}
[[nodiscard]] inline RangeOver cos(const RangeOver& a) {
    const Interval cosine = cos(a.value);
    return composed(cosine, -sin(a.value), -cosine, a);
}
/// (-infinity, infinity) where a reaches ±1: the slope is infinite there.
[[nodiscard]] inline RangeOver asin(const RangeOver& a) {
    if (!(a.value.lower > -1.0 && a.value.upper < 1.0)) {
        const Interval all = Interval::everything();
        return composed(all, all, all, a);
    }
    const Interval angle = enclosing::widened(std::asin(a.value.lower), std::asin(a.value.upper));
    const Interval first = Interval(1.0) / sqrt(Interval(1.0) - square(a.value));
    return composed(angle, first, a.value * (first * (first * first)), a);
}
/// +1 or −1 if the sign is known; (-infinity, infinity) otherwise.
[[nodiscard]] inline Interval sign_of(const RangeOver& a) {
    if (a.value.lower > 0.0) return {1.0};
    if (a.value.upper < 0.0) return {-1.0};
    return Interval::everything();
}
[[nodiscard]] inline RangeOver acos(const RangeOver& a) {
    // π/2 is not a double: half a unit in its last place more.
    constexpr double half_pi = 0.5 * std::numbers::pi;
    return RangeOver(enclosing::widened(half_pi, half_pi)) - asin(a);
}

}  // namespace camopt
