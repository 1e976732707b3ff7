// SPDX-License-Identifier: MIT
// The papers behind camopt computed again: their tables and figures beside the numbers found here.
#pragma once

#include "core/language.hpp"
#include "studies/papers/paper_catalogue.hpp"
