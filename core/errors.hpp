// SPDX-License-Identifier: MIT
// The exceptions camopt throws: wrong input and broken models. Numerical outcomes are enums, never
// exceptions.
#pragma once

#include "core/base/standard.hpp"

#include <stdexcept>

namespace camopt {

/// Invalid input from the user. The message says what was found and what is allowed.
class InputError : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// A capability that this build does not have; also invalid input.
class UnavailableError : public InputError {
 public:
    using InputError::InputError;
};

/// A model (Nlp, ContinuousProblem) violated its contract: sizes that do not match, a value that is not
/// finite.
class ModelError : public std::logic_error {
 public:
    using std::logic_error::logic_error;
};

}  // namespace camopt
