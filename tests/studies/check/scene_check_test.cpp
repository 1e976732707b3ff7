// SPDX-License-Identifier: MIT
// What check says of derivatives: no scene of the project is accused, and a partial that is wrong by 1e-4 of
// itself is found.
#include "studies/check/scene_check.hpp"

#include "objectives/grid/cam_problem.hpp"
#include "objectives/scene_model.hpp"
#include "tests/support/scene_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace camopt {
namespace scene_check_test {

using namespace testing_support;

/// Its entries of one kind that count for something are wrong by 1e-4 of themselves.
class SpoiledNlp final : public Nlp {
 public:
    enum class What { gradient, jacobian, hessian };
    SpoiledNlp(const Nlp& inner, What what) : Nlp(inner.shape()), inner_(inner), what_(what) {}
    [[nodiscard]] double cost(const ConstVectorRef& x) const override { return inner_.cost(x); }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        inner_.gradient(x, out);
        if (what_ == What::gradient)
            for (double& value : out) value = spoiled(value);
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { inner_.constraints(x, out); }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override {
        inner_.jacobian(x, out);
        if (what_ == What::jacobian)
            for (double& value : out) value = spoiled(value);
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        inner_.hessian(x, sigma, lambda, out);
        if (what_ == What::hessian)
            for (double& value : out) value = spoiled(value);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return inner_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return inner_.row_name(index); }

    static double spoiled(double value) { return value * (1.0 + 1e-4); }

 private:
    const Nlp& inner_;
    What what_;
};

Eigen::VectorXd off_every_special_place(const ContinuousProblem& problem) {
    Eigen::VectorXd x = problem.completed(problem.start());
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> shift(0.01, 0.1);
    for (double& value : x) value += shift(generator) * std::max(1.0, std::abs(value));
    return x;
}

/// Entries of at least `part` of the largest of their kind.
long telling_entries(const SparsityPattern& pattern, const std::vector<double>& values, bool mirrored) {
    constexpr double part = 1e-3;
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    std::set<std::pair<int, int>> places;
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (std::abs(values[k]) < part * largest) continue;
        places.emplace(pattern.rows[k], pattern.columns[k]);
        if (mirrored) places.emplace(pattern.columns[k], pattern.rows[k]);
    }
    return static_cast<long>(places.size());
}

void expect_faults_found(const Scene& scene) {
    SCOPED_TRACE(scene.title);
    const CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
    const Nlp& grid = problem.grid();
    const Eigen::VectorXd x = off_every_special_place(problem);
    for (const DerivativeError& error : derivative_errors(grid, x)) {
        EXPECT_EQ(error.wrong, 0) << error.kind << " " << error.where;
        EXPECT_GT(error.entries, 0);
    }
    using enum SpoiledNlp::What;
    Eigen::VectorXd slope(grid.shape().variables());
    grid.gradient(x, slope);
    EXPECT_GE(derivative_errors(SpoiledNlp(grid, gradient), x)[0].wrong,
              (slope.array().abs() > 1e-3 * slope.cwiseAbs().maxCoeff()).count());
    std::vector<double> values(static_cast<std::size_t>(grid.shape().jacobian.size()));
    grid.jacobian(x, values);
    EXPECT_GE(derivative_errors(SpoiledNlp(grid, jacobian), x)[1].wrong,
              telling_entries(grid.shape().jacobian, values, false));
    values.resize(static_cast<std::size_t>(grid.shape().hessian.size()));
    Eigen::VectorXd lambda = Eigen::VectorXd::LinSpaced(grid.shape().constraints(), -1.0, 1.0);
    grid.hessian(x, 1.0, lambda, values);
    if (std::ranges::any_of(values, [](double value) { return value != 0.0; })) {
        EXPECT_GT(derivative_errors(SpoiledNlp(grid, hessian), x)[2].wrong, 0);
    }
}

TEST(SceneCheck, FindsPartialsWrongByTenThousandth) {
    expect_faults_found(scene_named("barrel_smallest").with("spline.segments = 6"));
    expect_faults_found(scene_named("cam_forces").with("spline.segments = 8"));
    expect_faults_found(scene_named("drd_rms_jerk"));
    expect_faults_found(scene_named("drd_torque").with("spline.segments = 8"));
}

/// A single entry among thousands.
class OneWrong final : public Nlp {
 public:
    OneWrong(const Nlp& inner, int entry) : Nlp(inner.shape()), inner_(inner), entry_(entry) {}
    [[nodiscard]] double cost(const ConstVectorRef& x) const override { return inner_.cost(x); }
    void gradient(const ConstVectorRef& x, VectorRef out) const override { inner_.gradient(x, out); }
    void constraints(const ConstVectorRef& x, VectorRef out) const override { inner_.constraints(x, out); }
    void jacobian(const ConstVectorRef& x, std::span<double> out) const override { inner_.jacobian(x, out); }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef& lambda,
                 std::span<double> out) const override {
        inner_.hessian(x, sigma, lambda, out);
        out[static_cast<std::size_t>(entry_)] = SpoiledNlp::spoiled(out[static_cast<std::size_t>(entry_)]);
    }
    [[nodiscard]] std::string variable_name(int index) const override { return inner_.variable_name(index); }
    [[nodiscard]] std::string row_name(int index) const override { return inner_.row_name(index); }

 private:
    const Nlp& inner_;
    int entry_;
};

TEST(SceneCheck, FindsWrongEntryOfBarrelHessian) {
    const Scene scene = scene_named("barrel_smallest").with("spline.segments = 6");
    const CamProblem problem(scene_model(scene, DesignKind::states, reference_peaks(scene)));
    const Eigen::VectorXd x = off_every_special_place(problem);
    const SparsityPattern& pattern = problem.grid().shape().hessian;
    std::vector<double> values(static_cast<std::size_t>(pattern.size()));
    const Eigen::VectorXd lambda =
        Eigen::VectorXd::LinSpaced(problem.grid().shape().constraints(), -1.0, 1.0);
    problem.grid().hessian(x, 1.0, lambda, values);
    const auto largest = std::ranges::max_element(values, {}, [](double value) { return std::abs(value); });
    const int entry = static_cast<int>(largest - values.begin());
    const DerivativeError error = derivative_errors(OneWrong(problem.grid(), entry), x)[2];
    EXPECT_EQ(error.wrong, pattern.rows[entry] == pattern.columns[entry] ? 1 : 2);
    EXPECT_GT(error.beyond, 1.0);
}

}  // namespace scene_check_test
}  // namespace camopt
