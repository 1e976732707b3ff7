// SPDX-License-Identifier: MIT
// The passes of the wide set against those of the baseline, where the machine has both.
#include "solvers/structured/newton/side_kernels.hpp"

#include "linear/kernels.hpp"
#include "solvers/structured/interior_point.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <vector>

namespace camopt::structured {
namespace side_kernels_test {

using Eigen::VectorXd;

constexpr int ranges = 19, sides = 2 * ranges;  // a multiple of no register
constexpr double few_ulps = 4e-15;              // entries are of order 1

class UsedKernels {
 public:
    explicit UsedKernels(KernelSet set) { use_kernels(set); }
    ~UsedKernels() { use_kernels(before_); }
    UsedKernels(const UsedKernels&) = delete;
    UsedKernels& operator=(const UsedKernels&) = delete;

 private:
    KernelSet before_ = kernel_set();
};

VectorXd random(Eigen::Index size, double low, double high, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> between(low, high);
    return VectorXd::NullaryExpr(size, [&] { return between(generator); });
}

/// Everything that the passes make of one point, in a row.
class Passes {
 public:
    std::vector<double> all(KernelSet set) {
        const UsedKernels used(set);
        const SideKernels& kernels = side_kernels();
        made_.clear();
        for (VectorXd* v : {&a_, &b_, &c_, &d_}) v->setZero();
        SideResiduals moved;
        moved.x = x_.data();
        moved.image = image_.data();
        moved.gap = gap_.data();
        moved.dual = dual_.data();
        moved.gap_change = moved.dual_change = change_.data();
        moved.primal_step = 0.3;
        moved.dual_step = 0.2;
        moved.new_gap = a_.data();
        moved.new_dual = b_.data();
        moved.bound = c_.data();
        moved.out = {joined_.data(), sums_.data()};
        kernels.residuals(layout_, moved);
        keep();
        made_.insert(made_.end(), {moved.products, moved.largest, moved.bound_total, moved.dual_limit});
        kernels.point(layout_, {gap_.data(), dual_.data(), inverse_gap_.data(), inverse_dual_.data(),
                                curvature_.data(), a_.data(), sums_.data()});
        keep();
        for (const ChangeRule rule :
             {ChangeRule::none, ChangeRule::products, ChangeRule::corrected, ChangeRule::centrality})
            directions(kernels, rule);
        return made_;
    }

 private:
    void directions(const SideKernels& kernels, ChangeRule rule) {
        const bool bounded = rule != ChangeRule::centrality;
        SideForces forces;
        forces.rule = rule;
        forces.target = 0.4;
        forces.least = 0.9;
        forces.most = 1.1;
        forces.primal_step = forces.dual_step = 0.5;
        forces.gap_change = forces.dual_change = change_.data();
        forces.gap = gap_.data();
        forces.dual = dual_.data();
        forces.inverse_gap = inverse_gap_.data();
        forces.bound = bounded ? bound_.data() : nullptr;
        forces.change = a_.data();
        forces.force = b_.data();
        forces.out = {joined_.data(), sums_.data()};
        kernels.forces(layout_, forces);
        keep();
        kernels.multipliers(
            layout_, {x_.data(), image_.data(), curvature_.data(), b_.data(), -1.0, c_.data(), forces.out});
        keep();
        SideDirection direction;
        direction.x = x_.data();
        direction.image = image_.data();
        direction.nu = c_.data();
        direction.change = a_.data();
        direction.gap = gap_.data();
        direction.dual = dual_.data();
        direction.inverse_gap = inverse_gap_.data();
        direction.inverse_dual = inverse_dual_.data();
        direction.bound = forces.bound;
        if (!bounded) direction.base_gap = direction.base_dual = change_.data();
        direction.gap_change = b_.data();
        direction.dual_change = d_.data();
        kernels.direction(layout_, direction);
        keep();
        made_.insert(made_.end(), {direction.steepest_gap, direction.steepest_dual, direction.total,
                                   direction.gap_dual, direction.dual_gap, direction.change_change});
    }

    void keep() {
        for (const VectorXd* v : {&a_, &b_, &c_, &d_, &joined_, &sums_})
            made_.insert(made_.end(), v->begin(), v->end());
    }

    const VectorXd x_ = random(3, 0.5, 1.5, 1), image_ = random(ranges, -1.0, 1.0, 2),
                   gap_ = random(sides, 0.5, 1.5, 3), dual_ = random(sides, 0.5, 1.5, 4),
                   change_ = random(sides, -0.5, 0.5, 5), bound_ = random(sides, -0.5, 0.5, 6),
                   width_ = random(ranges, 0.5, 1.5, 7), limit_ = random(sides, -1.0, 1.0, 8);
    const VectorXd present_ =
        VectorXd::NullaryExpr(sides, [](Eigen::Index b) { return b % 5 == 0 ? 0.0 : 1.0; });
    const std::vector<SideSegment> segments_ = {{-1, 0, 2}, {2, 2, 13}, {0, 13, ranges}};
    const SideLayout layout_ = {segments_.data(), 3, ranges, width_.data(), limit_.data(), present_.data()};
    VectorXd inverse_gap_ = VectorXd(sides), inverse_dual_ = VectorXd(sides), curvature_ = VectorXd(sides);
    VectorXd a_ = VectorXd::Zero(sides), b_ = a_, c_ = a_, d_ = a_;
    VectorXd joined_ = VectorXd::Zero(ranges), sums_ = VectorXd::Zero(3);
    std::vector<double> made_;
};

TEST(SideKernels, WideSetAgreesWithBaseline) {
    Passes passes;
    const std::vector<double> baseline = passes.all(KernelSet::baseline);
    EXPECT_EQ(baseline, passes.all(KernelSet::baseline));  // reproducible
    if (!has_wide_kernels()) GTEST_SKIP() << "no AVX2 here";
    const std::vector<double> wide = passes.all(KernelSet::wide);
    ASSERT_EQ(wide.size(), baseline.size());
    for (std::size_t k = 0; k < wide.size(); ++k)
        EXPECT_NEAR(wide[k], baseline[k], few_ulps * std::max(1.0, std::abs(baseline[k]))) << k;
}

/// min Σ c x subject to |x_k − x_{k+1}| <= w, |x| <= 1: w a variable that costs.
ConvexModel stairs(int count) {
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k + 1 < count; ++k)
        for (const int sign : {1, -1}) {
            const int row = 2 * k + (sign > 0 ? 0 : 1);
            entries.insert(entries.end(),
                           {{row, k, 1.0 * sign}, {row, k + 1, -1.0 * sign}, {row, count, -1.0}});
        }
    const int rows = 2 * (count - 1);
    ConvexModel model;
    model.rows.resize(rows, count + 1);
    model.rows.setFromTriplets(entries.begin(), entries.end());
    model.row_lower = VectorXd::Constant(rows, -infinity);
    model.row_upper = VectorXd::Zero(rows);
    model.x_lower = VectorXd::Constant(count + 1, -1.0);
    model.x_upper = VectorXd::Constant(count + 1, 1.0);
    VectorXd cost = random(count + 1, -1.0, 1.0, 9);
    cost[count] = 3.0;
    model.cost = std::make_unique<LinearCost>(cost);
    return model;
}

TEST(SideKernels, InteriorPointReachesSameOptimum) {
    if (!has_wide_kernels()) GTEST_SKIP() << "no AVX2 here";
    const ConvexModel model = stairs(50);
    const auto solve = [&](KernelSet set) {
        const UsedKernels used(set);
        return interior_point(model, VectorXd::Zero(model.variables()), {}, {});
    };
    const InteriorPointResult baseline = solve(KernelSet::baseline), wide = solve(KernelSet::wide);
    ASSERT_EQ(baseline.stop, Stop::converged);
    ASSERT_EQ(wide.stop, Stop::converged);
    EXPECT_EQ(wide.iterations, baseline.iterations);
    EXPECT_NEAR(model.cost->value(wide.best.x), model.cost->value(baseline.best.x), 1e-10);
    EXPECT_EQ(solve(KernelSet::wide).best.x, wide.best.x);  // to the last bit
}

}  // namespace side_kernels_test
}  // namespace camopt::structured
