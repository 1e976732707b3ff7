// SPDX-License-Identifier: MIT
// Trains of several masses against a stiff integrator that knows none of their formulas.
#include "stiff_integrator.hpp"
#include "train_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace camopt {
namespace integrated_train_test {

double integrated_output(const DynamicsSpec& spec, const Motion& law) {
    stiff::Chain chain;
    for (const TrainStage& stage : spec.stages)
        chain.masses.push_back({stage.mass, stage.stiffness, stage.damping});
    const TrainStage output = spec.output();
    chain.masses.push_back({output.mass, output.stiffness, output.damping});
    chain.return_stiffness = spec.return_stiffness;
    chain.input = [&law](double time) {
        const MotionPoint at = law.at(std::clamp(time, 0.0, 1.0));
        return stiff::Input{at.derivative[0], at.derivative[1], at.derivative[2]};
    };
    return stiff::integrated(chain, 1.0, 1e-12)[chain.masses.size() - 1];
}

double exact_output(const DynamicsSpec& spec, const Motion& law) {
    const auto formulas = train_formulas(spec);
    const auto train = formulas->at(1.0, 1.0, 1.0);
    const auto states =
        train->states_along(formulas->pieces(law), Eigen::VectorXd::Zero(train->states()), 0.0);
    return 1.0 + train->deflection().state.dot(states.back()) + train->deflection().motion[0];
}

TEST(IntegratedTrain, TwoMassesAgree) {
    const auto law = make_law("polynomial_345");
    for (const double ratio : {0.7, 2.5, 6.1})
        for (const double damping : {0.0, 0.05, 0.7, 1.3})
            for (const double stiffer : {1.0, 30.0}) {
                DynamicsSpec spec = one_mass(ratio, damping);
                const double stiffness = stiffer * spec.output().stiffness;
                spec.stages = {{0.8, stiffness, 2.0 * damping * std::sqrt(0.8 * stiffness)}};
                const double amplitude = rise_figures(spec, *law).deflection;
                EXPECT_NEAR(exact_output(spec, *law), integrated_output(spec, *law), 1e-8 * amplitude)
                    << ratio << ' ' << damping << ' ' << stiffer;
            }
}

TEST(IntegratedTrain, FourMassesWithSpringAgree) {
    const auto law = make_law("modified_sine");
    DynamicsSpec spec = one_mass(2.2, 0.04);
    spec.return_stiffness = 60.0;
    spec.stages = {{0.5, 900.0, 1.0}, {0.7, 1500.0, 0.5}, {0.4, 700.0, 2.0}};
    const double amplitude = rise_figures(spec, *law).deflection;
    EXPECT_NEAR(exact_output(spec, *law), integrated_output(spec, *law), 1e-8 * amplitude);
}

}  // namespace integrated_train_test
}  // namespace camopt
