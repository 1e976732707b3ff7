// SPDX-License-Identifier: MIT
// That the cam can be built at rest, where its dimensions move: each sum of CamMechanism::reach is a linear
// row of its own, where the ranges do not keep it anyhow.
#pragma once

#include "objectives/rules/model.hpp"
#include "scene/cam_spec.hpp"

namespace camopt {

/// After the cam's variables are in the model.
void add_reach_rows(CamModel& model, const CamSpec& spec);

}  // namespace camopt
