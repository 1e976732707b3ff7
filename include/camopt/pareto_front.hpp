// SPDX-License-Identifier: MIT
// The trade-off of two figures of a scene, traced by limits instead of weights: min p + ε q subject to q <=
// cap. Also the front over the rows of a sweep.
#pragma once

#include "core/language.hpp"
#include "studies/pareto/pareto_front.hpp"
#include "studies/pareto/sweep_front.hpp"
