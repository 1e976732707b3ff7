// SPDX-License-Identifier: MIT
// Motion and cam as CSV text: a header line, a point a row, display units, "." as decimal sign whatever the
// locale.
#pragma once

#include "core/language.hpp"
#include "output/csv/motion_csv.hpp"
