// SPDX-License-Identifier: MIT
// From the mechanism that a scene names to its formulas: complete_mechanism(scene), once, before a scene
// read from a file is solved. Throws InputError for a kind or a choice that does not exist.
#pragma once

#include "core/language.hpp"
#include "profiles/factory/mechanism_factory.hpp"
