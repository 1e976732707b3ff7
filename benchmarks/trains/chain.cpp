// SPDX-License-Identifier: MIT
#include "benchmarks/trains/chain.hpp"

#include <cmath>

namespace trains {

namespace {

constexpr double two_pi = 6.283185307179586;
constexpr double largest_acceleration = 5.773502691896258;  // of the polynomial 3-4-5: 10 / √3

double polynomial_at(const double* coefficients, int terms, double x) {
    double value = 0.0;
    for (int k = terms; k-- > 0;) value = value * x + coefficients[k];
    return value;
}

Mass damped_mass(double mass, double stiffness, double ratio) {
    return {mass, stiffness, 2.0 * ratio * std::sqrt(stiffness * mass)};
}

}  // namespace

void Chain::rates(double x, const double* state, double* rate) const {
    const std::size_t n = masses.size();
    const double push = polynomial_at(input, 4, x) / (size * frequency);
    for (std::size_t i = 0; i < n; ++i) {
        rate[i] = frequency * state[n + i];
        rate[n + i] = -push;
    }
    for (std::size_t i = 0; i < n; ++i) {
        const double stretch = state[i] - (i == 0 ? 0.0 : state[i - 1]);
        const double speed = state[n + i] - (i == 0 ? 0.0 : state[n + i - 1]);
        const double force = masses[i].stiffness / frequency * stretch + masses[i].damping * speed;
        rate[n + i] -= force / masses[i].mass;
        if (i > 0) rate[n + i - 1] += force / masses[i - 1].mass;
    }
}

std::vector<double> Chain::jacobian() const {
    const std::size_t n = masses.size(), all = 2 * n;
    std::vector<double> out(all * all, 0.0);
    const auto add = [&](std::size_t row, std::size_t column, double value) {
        out[row * all + column] += value;
    };
    for (std::size_t i = 0; i < n; ++i) {
        add(i, n + i, frequency);
        for (std::size_t on = i == 0 ? 0 : i - 1; on <= i; ++on) {
            const double sign = (on == i ? -1.0 : 1.0) / masses[on].mass;
            const double spring = sign * masses[i].stiffness / frequency, damper = sign * masses[i].damping;
            add(n + on, i, spring);
            add(n + on, n + i, damper);
            if (i == 0) continue;
            add(n + on, i - 1, -spring);
            add(n + on, n + i - 1, -damper);
        }
    }
    return out;
}

void Chain::rate_by_x(double x, double* out) const {
    const std::size_t n = masses.size();
    const double slope[3] = {input[1], 2.0 * input[2], 3.0 * input[3]};
    for (std::size_t i = 0; i < n; ++i) {
        out[i] = 0.0;
        out[n + i] = -polynomial_at(slope, 3, x) / (size * frequency);
    }
}

Chain one_mass(double ratio, double damping) {
    Chain chain;
    chain.frequency = two_pi * std::sqrt(ratio);
    chain.masses = {damped_mass(1.0, chain.frequency * chain.frequency, damping)};
    chain.size = largest_acceleration / (chain.frequency * chain.frequency);
    return chain;
}

Chain two_masses(double ratio, double damping) {
    Chain chain;
    chain.frequency = two_pi * 2.5;
    const double stiffness = chain.frequency * chain.frequency;
    chain.masses = {damped_mass(0.5, ratio * stiffness, damping), damped_mass(1.0, stiffness, damping)};
    chain.size = largest_acceleration / stiffness;
    return chain;
}

}  // namespace trains
