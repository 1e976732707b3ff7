// SPDX-License-Identifier: MIT
// The exceptions camopt throws: InputError (something the caller gave is wrong; the message says what was
// found and what is allowed), UnavailableError (an InputError: this build lacks what was asked for),
// ModelError (a broken model, a fault of who implements an interface). Numerical outcomes are enums, never
// exceptions.
#pragma once

#include "core/errors.hpp"
#include "core/language.hpp"
