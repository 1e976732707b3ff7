// SPDX-License-Identifier: MIT
// A chain of masses behind a cam, in plain numbers, as an initial value problem for any integrator. Its file
// is C++17 as well, which some of them need, and knows nothing of camopt.
//
// The cam rises by the polynomial 3-4-5 over x in [0, 1]. Mass i stands e_i beside the cam's motion y:
//
//   m_i e_i'' = −m_i y'' + k_i (e_{i−1} − e_i) + c_i (e_{i−1}' − e_i') − (the same of i + 1),   e_0 = 0.
//
// In variables that every integrator likes: u_i = e_i / size, v_i = e_i' / (size · frequency).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace trains {

struct Mass {
    double mass = 1.0, stiffness = 1.0, damping = 0.0;  // to what stands before it
};

/// y'' = Σ_k input[k] x^k.
inline constexpr double input[4] = {0.0, 60.0, -180.0, 120.0};

struct Chain {
    std::vector<Mass> masses;
    double frequency = 1.0;  // of the output on its own spring, rad by x
    double size = 1.0;       // what the output lags at the largest y'', were it alone

    std::size_t states() const { return 2 * masses.size(); }
    /// (u', v') at x.
    void rates(double x, const double* state, double* rate) const;
    /// ∂rate_i/∂state_j, by rows.
    std::vector<double> jacobian() const;
    /// ∂rate/∂x.
    void rate_by_x(double x, double* out) const;
};

/// One mass with λ = √ratio natural periods a rise.
Chain one_mass(double ratio, double damping);
/// An output with 2.5 periods a rise, behind half its mass on a spring `ratio` times as stiff.
Chain two_masses(double ratio, double damping);

}  // namespace trains
