// SPDX-License-Identifier: MIT
// Flanks and solids of cams as STL, OBJ and (where this build has Open CASCADE: step_available()) STEP. m
// inside, mm in files. Errors: UnavailableError for STEP in a build without it.
#pragma once

#include "core/language.hpp"
#include "output/spatial/cam_export.hpp"
#include "output/surface/mesh_files.hpp"
#include "output/surface/step/step_file.hpp"
