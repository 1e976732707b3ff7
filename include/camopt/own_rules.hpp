// SPDX-License-Identifier: MIT
// Cost terms and limits of your own, for Scene::own_terms and Scene::own_limits: any function of y to y'''.
#pragma once

#include "core/language.hpp"
#include "scene/own_rule.hpp"
