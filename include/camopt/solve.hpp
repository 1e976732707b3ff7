// SPDX-License-Identifier: MIT
// A scene goes in; the best motion comes out, with its exact peaks, the cam and the proof: solve(scene,
// control).
//
// Throws InputError for a wrong scene, UnavailableError for a backend this build leaves out. Every numerical
// outcome is a Verdict. Threads may solve at once, the same scene too; Ipopt's turns are taken one after
// another, all else runs side by side.
#pragma once

#include "core/language.hpp"
#include "scene/peak_units.hpp"
#include "studies/solve/solve.hpp"
