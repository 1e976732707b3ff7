// SPDX-License-Identifier: MIT
// What was found, and the proof of it. For any multipliers λ and a box [l, u] that holds an optimum
//
//   f* >= constant − Σ λ_i b_i + Σ min(r_j l_j, r_j u_j),   r = c + Gᵀλ,
//
// so a proof is a list of numbers; recomputed_bound(proof) computes the bound from them again. Objectives
// are without units. Nothing throws.
#pragma once

#include "core/language.hpp"
#include "solvers/certificate/certificate.hpp"
