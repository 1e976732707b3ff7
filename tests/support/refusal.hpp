// SPDX-License-Identifier: MIT
// What a refused call says.
#pragma once

#include "core/errors.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace camopt::testing_support {

/// The message of the Error that `action` throws; `otherwise` where it throws none.
template <class Error = InputError>
std::string refusal(const auto& action, const char* otherwise = "no refusal") {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return otherwise;
}

/// Whether the text holds these words; a failure prints it.
[[nodiscard]] inline ::testing::AssertionResult says(std::string_view text, std::string_view words) {
    const bool found = text.find(words) != std::string_view::npos;
    return (found ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << '"' << text << '"';
}

}  // namespace camopt::testing_support
