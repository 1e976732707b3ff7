// SPDX-License-Identifier: MIT
#include "dynamics/linear_train.hpp"

#include "core/errors.hpp"
#include "scene/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr int most_masses = 4;

/// Relative displacements of the masses, row by row times √weight / √mass.
Eigen::MatrixXd weighted_elongations(const LinearTrain& train, double TrainStage::*weight) {
    const int n = train.masses();
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(n, n);
    for (int i = 0; i < n; ++i) {
        const TrainStage& stage = train.stages[static_cast<std::size_t>(i)];
        rows(i, i) = std::sqrt(stage.*weight / stage.mass);
        if (i > 0)
            rows(i, i - 1) = -std::sqrt(stage.*weight / train.stages[static_cast<std::size_t>(i) - 1].mass);
    }
    return rows;
}

/// Springs in series: compliances are added, without cancellation.
void set_static_shapes(LinearTrain& train) {
    const int n = train.masses();
    train.share.setOnes(n);
    train.compliance.setZero(n);
    double series = 0.0;  // m/N from the cam to mass i
    for (int i = 0; i < n; ++i) {
        series += 1.0 / train.stages[static_cast<std::size_t>(i)].stiffness;
        train.compliance[i] = series;
    }
    // The return spring pulls the output by k_r x_n: x = y − c_i k_r x_n with x_n = y / (1 + c_n k_r).
    const double loaded = 1.0 + series * train.return_stiffness;
    for (int i = 0; i < n; ++i) {
        train.share[i] -= train.compliance[i] * train.return_stiffness / loaded;
        train.compliance[i] /= loaded;
    }
}

}  // namespace

Eigen::MatrixXd LinearTrain::elongations() const {
    Eigen::MatrixXd rows = weighted_elongations(*this, &TrainStage::stiffness);
    if (return_stiffness == 0.0) return rows;
    const int n = masses();
    rows.conservativeResize(n + 1, n);
    rows.row(n).setZero();
    rows(n, n - 1) = std::sqrt(return_stiffness / stages.back().mass);
    return rows;
}

Eigen::MatrixXd LinearTrain::damped_elongations() const {
    return weighted_elongations(*this, &TrainStage::damping);
}

LinearTrain linear_train(const DynamicsSpec& spec) {
    LinearTrain train;
    train.stages = spec.stages;
    train.stages.push_back(spec.output());
    train.return_stiffness = spec.return_stiffness;
    train.preload = spec.preload;
    if (train.masses() > most_masses)
        throw SceneError({"dynamics.stage", fmt::format("{} stages before the output", spec.stages.size()),
                          fmt::format("at most {}", most_masses - 1)});
    for (const TrainStage& stage : train.stages)
        if (!(stage.mass > 0.0) || !(stage.stiffness > 0.0) || !(stage.damping >= 0.0))
            throw InputError(
                fmt::format("dynamics: found mass {}, stiffness {}, damping {}; allowed: masses and "
                            "stiffnesses > 0, damping >= 0",
                            stage.mass, stage.stiffness, stage.damping));
    set_static_shapes(train);
    return train;
}

}  // namespace camopt
