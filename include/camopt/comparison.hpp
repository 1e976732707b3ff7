// SPDX-License-Identifier: MIT
// Every classical law on one scene beside the optimum: what each loses, which limits it breaks, how large
// its cam would have to be. Units as in Solution; infinite peaks are infinite. Throws as solve() does.
#pragma once

#include "core/language.hpp"
#include "studies/compare/comparison.hpp"
#include "studies/compare/needed_base.hpp"
