// SPDX-License-Identifier: MIT
#include "dynamics/linear_train.hpp"

#include "core/errors.hpp"
#include "scene/scene_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace camopt {

namespace {

constexpr int most_masses = 4;

/// Each mass against the one before it, row by row times √weight / √mass.
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

/// Springs in series: compliances add up, and nothing is subtracted.
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

/// Of bounded size: nothing is allocated where the maximum is ruled out.
using Bernstein = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 28, 1>;

// Bounds this close, of the size of the coefficients, are one number.
constexpr double same_bound = 4e-16;
constexpr int most_halvings = 60;

/// b_j = Σ_{k<=j} C(j,k) / C(n,k) c_k.
Bernstein bernstein(const Eigen::Ref<const Eigen::VectorXd>& power) {
    const Eigen::Index n = power.size() - 1;
    Bernstein table = power;
    // By differences: scale to c_k / C(n,k), then sum up n times.
    double binomial = 1.0;
    for (Eigen::Index k = 0; k <= n; ++k) {
        table[k] /= binomial;
        binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    for (Eigen::Index i = 1; i <= n; ++i)
        for (Eigen::Index j = n; j >= i; --j) table[j] += table[j - 1];
    return table;
}

struct Part {
    Bernstein coefficients;
    double begin, width;
    int halvings;
};

Part left_half(Part& part) {
    const Eigen::Index n = part.coefficients.size() - 1;
    Bernstein left(n + 1);
    Bernstein& work = part.coefficients;
    for (Eigen::Index i = 0; i <= n; ++i) {
        left[i] = work[0];
        for (Eigen::Index j = 0; j + i < n; ++j) work[j] = 0.5 * (work[j] + work[j + 1]);
    }
    // `work` now holds the right half's coefficients from the end on: work[n−i] was fixed at pass i.
    Part half{std::move(left), part.begin, 0.5 * part.width, part.halvings + 1};
    part.begin += 0.5 * part.width;
    part.width *= 0.5;
    ++part.halvings;
    return half;
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

std::optional<PolynomialMaximum> bounded_maximum(const Eigen::Ref<const Eigen::VectorXd>& polynomial,
                                                 double floor) {
    const double first = polynomial[0], last = polynomial.sum();
    PolynomialMaximum best{first, 0.0};
    if (last > best.value) best = {last, 1.0};
    Bernstein coefficients = bernstein(polynomial);
    if (!(coefficients.maxCoeff() > floor)) return std::nullopt;
    const double size = coefficients.cwiseAbs().maxCoeff();
    // The ends alone, where the polynomial only rises or only falls.
    const auto monotone = [](const Bernstein& c) {
        bool up = true, down = true;
        for (Eigen::Index k = 0; k + 1 < c.size(); ++k) {
            up = up && c[k + 1] >= c[k];
            down = down && c[k + 1] <= c[k];
        }
        return up || down;
    };
    std::vector<Part> open;
    open.push_back({std::move(coefficients), 0.0, 1.0, 0});
    while (!open.empty()) {
        Part part = std::move(open.back());
        open.pop_back();
        const Eigen::Index n = part.coefficients.size() - 1;
        if (part.coefficients[0] > best.value) best = {part.coefficients[0], part.begin};
        if (part.coefficients[n] > best.value) best = {part.coefficients[n], part.begin + part.width};
        const double upper = part.coefficients.maxCoeff();
        if (upper <= best.value + same_bound * size || upper <= floor || part.halvings >= most_halvings ||
            monotone(part.coefficients))
            continue;
        Part left = left_half(part);
        // The more promising half first, so that the other one is cut off.
        if (!(left.coefficients.maxCoeff() > part.coefficients.maxCoeff())) std::swap(left, part);
        open.push_back(std::move(part));
        open.push_back(std::move(left));
    }
    if (!(best.value > floor)) return std::nullopt;
    return best;
}

}  // namespace camopt
