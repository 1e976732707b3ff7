// SPDX-License-Identifier: MIT
// The least value of a function over intervals that are halved, and what cases prove together.
#include "studies/bound/branch_and_bound.hpp"

#include "core/numbers/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace branch_and_bound_test {

/// A part of −2 … 2 with a bound of (x² − 1)² + x / 8, whose least value is that of the left minimum.
struct Part : CaseProof {
    Interval x;

    explicit Part(Interval range) : x(range) {
        const Interval inner = square(x) - Interval(1.0);
        bound = (square(inner) + Interval(0.125) * x).lower;
    }
    [[nodiscard]] double value() const {
        const double middle = 0.5 * (x.lower + x.upper), inner = middle * middle - 1.0;
        return inner * inner + 0.125 * middle;
    }
};

struct Search {
    double gap = 1e-6;
    int most = 10000, branched = 0;
    double best = std::numeric_limits<double>::infinity();
    std::vector<Part> parts = {Part(Interval(-2.0, 2.0))};

    void run(double narrowest = 0.0) {
        branch_and_bound(parts, {[this](const Part& part) { return part.bound >= best - gap; },
                                 [this](const Part&) { return branched < most; },
                                 [this, narrowest](const Part& part) { return halves(part, narrowest); }});
    }
    std::optional<std::vector<Part>> halves(const Part& part, double narrowest) {
        if (part.x.width() <= narrowest) return {};
        ++branched;
        const double middle = 0.5 * (part.x.lower + part.x.upper);
        std::vector<Part> both = {Part(Interval(part.x.lower, middle)), Part(Interval(middle, part.x.upper))};
        for (const Part& half : both) best = std::min(best, half.value());
        return both;
    }
    [[nodiscard]] double least_bound() const { return std::ranges::min(parts, {}, &Part::bound).bound; }
    [[nodiscard]] double width() const {
        double sum = 0.0;
        for (const Part& part : parts) sum += part.x.width();
        return sum;
    }
};

TEST(BranchAndBound, BoundMeetsTheLeastValue) {
    Search search;
    search.run();
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 400000; ++k) {
        const double x = -2.0 + 1e-5 * k, inner = x * x - 1.0;
        least = std::min(least, inner * inner + 0.125 * x);
    }
    EXPECT_NEAR(search.best, least, search.gap);
    EXPECT_LE(search.least_bound(), least);
    EXPECT_GE(search.least_bound(), search.best - search.gap);
    EXPECT_NEAR(search.width(), 4.0, 1e-12) << "the parts hold everything";
    EXPECT_LT(search.branched, 400);
}

TEST(BranchAndBound, EndsWhereItIsTold) {
    Search short_one;
    short_one.most = 3;
    short_one.run();
    EXPECT_EQ(short_one.branched, 3);
    EXPECT_EQ(short_one.parts.size(), 4U);
    Search coarse;
    coarse.run(0.5);
    EXPECT_NEAR(coarse.width(), 4.0, 1e-12);
    EXPECT_LT(coarse.least_bound(), coarse.best - coarse.gap) << "a part that cannot be branched stays open";
}

TEST(BranchAndBound, CasesProveTheirLeastBound) {
    Search search;
    search.run();
    Certificate certificate;
    certificate.objective = search.best;
    EXPECT_FALSE(take_cases(certificate, {search.parts.begin(), search.parts.end()}));
    EXPECT_EQ(certificate.proof_kind, ProofKind::boxes);
    EXPECT_EQ(certificate.cases.size(), search.parts.size());
    EXPECT_EQ(certificate.lower_bound, std::min(search.least_bound(), search.best));
    EXPECT_LE(*certificate.gap, search.gap);
    for (Part& part : search.parts) part.infeasible = true;
    Certificate none;
    EXPECT_TRUE(take_cases(none, {search.parts.begin(), search.parts.end()}));
    EXPECT_FALSE(none.lower_bound);
}

TEST(BranchAndBound, RelaxationRaisesBoundsOnly) {
    Certificate relaxation;
    relaxation.verdict = Verdict::optimal;
    relaxation.lower_bound = 2.0;
    relaxation.proof.emplace().bound = 2.0;
    CaseProof part;
    part.bound = 3.0;
    take_bound(part, relaxation);
    EXPECT_EQ(part.bound, 3.0);
    EXPECT_EQ(part.proof, nullptr);
    part.bound = 1.0;
    take_bound(part, relaxation);
    EXPECT_EQ(part.bound, 2.0);
    ASSERT_NE(part.proof, nullptr);
    EXPECT_EQ(part.proof->bound, 2.0);
    EXPECT_FALSE(part.infeasible);
}

}  // namespace branch_and_bound_test
}  // namespace camopt
