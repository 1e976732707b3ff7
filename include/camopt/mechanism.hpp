// SPDX-License-Identifier: MIT
// Any mechanism between a cam and its output, as the optimizer sees it: from one state (s, s', s'') of the
// output and the mechanism's dimensions to the quantities that limits are made of, with exact partials.
// scene.cam is the cam of a scene, of any kind. Implement CamMechanism to bring one of your own. m,
// rad, s' and s'' by the cam angle. Out of reach is NaN, never a throw; calls are const and may come from
// several threads at once.
#pragma once

#include "core/language.hpp"
#include "scene/cam_mechanism.hpp"
#include "studies/delivered/driven_mechanism.hpp"
