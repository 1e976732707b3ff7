// SPDX-License-Identifier: MIT
// Everything known after a scene was solved: the motion, its peaks, limits and what they leave, the cam,
// what would help where nothing was found, the certificate. SI and radians; peaks without units. A Solution
// is a value: copies share their motions, which are constant.
#pragma once

#include "core/language.hpp"
#include "studies/delivered/solution.hpp"
