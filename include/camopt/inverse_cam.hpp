// SPDX-License-Identifier: MIT
// Inverse cams: the guide that makes a feeder move as wished, and the check that pushes a roller through the
// finished guide. m, rad, s.
#pragma once

#include "core/language.hpp"
#include "profiles/inverse/guide_points.hpp"
#include "profiles/inverse/wished_guide.hpp"
#include "studies/inverse/inverse_forward.hpp"
