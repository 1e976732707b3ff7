// SPDX-License-Identifier: MIT
#include "benchmarks/stability/local_polynomial.hpp"

#include <algorithm>
#include <cmath>

namespace camopt::stability {

namespace {

long double bisected(const LocalPolynomial& polynomial, long double low, long double high) {
    const bool rising = value_at(polynomial, high) > 0;
    for (int step = 0; step < 70; ++step) {
        const long double middle = (low + high) / 2;
        ((value_at(polynomial, middle) > 0) == rising ? high : low) = middle;
    }
    return (low + high) / 2;
}

}  // namespace

long double value_at(const LocalPolynomial& polynomial, long double u) {
    long double value = 0;
    for (auto c = polynomial.rbegin(); c != polynomial.rend(); ++c) value = value * u + *c;
    return value;
}

LocalPolynomial derivative_of(const LocalPolynomial& polynomial) {
    LocalPolynomial result;
    for (std::size_t m = 1; m < polynomial.size(); ++m)
        result.push_back(static_cast<long double>(m) * polynomial[m]);
    return result;
}

std::vector<long double> sign_changes(const LocalPolynomial& polynomial) {
    if (polynomial.size() < 2) return {};
    std::vector<long double> places = sign_changes(derivative_of(polynomial));
    places.insert(places.begin(), 0);
    places.push_back(1);
    std::vector<long double> roots;
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
        const bool left = value_at(polynomial, places[k]) > 0;
        const bool right = value_at(polynomial, places[k + 1]) > 0;
        if (left != right) roots.push_back(bisected(polynomial, places[k], places[k + 1]));
    }
    return roots;
}

long double largest_magnitude(const LocalPolynomial& polynomial) {
    long double largest = std::max(std::abs(value_at(polynomial, 0)), std::abs(value_at(polynomial, 1)));
    for (const long double u : sign_changes(derivative_of(polynomial)))
        largest = std::max(largest, std::abs(value_at(polynomial, u)));
    return largest;
}

}  // namespace camopt::stability
