// SPDX-License-Identifier: MIT
// What can be said of a scene without solving it: which problem it becomes, how large it is, which verdict
// can come, and whether its derivatives agree with differences. Throws InputError for a wrong scene.
#pragma once

#include "core/language.hpp"
#include "studies/check/scene_check.hpp"
