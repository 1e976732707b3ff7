// SPDX-License-Identifier: MIT
// The cam can be built at rest, where its dimensions are variable: each sum of CamMechanism::reach is a
// linear row, unless the ranges imply it.
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/cam_spec.hpp"

namespace camopt {

/// After the cam's variables are in the model.
void add_reach_rows(CamModel& model, const CamSpec& spec);

}  // namespace camopt
