// SPDX-License-Identifier: MIT
// A solution and a comparison in words: the verdict in a sentence, limits, what would help. UTF-8, display
// units. Nothing throws.
#pragma once

#include "core/language.hpp"
#include "output/words/solution_text.hpp"
#include "output/words/study_text.hpp"
