// SPDX-License-Identifier: MIT
// Closed forms, degenerate and smooth problems, limits and refusals.
#include "core/errors.hpp"
#include "tests/solvers/structured/structured_problems.hpp"
#include "tests/support/refusal.hpp"

#include <random>

namespace camopt::testing {
namespace structured_basic_test {

using testing_support::refusal;

constexpr double tolerance = 2e-9;

TEST(StructuredBasic, LinearProgramInTheBox) {
    QuadraticData data(3);
    data.cost << 1.0, -2.0, 3.0;
    data.x_lower << -1.0, -infinity, 0.5;
    data.x_upper << 5.0, 4.0, 0.5;
    const QuadraticNlp problem(data);
    const BackendResult result = solve(problem);
    expect_optimal(problem, result, tolerance);
    EXPECT_NEAR(problem.cost(result.x), -1.0 - 8.0 + 1.5, 1e-8);
    EXPECT_EQ(result.x[2], 0.5);
    EXPECT_NEAR((*result.bound_multipliers)[0], -1.0, 1e-8);
    EXPECT_NEAR((*result.bound_multipliers)[1], 2.0, 1e-8);
    EXPECT_NEAR((*result.bound_multipliers)[2], -3.0, 1e-8);
}

TEST(StructuredBasic, MultiplierSignsFollowTheContract) {
    // min x² + y², x + y >= 2 (as −infinity <= −x − y <= −2 too), 0 <= x − y + 1 <= 9: x = y = 1.
    QuadraticData data(2);
    data.hessian.insert(0, 0) = 2.0;
    data.hessian.insert(1, 1) = 2.0;
    RowCollector rows;
    rows.add({{0, 1.0}, {1, 1.0}}, 2.0, infinity);
    rows.add({{0, 1.0}, {1, -1.0}}, 0.0, 9.0);
    rows.add({{0, 1.0}}, -infinity, infinity);
    rows.write(data);
    data.row_constant = Eigen::Vector3d(0.0, 1.0, 7.0);
    const QuadraticNlp problem(data);
    const BackendResult result = solve(problem);
    expect_optimal(problem, result, tolerance);
    EXPECT_NEAR(result.x[0], 1.0, 1e-8);
    EXPECT_NEAR((*result.row_multipliers)[0], -2.0, 1e-8);
    EXPECT_NEAR((*result.row_multipliers)[1], 0.0, 1e-8);
    EXPECT_EQ((*result.row_multipliers)[2], 0.0);
}

TEST(StructuredBasic, EqualityQuadraticProgramIsLinearSystem) {
    // min ½‖x‖², Σ x = 3 written three times: x = 1, multipliers of the copies sum to −1.
    QuadraticData data(3);
    for (int i = 0; i < 3; ++i) data.hessian.insert(i, i) = 1.0;
    RowCollector rows;
    for (const double factor : {1.0, 2.0, -5.0})
        rows.add({{0, factor}, {1, factor}, {2, factor}}, 3.0 * factor, 3.0 * factor);
    rows.write(data);
    const QuadraticNlp problem(data);
    const BackendResult result = solve(problem);
    expect_optimal(problem, result, tolerance);
    EXPECT_LE((result.x - Eigen::Vector3d::Ones()).norm(), 1e-8);
}

TEST(StructuredBasic, UnconstrainedQuadraticAndNothingAtAll) {
    QuadraticData data(2);
    data.hessian.insert(0, 0) = 2.0;
    data.hessian.insert(1, 1) = 8.0;
    data.cost << -2.0, 8.0;
    const QuadraticNlp problem(data);
    const BackendResult result = solve(problem);
    expect_optimal(problem, result, tolerance);
    EXPECT_LE((result.x - Eigen::Vector2d(1.0, -1.0)).norm(), 1e-8);
    const QuadraticNlp empty{QuadraticData(0, 0)};
    EXPECT_EQ(solve(empty).termination, Termination::converged);
    QuadraticData fixed(1);
    fixed.x_lower << 2.0;
    fixed.x_upper << 2.0;
    fixed.cost << 3.0;
    const QuadraticNlp only_fixed(fixed);
    const BackendResult constant = solve(only_fixed);
    EXPECT_EQ(constant.termination, Termination::converged);
    EXPECT_EQ(constant.x[0], 2.0);
    EXPECT_NEAR((*constant.bound_multipliers)[0], -3.0, 1e-12);
}

TEST(StructuredBasic, DegenerateLinearPrograms) {
    // Many rows through one vertex, and a whole face of optima.
    QuadraticData data(3);
    data.cost << -1.0, -1.0, 0.0;
    for (int j = 0; j < 3; ++j) data.x_lower[j] = 0.0;
    RowCollector rows;
    for (int k = 1; k <= 20; ++k) rows.add({{0, 1.0 * k}, {1, 21.0 - k}}, -infinity, 21.0);
    rows.add({{0, 1.0}, {1, 1.0}}, -infinity, 2.0);
    rows.add({{2, 1.0}}, -infinity, 1.0);
    rows.write(data);
    const QuadraticNlp problem(data);
    const BackendResult result = solve(problem);
    expect_optimal(problem, result, tolerance);
    EXPECT_NEAR(problem.cost(result.x), -2.0, 1e-9);
}

TEST(StructuredBasic, BadlyScaledRowsAndColumns) {
    QuadraticData data(2);
    data.cost << 1e6, 1e-4;
    data.x_lower << 0.0, 0.0;
    RowCollector rows;
    rows.add({{0, 1e8}, {1, 1e-3}}, 2e2, infinity);
    rows.add({{0, 1e-5}}, 1e-12, infinity);
    rows.write(data);
    const QuadraticNlp problem(data);
    const BackendResult result = solve(problem);
    ASSERT_EQ(result.termination, Termination::converged) << result.native_status;
    // cost a unit of the first row: x 1e-2, y 1e-1, so x = 2e-6 alone.
    EXPECT_NEAR(problem.cost(result.x), 2.0, 1e-8);
}

TEST(StructuredBasic, NonnegativeLeastSquaresMatchesEverySubset) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 60; ++trial) {
        const int size = 2 + trial % 6, height = size + 3;
        Eigen::MatrixXd a = Eigen::MatrixXd::NullaryExpr(height, size, [&] { return normal(random); });
        if (trial % 4 == 3) a.col(size - 1) = a.col(0);
        const Eigen::VectorXd b = Eigen::VectorXd::NullaryExpr(height, [&] { return normal(random); });
        double least = b.squaredNorm();
        for (int set = 1; set < (1 << size); ++set) {
            std::vector<int> columns;
            for (int j = 0; j < size; ++j)
                if ((set >> j) & 1) columns.push_back(j);
            Eigen::MatrixXd part(height, static_cast<Eigen::Index>(columns.size()));
            for (std::size_t k = 0; k < columns.size(); ++k)
                part.col(static_cast<Eigen::Index>(k)) = a.col(columns[k]);
            const Eigen::VectorXd free = part.colPivHouseholderQr().solve(b);
            if (free.minCoeff() >= 0.0) least = std::min(least, (part * free - b).squaredNorm());
        }
        QuadraticData data(size);
        data.hessian = Eigen::MatrixXd(2.0 * a.transpose() * a).sparseView();
        data.cost = -2.0 * a.transpose() * b;
        data.constant = b.squaredNorm();
        data.x_lower.setZero();
        const QuadraticNlp problem(data);
        const BackendResult result = solve(problem);
        expect_optimal(problem, result, 1e-8);
        EXPECT_NEAR(problem.cost(result.x), least, 1e-8 * (1.0 + least)) << trial;
    }
}

/// min w/2 (xᵀ Q x / R + R), Q = diag(q), Σ x = 1, R >= low: the least over R is w √(xᵀQx).
class PerspectiveNlp final : public Nlp {
 public:
    PerspectiveNlp(Eigen::VectorXd q, double low) : q_(std::move(q)) {
        const Eigen::Index n = q_.size();
        shape_.x_lower = Eigen::VectorXd::Constant(n + 1, -infinity);
        shape_.x_lower[n] = low;
        shape_.x_upper = Eigen::VectorXd::Constant(n + 1, infinity);
        shape_.g_lower = shape_.g_upper = Eigen::VectorXd::Ones(1);
        shape_.rows.resize(1);
        for (int j = 0; j < n; ++j) {
            shape_.jacobian.rows.push_back(0);
            shape_.jacobian.columns.push_back(j);
            for (const int row : {j, static_cast<int>(n)}) {
                shape_.hessian.rows.push_back(row);
                shape_.hessian.columns.push_back(j);
            }
        }
        shape_.hessian.rows.push_back(static_cast<int>(n));
        shape_.hessian.columns.push_back(static_cast<int>(n));
        shape_.convex = true;
    }
    double energy(const ConstVectorRef& x) const { return x.head(q_.size()).cwiseAbs2().dot(q_); }
    double cost(const ConstVectorRef& x) const override {
        const double r = x[q_.size()];
        EXPECT_GT(r, 0.0);
        return 0.5 * weight * (energy(x) / r + r);
    }
    void gradient(const ConstVectorRef& x, VectorRef out) const override {
        const double r = x[q_.size()];
        out.head(q_.size()) = weight / r * q_.cwiseProduct(x.head(q_.size()));
        out[q_.size()] = 0.5 * weight * (1.0 - energy(x) / (r * r));
    }
    void constraints(const ConstVectorRef& x, VectorRef out) const override {
        out[0] = x.head(q_.size()).sum();
    }
    void jacobian(const ConstVectorRef&, std::span<double> out) const override {
        std::fill(out.begin(), out.end(), 1.0);
    }
    void hessian(const ConstVectorRef& x, double sigma, const ConstVectorRef&,
                 std::span<double> out) const override {
        const double r = x[q_.size()], w = sigma * weight;
        std::size_t k = 0;
        for (Eigen::Index j = 0; j < q_.size(); ++j) {
            out[k++] = w / r * q_[j];
            out[k++] = -w / (r * r) * q_[j] * x[j];
        }
        out[k] = w * energy(x) / (r * r * r);
    }
    std::string variable_name(int) const override { return "x"; }
    std::string row_name(int) const override { return "sum"; }

 private:
    static constexpr double weight = 0.7;
    Eigen::VectorXd q_;
};

TEST(StructuredBasic, SmoothPerspectiveCost) {
    for (const double size : {1.0, 100.0, 0.01}) {
        const Eigen::VectorXd q = size * Eigen::VectorXd::LinSpaced(8, 1.0, 8.0);
        const double least = 0.7 / std::sqrt(q.cwiseInverse().sum());  // Σ x = 1: xᵀQx >= 1 / Σ 1/q
        const PerspectiveNlp problem(q, 1e-6);
        for (const double r : {1.0, 1e-5, 50.0}) {
            Eigen::VectorXd start = Eigen::VectorXd::Zero(9);
            start[8] = r;
            const BackendResult result = make_structured_solver()->minimize(problem, start, {}, {});
            expect_optimal(problem, result, 1e-8);
            EXPECT_NEAR(problem.cost(result.x), least, 1e-8)
                << size << " " << r << " " << result.native_status;
        }
    }
}

TEST(StructuredBasic, NamesUnboundedProblems) {
    QuadraticData data(2);
    data.cost << -1.0, 0.0;
    data.x_lower << 0.0, 0.0;
    RowCollector rows;
    rows.add({{0, 1.0}, {1, -1.0}}, -infinity, 1.0);
    rows.write(data);
    EXPECT_EQ(solve(QuadraticNlp(data)).termination, Termination::unbounded);
    data.hessian.insert(1, 1) = 1.0;  // curvature along the ray: bounded again, x = 2, y = 1
    const QuadraticNlp curved(data);
    const BackendResult result = solve(curved);
    expect_optimal(curved, result, tolerance);
    EXPECT_NEAR(result.x[0], 2.0, 1e-8);
    QuadraticData free(1);
    free.cost << 1.0;
    EXPECT_EQ(solve(QuadraticNlp(free)).termination, Termination::unbounded);
}

TEST(StructuredBasic, SkipsProofsIfOptimumIsKnown) {
    QuadraticData free(1);
    free.cost << 1.0;
    QuadraticData crossed(2, 2);  // x0 + x1 <= 0 and x0 + x1 >= 1
    for (const int row : {0, 1})
        for (const int column : {0, 1}) crossed.rows.insert(row, column) = 1.0;
    crossed.upper[0] = 0.0;
    crossed.lower[1] = 1.0;
    BackendOptions options;
    for (const auto& [data, word] :
         {std::pair(free, Termination::unbounded), {crossed, Termination::infeasible}}) {
        options.has_optimum = false;
        EXPECT_EQ(solve(QuadraticNlp(data), options).termination, word);
        options.has_optimum = true;
        EXPECT_EQ(solve(QuadraticNlp(data), options).termination, Termination::numerical_failure);
    }
}

TEST(StructuredBasic, AcceptsLinearProblemsDeclaredNonlinear) {
    // x² − 2 x with −1 <= x <= 3 as a row: the flags alone choose the sequential method.
    QuadraticData data(1, 1);
    data.hessian.insert(0, 0) = 2.0;
    data.cost << -2.0;
    data.rows.insert(0, 0) = 1.0;
    data.lower << -1.0;
    data.upper << 3.0;
    QuadraticNlp nonlinear(data);
    nonlinear.mutable_shape().rows[0].linear = false;
    expect_optimal(nonlinear, solve(nonlinear), tolerance);
    QuadraticNlp concave(data);
    concave.mutable_shape().convex = false;
    const BackendResult result = solve(concave);
    expect_optimal(concave, result, tolerance);
    EXPECT_NEAR(result.x[0], 1.0, 1e-8);
}

TEST(StructuredBasic, RefusesStartOfWrongSize) {
    const QuadraticData data(1, 1);
    EXPECT_EQ(refusal([&] {
                  (void)make_structured_solver()->minimize(QuadraticNlp(data), Eigen::VectorXd(3), {}, {});
              }),
              "start of the solve: found 3 entries, the problem has 1 variables");
}

TEST(StructuredBasic, NamesValuesThatAreNotFinite) {
    QuadraticData data(1);
    data.hessian.insert(0, 0) = 1.0;
    data.cost << std::nan("");
    EXPECT_EQ(solve(QuadraticNlp(data)).termination, Termination::evaluation_error);
}

TEST(StructuredBasic, RespectsLimitsOfTheCaller) {
    const QuadraticNlp problem(cam_problem(uniform_cam(12)));
    BackendOptions options;
    options.max_iterations = 3;
    const BackendResult few = solve(problem, options);
    EXPECT_EQ(few.termination, Termination::iteration_limit);
    EXPECT_EQ(few.iterations, 3);
    EXPECT_TRUE(few.x.allFinite());
    SolveControl control;
    int polls = 0;
    control.stop_requested = [&] { return ++polls > 2; };
    EXPECT_EQ(solve(problem, {}, control).termination, Termination::interrupted);
    options = {};
    options.max_seconds = 1e-9;
    EXPECT_EQ(solve(problem, options).termination, Termination::time_limit);
}

TEST(StructuredBasic, ReadsItsOptions) {
    EXPECT_EQ(structured_options({{"correctors", 4LL}}).correctors, 4);
    EXPECT_EQ(structured_options({{"regularisation", 1e-8}}).regularisation, 1e-8);
    EXPECT_EQ(refusal([&] {
                  (void)structured_options({{"corectors", 4LL}});
              }),
              "structured has no option \"corectors\"; allowed: correctors, factorization, first_radius, "
              "max_iterations, max_passes, patience, regularisation");
    EXPECT_EQ(refusal([&] {
                  (void)structured_options({{"correctors", 1.5}});
              }),
              "structured.correctors: an integer of moderate size is expected");
    EXPECT_EQ(refusal([&] {
                  (void)structured_options({{"patience", 0LL}});
              }),
              "structured.patience: allowed is >= 2");
}

}  // namespace structured_basic_test
}  // namespace camopt::testing
