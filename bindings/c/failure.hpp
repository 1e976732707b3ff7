// SPDX-License-Identifier: MIT
// The border to C: whatever is thrown behind it becomes an error code and a text of the thread.
#pragma once

#include "bindings/c/camopt.h"
#include "core/base/standard.hpp"

#include <stdexcept>

namespace camopt::c {

/// Ends a call of the C face with this code and text.
class Failure : public std::runtime_error {
 public:
    Failure(camopt_error code, const std::string& text) : std::runtime_error(text), code_(code) {}
    [[nodiscard]] camopt_error code() const { return code_; }

 private:
    camopt_error code_;
};

/// Throws Failure for a NULL. name: of the argument.
void require(const void* argument, const char* name);

/// The code of what is being thrown; its text becomes that of the thread. Only in a catch block.
[[nodiscard]] camopt_error code_of_exception() noexcept;

/// The text of the thread.
[[nodiscard]] const char* failure_text() noexcept;

/// Runs the work of one call.
template <class Work>
[[nodiscard]] camopt_error guarded(Work&& work) noexcept {
    try {
        std::forward<Work>(work)();
        return CAMOPT_OK;
    } catch (...) {
        return code_of_exception();
    }
}

}  // namespace camopt::c
