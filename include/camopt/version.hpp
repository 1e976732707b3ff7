// SPDX-License-Identifier: MIT
// The version of this camopt, "MAJOR.MINOR.PATCH".
#pragma once

#include "core/language.hpp"
#include "core/version.hpp"
