// SPDX-License-Identifier: MIT
// That the cam can be built at rest, where its dimensions move (p = base + roller radius, a centre distance,
// l arm length, f face offset, e offset):
//   translating roller, knife: |e| < p        oscillating roller: |a − l| < p < a + l
//   oscillating flat: |base + f| < a
// Each side is linear in the dimensions: a row of its own, where the ranges do not keep it anyhow.
#pragma once

#include "objectives/model.hpp"
#include "scene/cam_spec.hpp"

namespace camopt {

/// After the cam's variables are in the model.
void add_reach_rows(CamModel& model, const CamSpec& spec);

}  // namespace camopt
