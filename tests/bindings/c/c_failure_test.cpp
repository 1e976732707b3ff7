// SPDX-License-Identifier: MIT
// The border to C by itself: what may be thrown behind it, and which code that is. Links failure.cpp, not the
// library.
#include "bindings/c/failure.hpp"
#include "core/errors.hpp"

#include <gtest/gtest.h>

#include <new>

namespace camopt::c {
namespace c_failure_test {

template <class Thrown>
void expect_code(const Thrown& thrown, camopt_error code, const char* text) {
    EXPECT_EQ(guarded([&] { throw thrown; }), code);
    EXPECT_STREQ(camopt_error_text(), text);
}

TEST(CFailure, EveryExceptionHasACode) {
    EXPECT_STREQ(camopt_error_text(), "");
    expect_code(Failure(CAMOPT_ERROR_CAPACITY, "too small"), CAMOPT_ERROR_CAPACITY, "too small");
    expect_code(InputError("wrong key"), CAMOPT_ERROR_INPUT, "wrong key");
    expect_code(UnavailableError("left out"), CAMOPT_ERROR_UNAVAILABLE, "left out");
    expect_code(ModelError("sizes differ"), CAMOPT_ERROR_INTERNAL, "sizes differ");
    expect_code(std::bad_alloc(), CAMOPT_ERROR_MEMORY, "no memory was left");
    expect_code(std::logic_error("a fault"), CAMOPT_ERROR_INTERNAL, "a fault");
    expect_code(42, CAMOPT_ERROR_INTERNAL, "an exception was thrown that is not a std::exception");
}

TEST(CFailure, LeavesTheTextWhereNothingFails) {
    expect_code(InputError("before"), CAMOPT_ERROR_INPUT, "before");
    EXPECT_EQ(guarded([] {}), CAMOPT_OK);
    EXPECT_STREQ(camopt_error_text(), "before");
    EXPECT_EQ(guarded([] { require(nullptr, "scene"); }), CAMOPT_ERROR_NULL);
    EXPECT_STREQ(camopt_error_text(), "scene: found NULL; allowed: a pointer to it");
}

}  // namespace c_failure_test
}  // namespace camopt::c
