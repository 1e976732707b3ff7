// SPDX-License-Identifier: MIT
// A scene: what must move, what counts, which limits hold, how fine the spline may be, and the cam. Plain
// values in SI and radians with the defaults of a scene file. find_fault(scene) says what is wrong with one;
// validate(scene) throws InputError with it. Every study validates what it is given.
//
// Scenes may be copied and read by several threads.
#pragma once

#include "core/language.hpp"
#include "scene/scene.hpp"
#include "scene/spellings.hpp"
