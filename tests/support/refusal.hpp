// SPDX-License-Identifier: MIT
// What a refused call says.
#pragma once

#include "core/errors.hpp"

#include <string>

namespace camopt::testing_support {

/// The message of the Error that `action` throws; "no refusal" where it throws none.
template <class Error = InputError>
std::string refusal(const auto& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no refusal";
}

}  // namespace camopt::testing_support
