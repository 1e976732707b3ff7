// SPDX-License-Identifier: MIT
// What a refused call says.
#pragma once

#include "core/errors.hpp"

#include <string>

namespace camopt::testing_support {

/// The message of the InputError that `action` throws; "no refusal" where it throws none.
inline std::string refusal(const auto& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "no refusal";
}

}  // namespace camopt::testing_support
