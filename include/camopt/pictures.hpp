// SPDX-License-Identifier: MIT
// Motion, cam and mechanism as SVG text, to scale where they show a machine.
#pragma once

#include "core/language.hpp"
#include "output/chart/curve_chart.hpp"
#include "output/drawing/mechanism_svg.hpp"
#include "output/drawing/profile_svg.hpp"
