// SPDX-License-Identifier: MIT
// Boost.odeint's Rosenbrock method of order 4 for a chain of masses, in plain numbers: its own file is C++17,
// which Boost's vectors need, and knows nothing of camopt.
#pragma once

#include <functional>
#include <vector>

namespace stiff {

struct Mass {
    double mass, stiffness, damping;  // to what stands before it
};

/// (y, y', y'') of the cam at a time.
struct Input {
    double place, velocity, acceleration;
};

struct Chain {
    std::vector<Mass> masses;
    double return_stiffness = 0.0;
    std::function<Input(double)> input;
};

/// Places, then velocities, at `end`, from rest at 0; steps by the tolerance, relative and absolute.
std::vector<double> integrated(const Chain& chain, double end, double tolerance);

}  // namespace stiff
