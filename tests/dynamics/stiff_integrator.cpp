// SPDX-License-Identifier: MIT
#include "stiff_integrator.hpp"

#include <boost/numeric/odeint.hpp>
#include <utility>

namespace stiff {
namespace {

namespace ublas = boost::numeric::ublas;
using Vector = ublas::vector<double>;
using Matrix = ublas::matrix<double>;

struct Rates {
    const Chain& chain;

    void operator()(const Vector& x, Vector& rate, double) const {
        const std::size_t n = chain.masses.size();
        const Input at = chain.input(x[2 * n]);
        for (std::size_t i = 0; i < n; ++i) {
            rate[i] = x[n + i];
            rate[n + i] = 0.0;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const double before = i == 0 ? at.place : x[i - 1];
            const double before_rate = i == 0 ? at.velocity : x[n + i - 1];
            const Mass& own = chain.masses[i];
            const double force = own.stiffness * (before - x[i]) + own.damping * (before_rate - x[n + i]);
            rate[n + i] += force / own.mass;
            if (i > 0) rate[n + i - 1] -= force / chain.masses[i - 1].mass;
        }
        rate[2 * n] = 1.0;
        rate[2 * n - 1] -= chain.return_stiffness * x[n - 1] / chain.masses.back().mass;
    }
};

struct Slopes {
    const Chain& chain;

    void operator()(const Vector& x, Matrix& out, const double&, Vector& by_time) const {
        const std::size_t n = chain.masses.size();
        out.clear();
        by_time.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const Mass& own = chain.masses[i];
            out(i, n + i) = 1.0;
            out(n + i, i) -= own.stiffness / own.mass;
            out(n + i, n + i) -= own.damping / own.mass;
            if (i == 0) continue;
            const double before = chain.masses[i - 1].mass;
            out(n + i, i - 1) += own.stiffness / own.mass;
            out(n + i, n + i - 1) += own.damping / own.mass;
            out(n + i - 1, i) += own.stiffness / before;
            out(n + i - 1, n + i) += own.damping / before;
            out(n + i - 1, i - 1) -= own.stiffness / before;
            out(n + i - 1, n + i - 1) -= own.damping / before;
        }
        out(2 * n - 1, n - 1) -= chain.return_stiffness / chain.masses.back().mass;
        const Input at = chain.input(x[2 * n]);
        const Mass& first = chain.masses.front();
        out(n, 2 * n) = (first.stiffness * at.velocity + first.damping * at.acceleration) / first.mass;
    }
};

}  // namespace

std::vector<double> integrated(const Chain& chain, double end, double tolerance) {
    using namespace boost::numeric::odeint;
    // The time is a variable too: driven by its own time argument the method is of first order only.
    Vector x(2 * chain.masses.size() + 1, 0.0);
    integrate_adaptive(make_controlled<rosenbrock4<double>>(tolerance, tolerance),
                       std::make_pair(Rates{chain}, Slopes{chain}), x, 0.0, end, 1e-6 * end);
    return {x.begin(), x.end() - 1};
}

}  // namespace stiff
