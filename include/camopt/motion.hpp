// SPDX-License-Identifier: MIT
// A motion y(x) with its first three derivatives, and its peaks.
//
//   x = cam angle / rise angle, y = displacement / lift, ' is d/dx; no units.
//   V = max |y'|, A = max |y''|, J = max |y'''|.
//
// Motion::at(x, side) gives a MotionPoint; outside [begin(), end()] it throws InputError. A Motion is never
// written to by a const call: threads may share one.
#pragma once

#include "core/language.hpp"
#include "core/motion.hpp"
#include "core/numbers/extremum.hpp"
#include "core/peaks.hpp"
