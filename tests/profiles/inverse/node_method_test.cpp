// SPDX-License-Identifier: MIT
// The paper's approximate method: what converges with the number of nodes, and what does not.
#include "benchmarks/papers/paper_guide.hpp"
#include "core/errors.hpp"
#include "reference_machine.hpp"
#include "tests/support/refusal.hpp"

#include <gtest/gtest.h>

namespace camopt {

namespace node_method_test {

using testing_support::refusal;

TEST(NodeMethod, HundredStepsAsInThePaper) {
    // Its printed rows are multiples of 0.00158 s: 100 steps, 101 nodes.
    const NodeMethodError forward =
        node_method_error(make_g1_guide(test::forward_dimensions()), test::forward_stroke(), 101);
    EXPECT_NEAR(forward.velocity, 0.115, 0.0005);  // of 4.9 rad/s
    EXPECT_NEAR(forward.acceleration, 146.0, 0.5);
    const NodeMethodError back =
        node_method_error(make_g1_guide(test::return_dimensions()), test::return_stroke(), 101);
    EXPECT_NEAR(back.acceleration, 160.0, 0.5);
}

TEST(NodeMethod, VelocityConvergesAccelerationDoesNot) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    double last_velocity = 1e9, last_away = 1e9;
    for (const int nodes : {101, 401, 1601, 6401}) {
        const NodeMethodError error = node_method_error(guide, test::forward_stroke(), nodes);
        EXPECT_LT(error.velocity, 0.5 * last_velocity);
        EXPECT_LT(error.acceleration_away, 0.5 * last_away);
        EXPECT_GT(error.acceleration, 50.0);  // theta'' jumps by 399 rad/s² at L3
        last_velocity = error.velocity;
        last_away = error.acceleration_away;
    }
    EXPECT_LT(last_velocity, 3e-3);
}

TEST(NodeMethod, RefusesTooFewNodes) {
    const Guide guide = make_g1_guide(test::forward_dimensions());
    EXPECT_EQ(refusal([&] { (void)node_method(guide, test::forward_stroke(), 2); }),
              "2 nodes were requested; central differences need at least 3");
    EXPECT_EQ(node_method(guide, test::forward_stroke(), 3).size(), 3U);
}

}  // namespace node_method_test

}  // namespace camopt
