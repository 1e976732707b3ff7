// SPDX-License-Identifier: MIT
// A solution as files: report, table of the motion, proof, pictures, profile. Files of an earlier run are
// replaced together. Display units (mm, degrees). Errors: InputError naming the folder or file.
#pragma once

#include "output/report/report.hpp"
#include "output/report/result_folder.hpp"
