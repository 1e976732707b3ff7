// SPDX-License-Identifier: MIT
#include "tests/soak/figures/polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::soak {

long double value_at(const Polynomial& polynomial, long double u) {
    long double value = 0;
    for (auto coefficient = polynomial.rbegin(); coefficient != polynomial.rend(); ++coefficient)
        value = value * u + *coefficient;
    return value;
}

Polynomial derivative_of(const Polynomial& polynomial) {
    Polynomial derivative;
    for (std::size_t k = 1; k < polynomial.size(); ++k)
        derivative.push_back(static_cast<long double>(k) * polynomial[k]);
    return derivative;
}

Polynomial product_of(const Polynomial& left, const Polynomial& right) {
    if (left.empty() || right.empty()) return {};
    Polynomial product(left.size() + right.size() - 1, 0);
    for (std::size_t i = 0; i < left.size(); ++i)
        for (std::size_t j = 0; j < right.size(); ++j) product[i + j] += left[i] * right[j];
    return product;
}

std::vector<long double> roots_within(const Polynomial& polynomial, long double low, long double high) {
    constexpr int halvings = 80;  // of an interval: beyond the digits of a long double
    if (polynomial.size() < 2) return {};
    std::vector<long double> ends = roots_within(derivative_of(polynomial), low, high);
    ends.insert(ends.begin(), low);
    ends.push_back(high);
    std::vector<long double> roots;
    for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
        long double left = ends[k];
        long double right = ends[k + 1];
        const bool rises = value_at(polynomial, left) < 0;
        if (rises == (value_at(polynomial, right) < 0)) continue;
        for (int step = 0; step < halvings; ++step) {
            const long double middle = (left + right) / 2;
            ((value_at(polynomial, middle) < 0) == rises ? left : right) = middle;
        }
        roots.push_back((left + right) / 2);
    }
    return roots;
}

long double largest_magnitude(const Polynomial& polynomial, long double low, long double high) {
    long double largest = std::max(std::abs(value_at(polynomial, low)), std::abs(value_at(polynomial, high)));
    for (const long double root : roots_within(derivative_of(polynomial), low, high))
        largest = std::max(largest, std::abs(value_at(polynomial, root)));
    return largest;
}

}  // namespace camopt::soak
