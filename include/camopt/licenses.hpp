// SPDX-License-Identifier: MIT
// Which libraries of others are in this build, and under what terms a binary of it may be passed on:
// licensed_parts(), terms_of_binary().
#pragma once

#include "core/language.hpp"
#include "core/licenses.hpp"
