// SPDX-License-Identifier: MIT
// Boost.odeint: Rosenbrock of order 4 with its Jacobian, Dormand-Prince 5(4) and Runge-Kutta 4 in fixed
// steps. C++17: Boost 1.74's vectors call members of std::allocator that C++20 took away.
#include "benchmarks/trains/integrators.hpp"

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <exception>
#include <utility>

namespace trains {

namespace {

namespace odeint = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;
using Stiff = ublas::vector<double>;
using StiffMatrix = ublas::matrix<double>;
using Plain = std::vector<double>;

struct TooMany : std::exception {};

struct Counted {
    const Chain& chain;
    long& count;

    void operator()(const Plain& state, Plain& rate, double x) const {
        if (++count > most_evaluations) throw TooMany();
        chain.rates(x, state.data(), rate.data());
    }
};

/// With x as a variable of its own: through its time argument the method is of first order only.
struct StiffRates {
    const Chain& chain;
    long& count;

    void operator()(const Stiff& state, Stiff& rate, double) const {
        if (++count > most_evaluations) throw TooMany();
        chain.rates(state[chain.states()], &state[0], &rate[0]);
        rate[chain.states()] = 1.0;
    }
};

struct StiffSlopes {
    const Chain& chain;
    const Plain jacobian;

    void operator()(const Stiff& state, StiffMatrix& out, const double&, Stiff& by_time) const {
        const std::size_t n = chain.states();
        out.clear();
        by_time.clear();
        Plain by_x(n);
        chain.rate_by_x(state[n], by_x.data());
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) out(i, j) = jacobian[i * n + j];
            out(i, n) = by_x[i];
        }
    }
};

Run finished(Plain state, long count) {
    for (const double value : state)
        if (!std::isfinite(value)) return {{}, count, "unstable"};
    return {std::move(state), count, "ok"};
}

template <typename Work>
Run guarded(Work work) {
    long count = 0;
    try {
        Plain state = work(count);
        return finished(std::move(state), count);
    } catch (const TooMany&) {
        return {{}, count, "too many evaluations"};
    } catch (const std::exception& error) {
        return {{}, count, error.what()};
    }
}

Run rosenbrock(const Chain& chain, double tolerance) {
    return guarded([&](long& count) {
        Stiff state(chain.states() + 1, 0.0);
        odeint::integrate_adaptive(
            odeint::make_controlled<odeint::rosenbrock4<double>>(tolerance, tolerance),
            std::make_pair(StiffRates{chain, count}, StiffSlopes{chain, chain.jacobian()}), state, 0.0, 1.0,
            1e-6);
        return Plain(state.begin(), state.end() - 1);
    });
}

Run dormand_prince(const Chain& chain, double tolerance) {
    return guarded([&](long& count) {
        Plain state(chain.states(), 0.0);
        odeint::integrate_adaptive(
            odeint::make_controlled<odeint::runge_kutta_dopri5<Plain>>(tolerance, tolerance),
            Counted{chain, count}, state, 0.0, 1.0, 1e-6);
        return state;
    });
}

Run runge_kutta(const Chain& chain, double steps) {
    return guarded([&](long& count) {
        Plain state(chain.states(), 0.0);
        odeint::runge_kutta4<Plain> method;
        const auto all = static_cast<long>(steps);
        for (long k = 0; k < all; ++k)
            method.do_step(Counted{chain, count}, state, static_cast<double>(k) / steps, 1.0 / steps);
        return state;
    });
}

}  // namespace

std::vector<Integrator> odeint_integrators() {
    const Plain tolerances = {1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13};
    return {{"Rosenbrock 4 (odeint)", true, false, tolerances, rosenbrock},
            {"Dormand-Prince 5 (odeint)", false, false, tolerances, dormand_prince},
            {"Runge-Kutta 4 (odeint)", false, true, {1e2, 3e2, 1e3, 3e3, 1e4, 3e4, 9e4}, runge_kutta}};
}

}  // namespace trains
