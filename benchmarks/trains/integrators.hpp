// SPDX-License-Identifier: MIT
// Integrators of other libraries over one rise of a chain, from rest.
#pragma once

#include "benchmarks/trains/chain.hpp"

#include <string>
#include <vector>

namespace trains {

struct Run {
    std::vector<double> state;  // (u, v) at x = 1
    long evaluations = 0;       // of the chain's rates
    std::string status;         // "ok", or why there is nothing to compare
};

struct Integrator {
    const char* name;
    bool implicit;
    bool fixed_step;  // `control` is the number of steps, else the tolerance, relative and absolute
    std::vector<double> controls;  // those that are measured
    Run (*run)(const Chain&, double control);
};

/// No run evaluates the rates more often.
inline constexpr long most_evaluations = 400000;

/// Of Boost.odeint; empty where Boost is missing.
std::vector<Integrator> odeint_integrators();
/// Of SUNDIALS; empty where it is missing.
std::vector<Integrator> sundials_integrators();

}  // namespace trains
