// SPDX-License-Identifier: MIT
// From the elastic follower train of a scene to its formulas: complete_dynamics(scene), once, before a scene
// built in C++ is solved. Throws InputError for a chain of more than four masses.
#pragma once

#include "core/language.hpp"
#include "dynamics/train_formulas.hpp"
