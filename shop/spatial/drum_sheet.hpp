// SPDX-License-Identifier: MIT
// The workshop drawing of a drum: its outside developed, and the body.
//
// Developed: x = R ψ over z from the lower end, R the radius of the outside, ψ the angle around the drum from
// the place of the roller's near end at the datum, as the cam angle grows. Thick: both edges of the groove on
// the outside, of an indexing cam those of all its rollers; dashed: the way of the roller's axis where its
// near end stands. The table gives this way: z, and ψ where it is not the cam angle. The body: a section
// through its axis in the plane of the datum, the groove at the datum on the right; of an indexing cam the
// body as it is turned before the groove is milled.
#pragma once

#include "scene/cam_flanks.hpp"
#include "shop/sheet/sheet.hpp"

namespace camopt {

struct Solution;

/// motion: one turn. Throws InputError for a drum that is too large for any sheet, and for a body that does
/// not hold its groove or its bore.
[[nodiscard]] Sheet drum_sheet(const Solution& solution, const CamFlanks& cam, const FollowerMotion& motion,
                               const DrawingSpec& drawing);

}  // namespace camopt
