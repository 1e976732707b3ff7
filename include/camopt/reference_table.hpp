// SPDX-License-Identifier: MIT
// The published spline-versus-modified-sine tables beside what is true. Peaks without units.
#pragma once

#include "core/language.hpp"
#include "studies/papers/reference_table.hpp"
