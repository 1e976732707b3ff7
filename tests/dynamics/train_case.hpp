// SPDX-License-Identifier: MIT
// One rise of 1 over x in [0, 1] at unit speed and lift, on a train of the tests.
#pragma once

#include "dynamics/train_formulas.hpp"
#include "motions/laws/law_catalogue.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

namespace camopt {

/// λ natural periods a rise, damping ζ.
inline DynamicsSpec one_mass(double ratio, double damping) {
    DynamicsSpec spec;
    spec.mass = 2.5;
    spec.natural_frequency = 2.0 * std::numbers::pi * ratio;
    spec.damping_ratio = damping;
    return spec;
}

struct RiseFigures {
    double residual = 0.0, deflection = 0.0, acceleration = 0.0;
    Eigen::VectorXd end;
};

inline RiseFigures rise_figures(const DynamicsSpec& spec, const Motion& motion) {
    const auto formulas = train_formulas(spec);
    const auto train = formulas->at(1.0, 1.0, 1.0);
    const std::vector<SlopePiece> pieces = formulas->pieces(motion);
    const auto states = train->states_along(pieces, Eigen::VectorXd::Zero(train->states()), 0.0);
    RiseFigures figures;
    figures.end = states.back();
    figures.residual = (train->modes() * figures.end.cast<std::complex<double>>()).cwiseAbs().sum();
    for (std::size_t i = 0; i < pieces.size(); ++i)
        for (const double sign : {1.0, -1.0}) {
            for (const Extremum& one : train->maxima(train->deflection(), sign, states[i], pieces[i], 0.0))
                figures.deflection = std::max(figures.deflection, one.value);
            for (const Extremum& one : train->maxima(train->acceleration(), sign, states[i], pieces[i], 0.0))
                figures.acceleration = std::max(figures.acceleration, one.value);
        }
    return figures;
}

inline RiseFigures rise_figures(const DynamicsSpec& spec, const std::string& law) {
    return rise_figures(spec, *make_law(law));
}

}  // namespace camopt
