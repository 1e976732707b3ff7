// SPDX-License-Identifier: MIT
// The kinds of cams a scene file can name, and one of your own beside them: add_cam_kind() with a CamKind
// that describes its keys and makes its formulas (camopt/mechanism.hpp).
#pragma once

#include "core/language.hpp"
#include "profiles/kinds/cam_kinds.hpp"
