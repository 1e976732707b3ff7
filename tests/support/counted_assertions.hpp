// SPDX-License-Identifier: MIT
// GoogleTest with counted assertions: a case that passes without one has failed. Every source of a test
// program is compiled with this header (cmake/CamoptTests.cmake). GoogleTest keeps no count; its assertions
// begin with the macro GTEST_AMBIGUOUS_ELSE_BLOCKER_, "switch (0) case 0: default:", which counts here.
#pragma once

#include <gtest/gtest.h>

#ifndef GTEST_AMBIGUOUS_ELSE_BLOCKER_
#error "this GoogleTest begins its assertions otherwise: no case would be seen to assert"
#endif

namespace camopt::test {

/// Counts one assertion of the case that runs; 0.
int count_assertion() noexcept;

}  // namespace camopt::test

#undef GTEST_AMBIGUOUS_ELSE_BLOCKER_
#define GTEST_AMBIGUOUS_ELSE_BLOCKER_          \
    switch (::camopt::test::count_assertion()) \
    case 0:                                    \
    default:  // NOLINT
