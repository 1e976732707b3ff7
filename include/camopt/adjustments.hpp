// SPDX-License-Identifier: MIT
// What a user could change about a scene without a motion, one number at a time, and the search for the
// least change of each (explain(solution, control); solve() does it already where it finds nothing).
#pragma once

#include "core/language.hpp"
#include "studies/explain/adjustment.hpp"
#include "studies/explain/relaxation.hpp"
