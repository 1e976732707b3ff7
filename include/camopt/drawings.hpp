// SPDX-License-Identifier: MIT
// Cams as DXF text: arcs within a tolerance (m) of the exact curve; files in mm. Errors: InputError for a
// tolerance that is not positive and a cam that is not finite.
#pragma once

#include "core/language.hpp"
#include "output/drawing/dxf/cam_dxf.hpp"
#include "output/report/cam_files.hpp"
