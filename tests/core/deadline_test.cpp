// SPDX-License-Identifier: MIT
#include "core/deadline.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace camopt {
namespace deadline_test {

struct Hand {
    double now = 100.0;
    Deadline::Clock clock() {
        return [this] { return now; };
    }
};

TEST(Deadline, NoneNeverPasses) {
    const Deadline none;
    EXPECT_FALSE(none.passed());
    EXPECT_TRUE(std::isinf(none.seconds_left()));
    EXPECT_FALSE(none.was_felt());
}

TEST(Deadline, RemembersThatItWasPolled) {
    Hand hand;
    const Deadline deadline = Deadline::after(5.0, hand.clock());
    EXPECT_EQ(deadline.seconds_left(), 5.0);
    hand.now += 4.5;
    EXPECT_FALSE(deadline.passed());
    EXPECT_EQ(deadline.seconds_left(), 0.5);
    hand.now += 0.5;
    EXPECT_FALSE(deadline.was_felt()) << "nobody has asked yet";
    EXPECT_TRUE(deadline.passed());
    EXPECT_TRUE(deadline.was_felt());
    hand.now += 100.0;
    EXPECT_EQ(deadline.seconds_left(), 0.0);
}

TEST(Deadline, PartsNeverOutlastTheWhole) {
    Hand hand;
    const Deadline whole = Deadline::after(5.0, hand.clock());
    EXPECT_EQ(whole.sooner(50.0).seconds_left(), 5.0);
    const Deadline part = whole.sooner(1.0);
    EXPECT_EQ(part.seconds_left(), 1.0);
    hand.now += 2.0;
    EXPECT_FALSE(whole.passed());
    EXPECT_FALSE(whole.was_felt());
    EXPECT_TRUE(part.passed());
    EXPECT_TRUE(whole.was_felt());
    EXPECT_FALSE(whole.passed());
}

TEST(Deadline, ExcludedSecondsNeverCount) {
    Hand hand;
    const Deadline whole = Deadline::after(5.0, hand.clock());
    const Deadline part = whole.sooner(1.0);
    hand.now += 3.0;
    part.leave_out(3.0);
    EXPECT_FALSE(part.passed());
    EXPECT_EQ(part.seconds_left(), 1.0);
    EXPECT_EQ(whole.seconds_left(), 5.0);
    EXPECT_FALSE(whole.was_felt());
    hand.now += 1.0;
    EXPECT_TRUE(part.passed());
    EXPECT_EQ(whole.sooner(2.0).seconds_left(), 2.0);
    Deadline().leave_out(1.0);  // nothing to leave out of
}

TEST(Deadline, PartOfNoneUsesSteadyClock) {
    EXPECT_TRUE(Deadline().sooner(0.0).passed());
    EXPECT_FALSE(Deadline().sooner(1e6).passed());
    EXPECT_GE(Stopwatch().seconds(), 0.0);
}

}  // namespace deadline_test
}  // namespace camopt
