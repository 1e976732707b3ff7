// SPDX-License-Identifier: MIT
// Factors from display units to SI: 3.0 * units::millimetre is 0.003 m, 90 * units::degree is π/2 rad.
// Everything behind these headers is in m, rad, s, kg, N unless its comment says otherwise.
#pragma once

#include "core/language.hpp"
#include "core/units.hpp"
