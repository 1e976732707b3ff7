// SPDX-License-Identifier: MIT
#include "tests/support/counted_assertions.hpp"

#include <atomic>

namespace camopt::test {
namespace {

std::atomic<int> counted = 0;

class DemandsAssertions final : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override { counted = 0; }
    void OnTestEnd(const testing::TestInfo& test) override {
        if (test.result()->Passed() && counted == 0) ADD_FAILURE() << "asserts nothing when it runs";
    }
};

[[maybe_unused]] const bool added = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new DemandsAssertions);
    return true;
}();

}  // namespace

int count_assertion() noexcept {
    ++counted;
    return 0;
}

}  // namespace camopt::test
