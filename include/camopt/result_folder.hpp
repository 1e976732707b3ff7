// SPDX-License-Identifier: MIT
// A solution as files (report, table of the motion, proof, pictures, profile), and read back without solving
// (read_result_folder). Files of an earlier run are replaced together. Display units (mm, degrees). Errors:
// InputError naming the folder or file, and what does not fit.
#pragma once

#include "core/language.hpp"
#include "output/report/report.hpp"
#include "output/report/result_folder.hpp"
